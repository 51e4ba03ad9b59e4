//! The area in which the cue ball in hand may be put down, drawn on the cloth.

use bevy::prelude::*;
use glam::DVec2;

use crate::game::replay::Replay;
use crate::game::rules::Area;
use crate::game::turns::Turns;
use crate::sim::clock::Clock;

/// Height of the line above the slate, m.
const ABOVE: f32 = 0.002;
/// Corners of a half circle.
const CORNERS: u32 = 32;

fn corners(area: &Area) -> Vec<DVec2> {
    match *area {
        Area::Rectangle { least, most } => vec![
            least,
            DVec2::new(most.x, least.y),
            most,
            DVec2::new(least.x, most.y),
            least,
        ],
        Area::HalfDisc { center, radius } => {
            let mut corners: Vec<DVec2> = (0..=CORNERS)
                .map(|i| {
                    let angle = std::f64::consts::PI * (0.5 + f64::from(i) / f64::from(CORNERS));
                    center + radius * DVec2::new(libm::cos(angle), libm::sin(angle))
                })
                .collect();
            corners.push(corners[0]);
            corners
        }
    }
}

/// Draws the area while a person has the cue ball in hand.
pub(super) fn draw(turns: Res<Turns>, replay: Res<Replay>, clock: Res<Clock>, mut gizmos: Gizmos) {
    let Some(game) = turns.game() else { return };
    if clock.moving || replay.is_active() || !turns.may_strike() {
        return;
    }
    let Some(area) = game.targets().in_hand else {
        return;
    };
    let line = corners(&area);
    let line = line
        .iter()
        .map(|corner| Vec3::new(corner.x as f32, ABOVE, corner.y as f32));
    gizmos.linestrip(line, Color::srgb(0.95, 0.85, 0.4));
}
