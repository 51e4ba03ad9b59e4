//! Scenes of many balls, and what is counted of them.
//!
//! A gas is a hard case for a tick and an easy one for a judge: how often a ball meets another is known from kinetic
//! theory, and the exact solver says it for the very box.

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::physics::ball::{Ball, State};
use crate::physics::exact::{Engine, Limits, Watch};
use crate::physics::laws::Laws;
use crate::physics::record::{Event, EventKind};
use crate::physics::scene::{Scene, Solver};
use crate::physics::table::Preset;
use crate::report::speed_and_error::Method;
use crate::report::speed_and_error::error::{energy, kinetic};
use crate::report::speed_and_error::play::{SAMPLES, app, play, step};
use crate::sim::play::Stopped;
use crate::sim::recorder::Recorder;
use crate::sim::stepped::crowd::Census;
use crate::sim::stepping;

/// Share of the floor that the balls of a gas cover.
pub(super) const COVERED: f64 = 0.4;

/// Balls of 1 m/s (root of the mean square) in all directions in a square box of which they cover 0.4; smooth balls without
/// cloth, or balls that roll on it. The same `seed` gives the same gas.
#[must_use]
pub fn gas(count: u32, cloth: bool, seed: u64) -> Scene {
    let ball = Ball {
        spins: cloth,
        ..Ball::POOL
    };
    let side = (f64::from(count) * std::f64::consts::PI / COVERED).sqrt() * ball.radius;
    let table = Preset::Box {
        length: side,
        width: side,
    }
    .table();
    let mut scene = Scene::new(
        table,
        if cloth {
            Laws::default()
        } else {
            Laws::ideal()
        },
    );
    let columns = f64::from(count).sqrt().ceil();
    let pitch = side / columns;
    let free = 0.9 * (0.5 * pitch - ball.radius);
    let mut random = ChaCha8Rng::seed_from_u64(5750 + seed);
    let mut signed = || random.random_range(-1.0..1.0);
    for i in 0..count {
        let (column, row) = (f64::from(i) % columns, (f64::from(i) / columns).floor());
        let x = (column + 0.5) * pitch - 0.5 * side + free * signed();
        let z = (row + 0.5) * pitch - 0.5 * side + free * signed();
        let index = scene.place(&i.to_string(), ball, x, z);
        // Sums of twelve are close to Maxwell's law, so that the gas begins in balance.
        let mut normal = || (0..12).map(|_| signed()).sum::<f64>() * 0.5 * 0.5_f64.sqrt();
        let velocity = DVec3::new(normal(), 0.0, normal());
        let spin = if cloth {
            ball.rolling_spin(velocity)
        } else {
            DVec3::ZERO
        };
        let state = &mut scene.balls[index].state;
        state.velocity = velocity;
        state.angular_velocity = spin;
    }
    // To the mean square of many, whatever these few have drawn.
    let velocities = scene.balls.iter().map(|body| body.state.velocity);
    let squares: f64 = velocities.map(DVec3::length_squared).sum();
    let scale = (f64::from(count) / squares).sqrt();
    for body in &mut scene.balls {
        body.state.velocity *= scale;
        body.state.angular_velocity *= scale;
    }
    scene
}

/// How often in 1/s a ball of an endless gas of hard discs meets another: `share` of the floor is covered, and the root of
/// the mean square of the speeds is `speed` in m/s.
///
/// Enskog's theory: 4 (Z - 1) sqrt(kT/m) / (diameter sqrt(pi)), where kT/m is half the mean square of the speed. Z is the
/// pressure over that of points: (1 + share^2 / 8) / (1 - share)^2. Sources: Chapman & Cowling, "The mathematical theory
/// of non-uniform gases" (1970), chapter 16, in the plane; Henderson, Mol. Phys. 30 (1975) 971.
#[must_use]
pub fn enskog_rate(share: f64, radius: f64, speed: f64) -> f64 {
    let pressure = (1.0 + share * share / 8.0) / ((1.0 - share) * (1.0 - share));
    let thermal = speed * std::f64::consts::FRAC_1_SQRT_2;
    4.0 * (pressure - 1.0) * thermal / (2.0 * radius * std::f64::consts::PI.sqrt())
}

/// Balls of the gas whose contacts are counted.
pub(super) const COUNTED: u32 = 2000;
/// Seconds after which the lattice from which a gas begins is forgotten, and seconds that are counted.
const SETTLE: u32 = 1;
const COUNT: u32 = 1;

/// What is counted of a gas.
pub(super) const OF_A_GAS: [&str; 2] = [
    "contacts of a ball, 1/s",
    "mean of speed^4 over square of mean of speed^2",
];

