//! Beyond the horizon: what is true of many shots, where no single one can be told.

use rayon::prelude::*;

use crate::physics::ball::{Motion, State};
use crate::physics::scene::Scene;
use crate::report::judge::Stopped;
use crate::report::speed_and_error::Method;
use crate::report::speed_and_error::fit::mean_and_spread;
use crate::report::speed_and_error::horizon::turned;
use crate::report::speed_and_error::play::{SAMPLES, play};

/// The shots are turned by up to this angle in rad to either side: no more than a good player's scatter.
const SCATTER: f64 = 1e-3;

/// What is counted of a shot.
pub const QUANTITIES: [&str; 3] = ["balls potted", "final spread, m", "path of all balls, m"];

/// One method's account of many shots.
#[derive(Clone, Debug)]
pub struct Ensemble {
    /// The scene.
    pub scene: String,
    /// The method.
    pub method: Method,
    /// Shots.
    pub shots: usize,
    /// Mean and standard deviation of each of [`QUANTITIES`].
    pub values: [(f64, f64); 3],
    /// How far each mean lies from that of the exact solver, in standard errors of the difference.
    pub off: [f64; 3],
}

/// Plays the shots by each method; the first is what the others are compared with.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
pub fn ensembles(
    name: &str,
    scene: &Scene,
    methods: &[Method],
    shots: usize,
    seconds: u32,
) -> Result<Vec<Ensemble>, Stopped> {
    let mut ensembles: Vec<Ensemble> = Vec::new();
    for &method in methods {
        let one = |shot: usize| {
            let share = 2.0 * (shot as f64 + 0.5) / shots as f64 - 1.0;
            let scene = turned(scene, SCATTER * share);
            let played = play(method, &scene, (seconds * SAMPLES) as usize)?;
            Ok(quantities(&scene, &played.states))
        };
        let shots: Vec<[f64; 3]> = (0..shots)
            .into_par_iter()
            .map(one)
            .collect::<Result<_, Stopped>>()?;
        let values = [0, 1, 2].map(|i| {
            let values: Vec<f64> = shots.iter().map(|shot| shot[i]).collect();
            mean_and_spread(&values)
        });
        let first = ensembles.first().map_or(values, |first| first.values);
        let off = [0, 1, 2].map(|i| {
            let error =
                ((values[i].1 * values[i].1 + first[i].1 * first[i].1) / shots.len() as f64).sqrt();
            if error > 0.0 {
                (values[i].0 - first[i].0) / error
            } else {
                0.0
            }
        });
        ensembles.push(Ensemble {
            scene: name.to_owned(),
            method,
            shots: shots.len(),
            values,
            off,
        });
    }
    Ok(ensembles)
}

fn quantities(scene: &Scene, states: &[Vec<State>]) -> [f64; 3] {
    let Some(end) = states.last() else {
        return [0.0; 3];
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
    [potted as f64, spread, path]
}
