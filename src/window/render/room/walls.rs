//! What hangs on the walls and stands before them, as colours: a bar with bottles, windows at dusk, pictures, panels.
//! One function paints the walls and lights the mirrors.

use bevy::prelude::*;

use crate::window::render::paint::Noise;
use crate::window::render::room::bottles;
use crate::window::render::table::FLOOR;

/// Half the length and width of the room, m.
pub(in crate::window::render) const HALF: Vec2 = Vec2::new(4.7, 3.7);

/// Height of the ceiling above the floor, m.
pub(in crate::window::render) const HIGH: f32 = 2.95;

/// One side of the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::window::render) enum Side {
    /// Towards +x, behind the foot of the table: the bar.
    Foot,
    /// Towards −x: a rack of cues.
    Head,
    /// Towards +z: pictures.
    Right,
    /// Towards −z: windows.
    Left,
}

impl Side {
    pub const ALL: [Self; 4] = [Self::Foot, Self::Head, Self::Right, Self::Left];

    /// Half its length, m.
    pub fn half(self) -> f32 {
        match self {
            Self::Foot | Self::Head => HALF.y,
            Self::Right | Self::Left => HALF.x,
        }
    }

    /// The point this far along the wall and above the floor, m.
    pub fn point(self, along: f32, up: f32) -> Vec3 {
        let y = up - FLOOR as f32;
        match self {
            Self::Foot => Vec3::new(HALF.x, y, along),
            Self::Head => Vec3::new(-HALF.x, y, -along),
            Self::Right => Vec3::new(-along, y, HALF.y),
            Self::Left => Vec3::new(along, y, -HALF.y),
        }
    }
}

/// What an eye a little above the table sees in a direction: linear, 1 is as bright as the screen gets.
pub(in crate::window::render) fn seen_towards(direction: Vec3) -> Vec3 {
    let eye = 0.1 + FLOOR as f32;
    let reach = |way: f32, room: f32| {
        if way.abs() < 1e-5 {
            f32::INFINITY
        } else {
            room / way.abs()
        }
    };
    let (x, z) = (reach(direction.x, HALF.x), reach(direction.z, HALF.y));
    let room = if direction.y > 0.0 { HIGH - eye } else { eye };
    let y = reach(direction.y, room);
    if y < x.min(z) {
        let away = (y * Vec2::new(direction.x, direction.z)).length();
        return if direction.y > 0.0 {
            ceiling(away)
        } else {
            Vec3::new(0.030, 0.018, 0.010) / (1.0 + 0.3 * away * away)
        };
    }
    let up = eye + x.min(z) * direction.y;
    let (side, along) = match (x < z, direction.x > 0.0, direction.z > 0.0) {
        (true, true, _) => (Side::Foot, x * direction.z),
        (true, false, _) => (Side::Head, -x * direction.z),
        (false, _, true) => (Side::Right, -z * direction.x),
        (false, _, false) => (Side::Left, z * direction.x),
    };
    wall(side, along, up)
}

/// The ceiling this far from above the middle of the table.
fn ceiling(away: f32) -> Vec3 {
    Vec3::new(0.055, 0.045, 0.034) / (1.0 + 0.25 * away * away) + Vec3::splat(0.004)
}

/// A point of a wall this far along it and above the floor, m.
pub(in crate::window::render) fn wall(side: Side, along: f32, up: f32) -> Vec3 {
    let noise = Noise::new(3 + side as u32);
    let place = (
        (0.5 + 0.5 * along / side.half()).rem_euclid(1.0),
        (up / HIGH).rem_euclid(1.0),
    );
    let (sconces, reach): (&[f32], f32) = match side {
        Side::Foot => (&[-2.9, 2.9], 0.55),
        Side::Head => (&[-2.4, 0.0, 2.4], 0.6),
        Side::Right => (&[-3.1, -1.05, 1.05, 3.1], 0.6),
        Side::Left => (&[-3.6, 0.0, 3.6], 0.6),
    };
    let lit = sconces
        .iter()
        .map(|at| sconce(along - at, up - 1.75, reach))
        .sum::<f32>();
    // What the lamp over the table spills upon the walls, and the dark below the ceiling.
    let spill = 0.16 + 0.10 * bump(up, 0.9, 0.8);
    let light = Vec3::new(1.0, 0.72, 0.42) * lit + Vec3::splat(spill);
    let mut colour = if up < 1.02 {
        wainscot(along, up, &noise, place)
    } else {
        let cloth = noise.sum(place, (64, 32), 3);
        let stripe = 0.5 + 0.5 * libm::sinf(along * 34.0);
        Vec3::new(0.055, 0.085, 0.072) * (0.85 + 0.12 * stripe + 0.10 * cloth)
    } * light;
    let extra = match side {
        Side::Foot => bottles::painted(along, up),
        Side::Head => cues(along, up, light),
        Side::Right => pictures(along, up, &noise, place),
        Side::Left => windows(along, up, &noise, place),
    };
    if let Some(extra) = extra {
        colour = extra;
    }
    for at in sconces {
        let (x, y) = ((along - at) / 0.075, (up - 1.75) / 0.13);
        let shade = smooth(1.0 - x * x - y * y, 0.25);
        colour = colour.lerp(Vec3::new(1.0, 0.78, 0.46), shade);
    }
    colour
}

/// Light of a lamp on the wall, up and down from it.
fn sconce(x: f32, y: f32, reach: f32) -> f32 {
    let spread = 0.28 + 0.55 * y.abs();
    let beam = libm::expf(-(x * x) / (spread * spread)) / (1.0 + (y / reach) * (y / reach));
    1.5 * beam / (1.0 + 1.2 * (x * x + y * y))
}