/// The contacts of a ball in a second of a gas, and how its speeds are spread: by Maxwell's law in the plane that is 2.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
pub(super) fn count_gas(method: Method, scene: &Scene) -> Result<Vec<f64>, Stopped> {
    #[derive(Default)]
    struct Pairs(u64);
    impl Watch for Pairs {
        fn event(&mut self, event: &Event) {
            self.0 += u64::from(event.kind == EventKind::BallBall);
        }
    }
    let scene = method.prepare(scene);
    let (pairs, states) = if let Some(rate) = method.rate() {
        let mut app = app(&scene);
        let count = |app: &bevy::app::App| {
            if scene.solver.is_crowd() {
                return app.world().resource::<Census>().contacts_in_all;
            }
            let events = &app.world().resource::<Recorder>().events;
            let pairs = events
                .iter()
                .filter(|event| event.kind == EventKind::BallBall);
            pairs.count() as u64
        };
        step(&mut app, SETTLE * rate)?;
        let first = count(&app);
        step(&mut app, COUNT * rate)?;
        (count(&app) - first, stepping::states(&mut app))
    } else {
        let mut engine = Engine::new(&scene, Limits { events: u64::MAX })?;
        engine.advance(f64::from(SETTLE), &mut ())?;
        let mut pairs = Pairs::default();
        engine.advance(f64::from(SETTLE + COUNT), &mut pairs)?;
        let states = (0..engine.count()).map(|ball| engine.state(ball)).collect();
        (pairs.0, states)
    };
    let balls = states.len() as f64;
    let squares = || {
        states
            .iter()
            .map(|state: &State| state.velocity.length_squared())
    };
    let square = squares().sum::<f64>() / balls;
    let fourth = squares().map(|square| square * square).sum::<f64>() / balls;
    Ok(vec![
        2.0 * pairs as f64 / balls / f64::from(COUNT),
        fourth / (square * square),
    ])
}

/// Seconds of a dam break before its balls lie in heaps: contacts that last are beyond the exact solver.
const BREAKING: f64 = 1.2;

/// The balls of a dam, each with a push of a centimetre a second at most that is another one for every `seed`: without
/// any, all of a row fall as one.
pub(super) fn let_go(scene: &Scene, seed: u64) -> Scene {
    let mut scene = scene.clone();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut push = || 0.007 * random.random_range(-1.0..1.0);
    for ball in &mut scene.balls {
        ball.state.velocity = DVec3::new(push(), 0.0, push());
    }
    scene.solver = Solver::Exact;
    scene.time_limit = BREAKING;
    scene
}

/// What is counted of a dam break.
pub(super) const OF_A_DAM: [&str; 3] = [
    "energy lost, share of what the fall gave",
    "middle of all balls along, m",
    "middle of all balls across, m",
];

/// Where the balls of a dam are at the end, and what they have lost.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
pub(super) fn count_dam(method: Method, scene: &Scene) -> Result<Vec<f64>, Stopped> {
    let samples = (scene.time_limit * f64::from(SAMPLES)).round() as usize;
    let played = play(method, scene, samples)?;
    let start: Vec<State> = scene.balls.iter().map(|ball| ball.state).collect();
    let end = played.states.last().unwrap_or(&start);
    let middle = end.iter().map(|state| state.position).sum::<DVec3>() / end.len().max(1) as f64;
    let moving = kinetic(scene, end);
    let lost = energy(scene, &start) - energy(scene, end);
    Ok(vec![lost / (moving + lost), middle.x, middle.z])
}

/// Seconds after which a ball that runs down the board alone lies in a bin.
const RUN: u32 = 12;

/// One ball of a Galton board, from where it lies in the scene.
pub(super) fn alone(scene: &Scene, ball: usize) -> Scene {
    let mut scene = scene.clone();
    let mut body = scene.balls.swap_remove(ball % scene.balls.len().max(1));
    // A push of a centimetre a second: what rests has no direction that could be turned.
    let side = libm::fmod(ball as f64 * 0.618_033_988_749_895, 1.0) - 0.5;
    body.state.velocity = DVec3::new(0.01 * side, 0.0, 0.01);
    scene.balls = vec![body];
    scene.solver = Solver::Exact;
    scene.time_limit = f64::from(RUN);
    scene
}

/// What is counted of a ball on a board.
pub(super) const OF_A_BOARD: [&str; 2] = ["place across, m", "distance from the middle, m"];

/// Where a ball ends across the board.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
pub(super) fn count_board(method: Method, scene: &Scene) -> Result<Vec<f64>, Stopped> {
    let played = play(method, scene, (RUN * SAMPLES) as usize)?;
    let end = played.states.last().and_then(|states| states.first());
    let across = end.map_or(0.0, |state| state.position.x);
    Ok(vec![across, across.abs()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thin_gas_meets_as_points_with_a_size_do() {
        // n 2d <relative speed>, with n = share / (pi R^2) and sqrt(pi kT/m) for the mean relative speed.
        let (share, radius) = (1e-6, 0.01);
        let density = share / (std::f64::consts::PI * radius * radius);
        let relative = (std::f64::consts::PI * 0.5).sqrt();
        let rate = density * 4.0 * radius * relative;
        let ours = enskog_rate(share, radius, 1.0);
        assert!((ours / rate - 1.0).abs() < 1e-5, "{ours} {rate}");
        // The balls of the coursework report at 0.4: a value worked out by hand.
        let ours = enskog_rate(0.4, 0.028_575, 1.0);
        assert!((ours - 51.19).abs() < 0.01, "{ours}");
    }
}
