//! H6: near misses. A hit that is `d` deep has a normal speed of √(d/R) v, so that 1e-12 m decide between nothing and
//! 1e-5 m/s. H12: fast balls and thin targets.

use glam::DVec3;

use crate::physics::laws::Laws;
use crate::physics::record::{EventKind, Record};
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::report::judge::hard::{By, Claim, Rows, put, smooth, worst};
use crate::report::judge::stand::{Stand, room, smooth as balls};
use crate::sim::play::Stopped;

/// A ball along x that passes another `depth` nearer than touching.
fn pass(laws: Laws, depth: f64) -> Scene {
    let mut scene = room(laws);
    let beside = 2.0 * Stand::POOL.ball.radius - depth;
    put(
        &mut scene,
        "cue",
        -0.3,
        -beside,
        DVec3::X * 2.0,
        DVec3::ZERO,
    );
    put(&mut scene, "1", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
    scene.time_limit = 1.0;
    scene
}

fn hits(record: &Record) -> usize {
    let met = |kind: EventKind| kind == EventKind::BallBall;
    record.events.iter().filter(|event| met(event.kind)).count()
}

/// Relative error of the speed that a hit of this depth gives, in units of what rounding of the depth allows; NaN for a miss.
fn graze(by: By, laws: Laws, depth: f64) -> Result<f64, Stopped> {
    let record = by.play(&pass(laws, depth))?;
    let hit = record
        .events
        .iter()
        .find(|event| event.kind == EventKind::BallBall);
    let find = |ball: usize| hit.and_then(|hit| hit.participants().find(|one| one.ball == ball));
    let (Some(cue), Some(object)) = (find(0), find(1)) else {
        return Ok(f64::NAN);
    };
    let share = 1.0 - depth / (2.0 * Stand::POOL.ball.radius);
    let wanted = cue.before.velocity.length() * (1.0 - share * share).sqrt();
    let error = (object.after.velocity.length() / wanted - 1.0).abs();
    // Seen from 0.3 m away the depth carries some 1e-16 m of rounding.
    Ok(error / (1e-12 + 3e-16 / depth))
}

pub(super) fn tangency() -> Rows {
    let mut rows = Vec::new();
    for by in By::BOTH {
        let cloth = Laws {
            ball_ball: balls(1.0),
            ..Laws::default()
        };
        for (name, laws) in [("no cloth", smooth(1.0, 1.0)), ("cloth", cloth)] {
            let (mut errors, mut beyond) = (Vec::new(), 0);
            for exponent in 3..=12 {
                let depth = libm::pow(10.0, -f64::from(exponent));
                errors.push(graze(by, laws, depth)?);
                beyond += hits(&by.play(&pass(laws, -depth))?);
            }
            let error = worst(errors);
            let claim = Claim::new(
                "H6",
                format!("past a ball by ±1e-3 to ±1e-12 m, {name}"),
                by.name(),
                "speed √(d/R) to rounding of d, no hit beyond",
            );
            rows.push(claim.fact(
                error <= 1.0 && beyond == 0,
                format!("{error:.2} of what rounding allows, {beyond} hits beyond"),
            ));
        }
    }
    Ok(rows)
}

pub(super) fn fast() -> Rows {
    let mut rows = Vec::new();
    let ticks = [None, Some(1.0 / 30.0), Some(1.0 / 120.0), Some(1e-3)];
    for tick in ticks {
        let (mut missed, mut shots) = (0, 0);
        for speed in [0.5, 2.0, 13.0, 30.0, 300.0] {
            for offset in [0.0, 0.02, 0.0571] {
                let mut scene = room(smooth(1.0, 1.0));
                put(
                    &mut scene,
                    "cue",
                    -10.0,
                    offset,
                    DVec3::X * speed,
                    DVec3::ZERO,
                );
                put(&mut scene, "thin", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
                scene.time_limit = 11.0 / speed;
                if let Some(tick) = tick {
                    scene.solver = Solver::Stepped(Stepped {
                        tick,
                        ..Stepped::default()
                    });
                }
                let record = crate::sim::play::play(&scene)?;
                shots += 1;
                missed += usize::from(hits(&record) != 1);
            }
        }
        let solver = tick.map_or_else(
            || By::Exact.name().to_owned(),
            |tick| format!("stepped, {:.0} Hz", 1.0 / tick),
        );
        let claim = Claim::new(
            "H12",
            "10 m to a ball at 0.5 to 300 m/s, to 50 µm off its edge",
            solver,
            "meets it once",
        );
        rows.push(claim.fact(missed == 0, format!("{missed} of {shots} otherwise")));
    }
    Ok(rows)
}
