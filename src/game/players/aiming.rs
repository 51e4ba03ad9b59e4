//! From a wish to a stroke: which heading sends a ball along its lane with this speed and this tip, and how high the cue
//! must be held.

use crate::game::players::chance::Lane;
use crate::game::players::rehearsal::Rehearsal;
use crate::game::players::sight::{angle, plan, wrapped};
use crate::physics::cue::Shot;
use crate::physics::cue_path;
use crate::physics::scene::Scene;

/// Elevations that are tried for a cue that is free, rad apart.
const LIFT_STEP: f64 = 0.015;

/// Rehearsals with which a heading is corrected at most.
const CORRECTIONS: u32 = 5;

/// The stroke with its cue raised to the next elevation at which it touches nothing; as it is if there is none.
#[must_use]
pub fn raised(scene: &Scene, ball: usize, shot: &Shot) -> Shot {
    let mut raised = *shot;
    while raised.elevation < cue_path::STEEPEST {
        if cue_path::obstacle(scene, ball, &raised).is_none() {
            return raised;
        }
        raised.elevation += LIFT_STEP;
    }
    *shot
}

/// The heading in rad of the straight way to the ghost ball.
#[must_use]
pub fn ghost_heading(scene: &Scene, cue: usize, lane: &Lane) -> f64 {
    -angle(lane.ghost - plan(scene.balls[cue].state.position))
}

/// The heading that sends the ball of a lane along it: the ghost ball's, corrected for throw, squirt and swerve by
/// rehearsals (secant rule). `None` if none is found.
pub fn heading(rehearsal: &mut Rehearsal, cue: usize, lane: &Lane, shot: &Shot) -> Option<f64> {
    let at = plan(rehearsal.scene().balls[cue].state.position);
    let way = lane.ghost - at;
    let normal = lane.from - lane.ghost;
    let cosine = (way.dot(normal) / (way.length() * normal.length()).max(1e-12)).max(0.15);
    let mut slope = (way.length() / (normal.length() * cosine)).max(0.3);
    let mut shot = *shot;
    let (mut best, mut last): (Option<(f64, f64)>, Option<(f64, f64)>) = (None, None);
    let full = -angle(lane.from - at);
    for _ in 0..CORRECTIONS {
        let Some(hit) = rehearsal
            .hit(cue, &shot)
            .filter(|hit| hit.ball == lane.ball)
        else {
            // Past the ball: nearer to a full hit.
            shot.heading += 0.3 * wrapped(full - shot.heading);
            last = None;
            continue;
        };
        let error = wrapped(angle(hit.velocity) - lane.angle);
        if best.is_none_or(|(least, _)| error.abs() < least) {
            best = Some((error.abs(), shot.heading));
        }
        if error.abs() < 0.02 * lane.half {
            break;
        }
        if let Some((heading, before)) = last {
            let measured = (error - before) / wrapped(shot.heading - heading);
            if measured.is_finite() && measured > 0.2 * slope && measured < 5.0 * slope {
                slope = measured;
            }
        }
        last = Some((shot.heading, error));
        shot.heading -= error / slope;
    }
    best.filter(|(error, _)| *error < 0.5 * lane.half)
        .map(|(_, heading)| heading)
}
