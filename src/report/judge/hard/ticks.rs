//! H14: what the length of a tick does to the stepped solver, beside the exact one; and what the length of a frame does
//! to the exact one.

use glam::DVec3;

use crate::physics::ball::State;
use crate::physics::cue::Shot;
use crate::physics::exact::{Engine, Limits};
use crate::physics::laws::Laws;
use crate::physics::scene::{PlannedShot, Rack, Scene, Solver, Stepped};
use crate::physics::table::Preset;
use crate::report::judge::hard::{Claim, Hard, Rows};
use crate::report::judge::stand::Stand;
use crate::sim::play::{Stopped, play};

/// Ticks a second.
const LADDER: [u32; 5] = [60, 120, 240, 480, 960];

/// Shots over which the error is averaged.
const STARTS: u32 = 20;

/// A half-ball hit and a cushion within a second, `start` metres earlier or later, so that the tick falls anywhere around
/// the contacts.
fn shot(start: f64, solver: Solver) -> Scene {
    let ball = Stand::POOL.ball;
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.place("cue", ball, 0.6 - start, 0.1);
    scene.place("1", ball, 0.95, 0.1 + ball.radius);
    scene.balls[0].state.velocity = DVec3::X * 2.0;
    scene.time_limit = 1.0;
    scene.solver = solver;
    scene
}

/// The mean error in m of the places of both balls.
fn error(ticks: u32, locate: bool) -> Result<f64, Stopped> {
    let mut sum = 0.0;
    for start in 0..STARTS {
        let start = 0.05 * f64::from(start) / f64::from(STARTS);
        let truth = play(&shot(start, Solver::Exact))?;
        let stepped = play(&shot(
            start,
            Solver::Stepped(Stepped {
                tick: 1.0 / f64::from(ticks),
                locate,
                ..Stepped::default()
            }),
        ))?;
        for (stepped, exact) in stepped.end.iter().zip(&truth.end) {
            sum += (stepped.position - exact.position).length();
        }
    }
    Ok(sum / f64::from(2 * STARTS))
}

/// The slope of log error against log tick, by least squares.
fn order(errors: &[f64]) -> f64 {
    let points: Vec<(f64, f64)> = LADDER
        .iter()
        .zip(errors)
        .map(|(ticks, error)| (-libm::log(f64::from(*ticks)), libm::log(*error)))
        .collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let product: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let square: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    product / square
}

pub(super) fn rows() -> Rows {
    let mut located = Vec::new();
    let mut plain = Vec::new();
    for ticks in LADDER {
        located.push(error(ticks, true)?);
        plain.push(error(ticks, false)?);
    }
    let largest = located.iter().copied().fold(0.0, f64::max);
    let order = order(&plain);
    let mut rows = vec![
        Claim::new(
            "H14",
            "hit and cushion at 60 to 960 Hz, beside the exact solver",
            "stepped",
            "the same but for rounding at any tick",
        )
        .error(largest, 1e-10, format!("{largest:.0e} m at most")),
        Claim::new(
            "H14",
            "the same with contacts where the tick leaves them",
            "stepped",
            "error of first order in the tick",
        )
        .fact(
            (0.75..1.25).contains(&order) && plain[0] > 1e-3,
            format!("{:.1} mm at 60 Hz, order {order:.2}", 1e3 * plain[0]),
        ),
    ];
    rows.push(frames()?);
    Ok(rows)
}

/// The exact solver on a break, looked at in frames of any length.
fn frames() -> Result<Hard, Stopped> {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    Rack::NineBall.place(&mut scene, Stand::POOL.ball, 0.0, 7);
    let shot = Shot {
        heading: 0.003,
        side: 0.2,
        speed: 7.0,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    let at_end = |frames: u32| -> Result<Vec<State>, Stopped> {
        let mut engine = Engine::new(&scene, Limits::default())?;
        engine.strike(0, &scene.cue, &shot, &mut ())?;
        for frame in 1..=frames {
            engine.advance(2.0 * f64::from(frame) / f64::from(frames), &mut ())?;
        }
        Ok((0..engine.count()).map(|ball| engine.state(ball)).collect())
    };
    let whole = at_end(1)?;
    let mut same = 0;
    let rates = [7, 60, 144, 997];
    for frames in rates {
        same += usize::from(at_end(frames)? == whole);
    }
    let claim = Claim::new(
        "H14",
        "break, 2 s in 1, 7, 60, 144 and 997 frames",
        "exact",
        "the same bits at any frame rate",
    );
    Ok(claim.fact(
        same == rates.len(),
        format!("{same} of {} the same", rates.len()),
    ))
}