/// Panels of dark wood.
fn wainscot(along: f32, up: f32, noise: &Noise, place: (f32, f32)) -> Vec3 {
    let grain = noise.sum((place.1, place.0), (8, 96), 3);
    let wood = Vec3::new(0.105, 0.042, 0.020) * (1.0 + 0.35 * grain);
    if up > 0.94 {
        // The rail on top catches light.
        return wood * (1.0 + 1.4 * bump(up, 1.0, 0.02));
    }
    let x = (along / 0.82 + 0.5).rem_euclid(1.0) - 0.5;
    let inside = ((0.37 - x.abs()) * 0.82).min(up - 0.16).min(0.84 - up);
    let edge = bump(inside, 0.0, 0.012);
    // Light from above: the lower edge of a panel shines, the upper one is dark.
    let tilt = if up > 0.5 { -0.55 } else { 0.9 };
    wood * (1.0 + tilt * edge) * if inside > 0.0 { 1.12 } else { 0.9 }
}

/// Cues in a rack.
fn cues(along: f32, up: f32, light: Vec3) -> Option<Vec3> {
    let x = along - 1.2;
    if x.abs() > 0.55 || !(0.35..2.05).contains(&up) {
        return None;
    }
    let board = (up - 0.45).abs() < 0.06 || (up - 1.5).abs() < 0.05;
    let cell = (x / 0.11).round();
    let thick = 0.016 - 0.005 * (up - 0.4);
    if (x - 0.11 * cell).abs() < thick && up < 1.9 && cell.abs() < 4.5 {
        let wood = if up < 0.95 {
            Vec3::new(0.10, 0.025, 0.014)
        } else {
            Vec3::new(0.55, 0.36, 0.17)
        };
        let round = 1.0 - libm::powf((x - 0.11 * cell) / thick, 2.0);
        return Some(wood * light * (0.3 + 0.8 * round));
    }
    board.then_some(Vec3::new(0.09, 0.036, 0.017) * light)
}

/// Framed pictures, each with a small lamp of its own.
fn pictures(along: f32, up: f32, noise: &Noise, place: (f32, f32)) -> Option<Vec3> {
    for (at, half) in [(-2.1, 0.52), (0.0, 0.74), (2.1, 0.52)] {
        let (x, y) = ((along - at) / half, (up - 1.78) / 0.46);
        let out = x.abs().max(y.abs());
        if out > 1.12 {
            continue;
        }
        let lit = 0.30 + 0.9 * libm::expf(-(1.0 - y) * 1.4);
        if out > 1.0 {
            return Some(Vec3::new(0.34, 0.20, 0.06) * lit);
        }
        // A landscape: hills before an evening sky.
        let hill = 0.35 * noise.sum((place.0, 0.3), (24, 4), 3) - 0.15;
        let sky = Vec3::new(0.30, 0.22, 0.13).lerp(Vec3::new(0.09, 0.13, 0.20), 0.5 + 0.5 * y);
        let land = Vec3::new(0.045, 0.06, 0.02) * (1.0 + 0.5 * noise.octave(place, (128, 64)));
        return Some(sky.lerp(land, smooth(hill - y, 0.03)) * lit);
    }
    None
}

/// Windows: dusk, and the lights of a town.
fn windows(along: f32, up: f32, noise: &Noise, place: (f32, f32)) -> Option<Vec3> {
    for at in [-1.85, 1.85] {
        let (x, y) = ((along - at) / 0.68, (up - 1.75) / 0.80);
        let out = x.abs().max(y.abs());
        if out > 1.10 {
            continue;
        }
        let bars = (x.abs() < 0.035) || ((y - 0.25).abs() < 0.03);
        if out > 1.0 || bars {
            return Some(Vec3::new(0.05, 0.04, 0.034));
        }
        let high = 0.5 + 0.5 * y;
        let mut sky =
            Vec3::new(0.42, 0.24, 0.16).lerp(Vec3::new(0.06, 0.13, 0.32), smooth(high - 0.35, 0.4));
        let roof = 0.30 + 0.12 * noise.octave((place.0, 0.7), (96, 4)).signum();
        if high < roof {
            sky = Vec3::new(0.012, 0.013, 0.02);
            if noise.octave(place, (512, 160)) > 0.62 {
                sky = Vec3::new(0.60, 0.40, 0.14);
            }
        }
        return Some(0.8 * sky);
    }
    None
}

/// 1 at `at`, fading over `width` to both sides.
pub(super) fn bump(x: f32, at: f32, width: f32) -> f32 {
    let t = (x - at) / width;
    libm::expf(-t * t)
}

/// From 0 to 1 as `x` passes 0, over `width` to both sides.
pub(super) fn smooth(x: f32, width: f32) -> f32 {
    let t = (0.5 + 0.5 * x / width).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_looks_the_same_from_the_table_and_by_its_own_measure() {
        let eye = Vec3::Y * 0.1;
        for side in Side::ALL {
            for (along, up) in [(0.3, 1.4), (-1.7, 2.0), (1.9, 0.5)] {
                let towards = (side.point(along, up) - eye).normalize();
                let (seen, painted) = (seen_towards(towards), wall(side, along, up));
                assert!(seen.distance(painted) < 0.05, "{side:?} {seen} {painted}");
            }
        }
    }

    #[test]
    fn nothing_is_brighter_than_the_screen_or_darker_than_black() {
        for side in Side::ALL {
            for i in 0..60 {
                for j in 0..40 {
                    let along = side.half() * (i as f32 / 30.0 - 1.0);
                    let colour = wall(side, along, HIGH * j as f32 / 40.0);
                    assert!(colour.min_element() >= 0.0 && colour.max_element() < 1.5);
                }
            }
        }
    }
}
