//! The painted surface of a ball.

use bevy::prelude::*;

use crate::window::render::balls::numeral::Numeral;
use crate::window::render::balls::palette::{Colour, IVORY, Marking};
use crate::window::render::paint::{Paint, paint};

/// Size of a ball's texture: once around by from pole to pole.
const SIZE: (u32, u32) = (1024, 512);

/// Half the width of a stripe, as the sine of its latitude.
const STRIPE: f32 = 0.54;

/// Radius of the circle around a number, in R.
const CIRCLE: f32 = 0.40;

/// Radius of a dot, in R.
const DOT: f32 = 0.115;

/// Half the width of a line of a pattern, in R.
const LINE: f32 = 0.035;

/// Paints a ball, with a pattern if it shall have one. Numbers sit on +x and −x, a stripe runs around the y axis.
pub(super) fn skin(
    colour: Colour,
    marking: Marking,
    pattern: (u32, u32),
    finer: u32,
    anisotropy: u16,
) -> Image {
    let numeral = match marking {
        Marking::Solid(number) | Marking::Stripe(number) => Some(Numeral::new(number)),
        Marking::Dots => None,
    };
    let size = (SIZE.0 << finer, SIZE.1 << finer);
    paint(Paint::Colour, size, anisotropy, |u, v| {
        let direction = direction(u, v);
        let ink = if light(colour) > 0.3 {
            [0.02, 0.02, 0.025]
        } else {
            IVORY
        };
        let colour = mix(colour, ink, on_pattern(pattern, direction, u));
        let mut paint = colour;
        match marking {
            Marking::Stripe(_) => {
                paint = mix(IVORY, colour, soft(STRIPE - direction.y.abs(), 0.004));
            }
            Marking::Solid(_) => {}
            Marking::Dots => {
                let dot = if light(colour) > 0.5 {
                    [0.72, 0.05, 0.07]
                } else {
                    IVORY
                };
                let away = direction.abs().max_element();
                let radius = (1.0 - away * away).max(0.0).sqrt();
                paint = mix(colour, dot, soft(DOT - radius, 0.006));
            }
        }
        let Some(numeral) = &numeral else {
            return paint;
        };
        // Seen from outside, right is −z on the +x side and +z on the −x side.
        let (right, up) = (-direction.z * direction.x.signum(), direction.y);
        let radius = libm::hypotf(right, up);
        paint = mix(paint, IVORY, soft(CIRCLE - radius, 0.005));
        let ink = numeral.at(right / (0.78 * CIRCLE), up / (0.78 * CIRCLE));
        mix(paint, [0.02, 0.02, 0.025], ink)
    })
}

/// The point of the unit sphere with these texture coordinates. The globe's mesh uses it too.
pub(super) fn direction(u: f32, v: f32) -> Vec3 {
    let longitude = std::f32::consts::TAU * u;
    let latitude = std::f32::consts::PI * (0.5 - v);
    let (up, around) = libm::sincosf(latitude);
    let (z, x) = libm::sincosf(longitude);
    Vec3::new(around * x, up, around * z)
}

/// How much of a pattern's line covers a point, 0 to 1.
fn on_pattern((rings, lines): (u32, u32), direction: Vec3, u: f32) -> f32 {
    // Within the band of a stripe, so that a solid and its stripe show the same.
    let gap = 2.0 * STRIPE / (rings + 1) as f32;
    let ring = (1..=rings)
        .map(|i| (direction.y + STRIPE - gap * i as f32).abs())
        .fold(f32::INFINITY, f32::min);
    let around = libm::hypotf(direction.x, direction.z);
    let turn = (u * lines as f32 + 0.5).rem_euclid(1.0) - 0.5;
    let line = if lines > 0 {
        turn.abs() / lines as f32 * std::f32::consts::TAU * around
    } else {
        f32::INFINITY
    };
    soft(LINE - ring.min(line), 0.006)
}

fn light(colour: Colour) -> f32 {
    colour.into_iter().sum::<f32>() / 3.0
}

fn mix(a: Colour, b: Colour, share: f32) -> Colour {
    [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]))
}

/// 0 below zero, 1 above, over `width` to both sides.
fn soft(x: f32, width: f32) -> f32 {
    (0.5 + 0.5 * x / width).clamp(0.0, 1.0)
}
