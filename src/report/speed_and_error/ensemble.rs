//! Beyond the horizon: what is true of many shots, where no single one can be told.

use rayon::prelude::*;

use crate::physics::ball::{Motion, State};
use crate::physics::scene::Scene;
use crate::report::speed_and_error::fit::mean_and_spread;
use crate::report::speed_and_error::horizon::turned;
use crate::report::speed_and_error::ladder::{GAS, LOOSENED};
use crate::report::speed_and_error::many::{self, gas};
use crate::report::speed_and_error::play::{SAMPLES, play};
use crate::report::speed_and_error::{
    BOARD, BREAK, Comparison, DAM, Effort, Method, Named, Progress,
};
use crate::sim::play::Stopped;

/// The shots are turned by up to this angle in rad to either side: no more than a good player's scatter.
const SCATTER: f64 = 1e-3;

/// What is counted of a break.
const OF_A_BREAK: [&str; 3] = ["balls potted", "final spread, m", "path of all balls, m"];

/// One method's account of many shots.
#[derive(Clone, Debug)]
pub struct Ensemble {
    /// The scene.
    pub scene: String,
    /// The method.
    pub method: Method,
    /// Shots.
    pub shots: usize,
    /// What is counted of each.
    pub quantities: &'static [&'static str],
    /// Mean and standard deviation of each of the quantities.
    pub values: Vec<(f64, f64)>,
    /// How far each mean lies from that of the exact solver, in standard errors of the difference.
    pub off: Vec<f64>,
}

/// Seconds after which every break has come to rest, or nearly.
const BREAK_SECONDS: u32 = 12;

/// Scenes of which many shots are played.
pub(super) const COUNTED_OF: [&str; 5] = [BREAK, LOOSENED, BOARD, DAM, GAS];

/// What is true beyond the horizon, of the scenes that were played.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
pub(super) fn statistics(
    effort: &Effort,
    scenes: &[Comparison],
    library: &[Named],
    progress: &dyn Progress,
) -> Result<Vec<Ensemble>, Stopped> {
    let few = [
        Method::Exact,
        Method::Located(60),
        Method::Located(480),
        Method::Plain(60),
        Method::Plain(480),
    ];
    let many = [
        Method::Exact,
        Method::Crowd(60),
        Method::Crowd(120),
        Method::Crowd(480),
        Method::Single(120),
        Method::Plain(60),
        Method::Plain(240),
    ];
    let (shots, runs) = (effort.shots, effort.runs);
    let mut statistics = Vec::new();
    for rung in scenes.iter().map(|scene| &scene.rung) {
        let name = rung.name.as_str();
        if !COUNTED_OF.contains(&name) {
            continue;
        }
        progress.step(&format!("{name}: many times"));
        let scene = &rung.starts[0];
        statistics.extend(match name {
            GAS => {
                let balls = many::COUNTED.min(effort.most_balls);
                ensembles(name, &many::OF_A_GAS, &many, runs, |method, run| {
                    many::count_gas(method, &gas(balls, false, run as u64))
                })
            }
            DAM => ensembles(name, &many::OF_A_DAM, &many, runs, |method, run| {
                many::count_dam(method, &many::let_go(scene, run as u64))
            }),
            BOARD => {
                let Some(board) = library.iter().find(|named| named.name == BOARD) else {
                    continue;
                };
                ensembles(name, &many::OF_A_BOARD, &few, shots, |method, shot| {
                    many::count_board(method, &many::alone(&board.scene, shot))
                })
            }
            _ => {
                let methods = [&few[..], &[Method::Coursework(60)]].concat();
                ensembles(name, &OF_A_BREAK, &methods, shots, |method, shot| {
                    count_break(method, scene, (shot, shots), BREAK_SECONDS)
                })
            }
        }?);
    }
    Ok(statistics)
}

/// Plays the shots by each method; the first is what the others are compared with. `count` plays one shot and counts.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
fn ensembles(
    name: &str,
    quantities: &'static [&'static str],
    methods: &[Method],
    shots: usize,
    count: impl Fn(Method, usize) -> Result<Vec<f64>, Stopped> + Sync,
) -> Result<Vec<Ensemble>, Stopped> {
    let mut ensembles: Vec<Ensemble> = Vec::new();
    for &method in methods {
        let shots: Vec<Vec<f64>> = (0..shots)
            .into_par_iter()
            .map(|shot| count(method, shot))
            .collect::<Result<_, Stopped>>()?;
        let value = |i: usize| {
            let values: Vec<f64> = shots.iter().map(|shot| shot[i]).collect();
            mean_and_spread(&values)
        };
        let values: Vec<(f64, f64)> = (0..quantities.len()).map(value).collect();
        let first = ensembles.first().map_or(&values, |first| &first.values);
        let off = values.iter().zip(first).map(|(ours, first)| {
            let error = ((ours.1 * ours.1 + first.1 * first.1) / shots.len() as f64).sqrt();
            if error > 0.0 {
                (ours.0 - first.0) / error
            } else {
                0.0
            }
        });
        ensembles.push(Ensemble {
            scene: name.to_owned(),
            method,
            shots: shots.len(),
            quantities,
            off: off.collect(),
            values,
        });
    }
    Ok(ensembles)
}

/// Plays a break of so many seconds, turned to the place of this shot among all.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
fn count_break(
    method: Method,
    scene: &Scene,
    (shot, shots): (usize, usize),
    seconds: u32,
) -> Result<Vec<f64>, Stopped> {
    let share = 2.0 * (shot as f64 + 0.5) / shots as f64 - 1.0;
    let scene = turned(scene, SCATTER * share);
    let played = play(method, &scene, (seconds * SAMPLES) as usize)?;
    Ok(quantities(&scene, &played.states))
}

fn quantities(scene: &Scene, states: &[Vec<State>]) -> Vec<f64> {
    let Some(end) = states.last() else {
        return vec![0.0; OF_A_BREAK.len()];
    };
    let potted = end
        .iter()
        .filter(|state| state.motion == Motion::Pocketed)
        .count();
    let lie: Vec<_> = end
        .iter()
        .filter(|state| state.motion.in_play())
        .map(|state| state.position)
        .collect();
    let count = lie.len().max(1) as f64;
    let middle = lie.iter().sum::<glam::DVec3>() / count;
    let spread = (lie
        .iter()
        .map(|place| place.distance_squared(middle))
        .sum::<f64>()
        / count)
        .sqrt();
    let mut path = 0.0;
    for ball in 0..scene.balls.len() {
        let mut last = scene.balls[ball].state.position;
        for state in states.iter().map(|states| &states[ball]) {
            if !state.motion.in_play() {
                break;
            }
            path += state.position.distance(last);
            last = state.position;
        }
    }
    vec![potted as f64, spread, path]
}
