//! The measurements, one after the other.

use std::time::Instant;

use crate::report::speed_and_error::crowds::{self, GRIDS, cost_of_crowd, cost_of_grid};
use crate::report::speed_and_error::ensemble::{COUNTED_OF, statistics};
use crate::report::speed_and_error::horizon::truth;
use crate::report::speed_and_error::ladder::{COURSEWORK_BALLS, GAS, LOOSE, ladder};
use crate::report::speed_and_error::many::gas;
use crate::report::speed_and_error::play::{SAMPLES, cost, play};
use crate::report::speed_and_error::{
    Comparison, Effort, Errors, Measured, Method, Named, Progress, Report, Rung, Truth,
};
use crate::sim::play::Stopped;

/// Two runs whose costs lie within this share of each other are stable.
const STABLE: f64 = 0.02;

/// The names that a scene of the ladder can be asked for by.
#[must_use]
pub fn names(effort: &Effort, library: &[Named]) -> Vec<String> {
    ladder(effort, library)
        .into_iter()
        .map(|rung| rung.name)
        .collect()
}

/// Measures everything; of the ladder only the scenes with these names, if any are given.
///
/// # Errors
/// [`Stopped`] if a solver cannot play a scene.
pub fn run(
    effort: &Effort,
    library: &[Named],
    only: &[String],
    progress: &dyn Progress,
) -> Result<Report, Stopped> {
    let rungs: Vec<Rung> = ladder(effort, library)
        .into_iter()
        .filter(|rung| only.is_empty() || only.contains(&rung.name))
        .collect();
    let counts = crowds::counts(effort.most_balls);
    let grid_balls = COURSEWORK_BALLS.min(effort.most_balls);
    let counted = rungs
        .iter()
        .filter(|rung| COUNTED_OF.contains(&rung.name.as_str()))
        .count();
    let methods: usize = rungs.iter().map(|rung| rung.methods(effort).len()).sum();
    progress.begin(methods + counts.len() + GRIDS.len() + 2 + counted);

    let mut scenes = Vec::new();
    for rung in rungs {
        scenes.push(scene(effort, rung, progress)?);
    }
    let statistics = statistics(effort, &scenes, library, progress)?;
    progress.step("energy over time");
    let drifts = drifts(effort, &scenes)?;
    let mut crowds = Vec::new();
    for count in counts {
        progress.step(&format!("{count} balls"));
        crowds.extend(cost_of_crowd(effort, count)?);
    }
    let mut grids = Vec::new();
    for cells in GRIDS {
        progress.step(&format!("{grid_balls} balls in {cells} x {cells} cells"));
        grids.extend(cost_of_grid(effort, grid_balls, cells)?);
    }
    progress.step("tables and pictures");
    Ok(Report {
        effort: effort.clone(),
        scenes,
        ensembles: statistics,
        crowds,
        grids,
        grid_balls,
        drifts,
    })
}

fn scene(effort: &Effort, rung: Rung, progress: &dyn Progress) -> Result<Comparison, Stopped> {
    let truths = rung
        .starts
        .iter()
        .map(truth)
        .collect::<Result<Vec<_>, _>>()?;
    let mut measured = Vec::new();
    for method in rung.methods(effort) {
        progress.step(&format!("{}: {method}", rung.name));
        let mut errors = Errors::default();
        for (scene, truth) in rung.starts.iter().zip(&truths) {
            let played = play(method, scene, truth.played.states.len())?;
            errors.add(scene, truth, &played);
        }
        measured.push(Measured {
            method,
            cost: cheapest(effort, method, &rung, &truths)?,
            errors,
        });
    }
    Ok(Comparison {
        rung,
        truths,
        measured,
    })
}

/// Processor time in s for a second of a scene: all starts are played, and again until the two cheapest rounds are close
/// to each other or the time for it is up; the cheapest counts.
fn cheapest(
    effort: &Effort,
    method: Method,
    rung: &Rung,
    truths: &[Truth],
) -> Result<f64, Stopped> {
    let samples: usize = truths.iter().map(|truth| truth.played.states.len()).sum();
    let begun = Instant::now();
    let (mut first, mut second) = (f64::INFINITY, f64::INFINITY);
    loop {
        let mut round = 0.0;
        for (scene, truth) in rung.starts.iter().zip(truths) {
            round += cost(method, scene, truth.played.states.len())?.as_secs_f64();
        }
        if round < first {
            (first, second) = (round, first);
        } else {
            second = second.min(round);
        }
        let stable = second <= first * (1.0 + STABLE) && begun.elapsed() > effort.budget / 4;
        if stable || begun.elapsed() > effort.budget {
            return Ok(first / (samples as f64 / f64::from(SAMPLES)));
        }
    }
}

fn drifts(effort: &Effort, scenes: &[Comparison]) -> Result<Vec<crowds::Drift>, Stopped> {
    let samples = if effort.quick {
        SAMPLES / 2
    } else {
        3 * SAMPLES
    } as usize;
    let gas = gas(COURSEWORK_BALLS.min(effort.most_balls), false, 0);
    let crowd = [
        Method::Crowd(60),
        Method::Crowd(240),
        Method::Single(60),
        Method::Single(240),
        Method::Plain(60),
        Method::Plain(240),
    ];
    let mut drifts = crowds::drift(GAS, &gas, &crowd, samples)?;
    if let Some(scene) = scenes.iter().find(|scene| scene.rung.name == LOOSE) {
        let few = [
            Method::Located(60),
            Method::Plain(60),
            Method::Plain(480),
            Method::Coursework(60),
        ];
        // Beyond the horizon another shot is played, with another energy.
        let samples = scene.truths[0].played.states.len();
        drifts.extend(crowds::drift(LOOSE, &scene.rung.starts[0], &few, samples)?);
    }
    Ok(drifts)
}
