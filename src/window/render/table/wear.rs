//! What play leaves on a cloth: tracks, burnt specks, chalk.

use bevy::prelude::*;

use crate::window::render::paint::{Noise, Paint, paint};
use crate::window::render::quality::RenderQuality;

/// A track or a speck: from, to, half its width, how much lighter it is. Places are shares of half the cloth along and
/// half of its width across, from −1 to 1.
struct Mark {
    from: Vec2,
    to: Vec2,
    width: f32,
    light: f32,
}

/// The wear of a whole cloth: how light it is (½ is as new), and how much chalk lies on it.
pub(super) fn map(quality: RenderQuality) -> Image {
    let noise = Noise::new(97);
    let marks = marks();
    let finer = quality.finer();
    let size = (1024 << finer, 512 << finer);
    // Only marks near a row are looked at in it.
    paint(Paint::Shares, size, quality.anisotropy(), |u, v| {
        let at = Vec2::new(2.0 * u - 1.0, 2.0 * v - 1.0);
        let mut light = 0.5
            + 0.030 * noise.sum((u, v), (6, 3), 4)
            + 0.010 * noise.sum((u, v), (8, 160), 2)
            + 0.016 * noise.octave((u, v), (384, 192));
        for mark in &marks {
            if (at.y - mark.from.y).abs().min((at.y - mark.to.y).abs()) < 0.2
                || (at.y - mark.from.y) * (at.y - mark.to.y) < 0.0
            {
                light += mark.at(at);
            }
        }
        // Balls run along the cushions, a radius away from them.
        let rail = [1.0 - 0.0225 - at.x.abs(), 0.5 * (1.0 - 0.045 - at.y.abs())];
        for away in rail {
            light += 0.035 * bump(away, 0.006);
        }
        // Hands and chalk: around the head string and before the pockets.
        let dust = 0.30 * bump(at.x + 0.55, 0.28) * bump(at.y, 0.8);
        let pocket = [(1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| {
                let off = Vec2::new(at.x.abs() - x, 0.5 * (at.y.abs() - y));
                bump(off.length(), 0.10)
            })
            .into_iter()
            .fold(0.0, f32::max);
        let cloud = 0.5 + 0.5 * noise.sum((u, v), (16, 8), 3);
        let speck = (noise.octave((u, v), (420, 210)) - 0.78).max(0.0) * 3.2;
        let chalk = (dust + 0.32 * pocket + 0.06) * cloud * (0.28 + speck);
        [light - 0.05 * pocket, chalk.min(1.0), 0.0]
    })
}

/// Tracks of breaks, specks where balls have lain and bounced.
fn marks() -> Vec<Mark> {
    let mut seed = 0x2545_f491_u32;
    let mut chance = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as f32 / (1 << 24) as f32
    };
    let mut marks = Vec::new();
    for _ in 0..9 {
        let from = Vec2::new(-0.52 + 0.05 * chance(), 0.5 * (chance() - 0.5));
        marks.push(Mark {
            from,
            to: Vec2::new(0.47, 0.02 * (chance() - 0.5)),
            width: 0.0045,
            light: 0.012 + 0.012 * chance(),
        });
    }
    // Where the balls of a rack lie.
    let (radius, row) = (0.0225_f32, 0.0225 * 1.732);
    for rank in 0..5_u8 {
        for place in 0..=rank {
            let y = (f32::from(place) - 0.5 * f32::from(rank)) * 2.0 * radius;
            let at = Vec2::new(0.5 + f32::from(rank) * row, 2.0 * y);
            marks.push(Mark {
                from: at,
                to: at,
                width: 0.0045,
                light: -0.05,
            });
        }
    }
    for _ in 0..46 {
        let at = Vec2::new(1.9 * (chance() - 0.5), 1.8 * (chance() - 0.5));
        let way = Vec2::from_angle(6.3 * chance()) * 0.03 * chance() * chance();
        marks.push(Mark {
            from: at,
            to: at + way,
            width: 0.0022,
            light: 0.10 * chance(),
        });
    }
    marks
}

impl Mark {
    fn at(&self, place: Vec2) -> f32 {
        // One unit across is half as long as one along.
        let even = Vec2::new(1.0, 0.5);
        let (from, way) = (self.from * even, (self.to - self.from) * even);
        let off = place * even - from;
        let share = (off.dot(way) / way.length_squared().max(1e-9)).clamp(0.0, 1.0);
        let distance = (off - share * way).length();
        if distance > 4.0 * self.width {
            return 0.0;
        }
        self.light * bump(distance, self.width)
    }
}

/// 1 at zero, fading over `width` to both sides.
fn bump(x: f32, width: f32) -> f32 {
    let t = x / width;
    libm::expf(-t * t)
}
