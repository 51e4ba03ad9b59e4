//! How far a method is off the exact solver.

use crate::physics::ball::State;
use crate::physics::scene::Scene;
use crate::report::speed_and_error::horizon::{Truth, agreement, apart};
use crate::report::speed_and_error::play::Played;

/// Energy in J of all balls on the table, kinetic and potential.
#[must_use]
pub fn energy(scene: &Scene, states: &[State]) -> f64 {
    let of = |(body, state): (&crate::physics::scene::SceneBall, &State)| {
        if !state.motion.in_play() {
            return 0.0;
        }
        body.ball.kinetic_energy(state) + scene.laws.motion.potential(&body.ball, state)
    };
    scene.balls.iter().zip(states).map(of).sum()
}

/// Kinetic energy in J of all balls on the table.
#[must_use]
pub fn kinetic(scene: &Scene, states: &[State]) -> f64 {
    let balls = scene.balls.iter().zip(states);
    balls
        .filter(|(_, state)| state.motion.in_play())
        .map(|(body, state)| body.ball.kinetic_energy(state))
        .sum()
}

/// The errors of a method in one scene, over all starts, balls and common times before the horizon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Root of the mean square of the distances, m.
    pub rms: f64,
    /// The largest distance, m.
    pub most: f64,
    /// The largest difference of the energies, as a part of the largest kinetic energy of the exact solver: potential
    /// energy has no zero of its own.
    pub energy: f64,
    /// Contacts before the first that differs, in the start where it comes earliest; `None` where contacts are not
    /// written down.
    pub agreed: Option<usize>,
    /// Starts in which a contact before the horizon differs.
    pub differing: usize,
    squares: f64,
    count: usize,
}

impl Default for Errors {
    fn default() -> Self {
        Self {
            rms: 0.0,
            most: 0.0,
            energy: 0.0,
            agreed: Some(usize::MAX),
            differing: 0,
            squares: 0.0,
            count: 0,
        }
    }
}

impl Errors {
    /// Adds one start.
    pub fn add(&mut self, scene: &Scene, truth: &Truth, played: &Played) {
        for distance in apart(&truth.played, played) {
            self.squares += distance * distance;
            self.count += 1;
            self.most = self.most.max(distance);
        }
        self.rms = (self.squares / self.count.max(1) as f64).sqrt();
        let start: Vec<State> = (0..scene.balls.len())
            .map(|ball| truth.record.state_at(ball, 0.0))
            .collect();
        let whole = std::iter::once(&start)
            .chain(&truth.played.states)
            .map(|states| kinetic(scene, states))
            .fold(0.0, f64::max);
        for (exact, ours) in truth.played.states.iter().zip(&played.states) {
            let off = (energy(scene, ours) - energy(scene, exact)).abs();
            self.energy = self.energy.max(off / whole.max(f64::MIN_POSITIVE));
        }
        let Some(touches) = &played.touches else {
            self.agreed = None;
            return;
        };
        let expected = truth.played.touches.as_deref().unwrap_or_default();
        let agreed = agreement(expected, touches, truth.contacts);
        // What lies after the last common time may not have been played.
        let last = truth.played.states.len() as f64 / f64::from(super::play::SAMPLES);
        let asked = expected[..truth.contacts]
            .iter()
            .take_while(|touch| touch.time < last - 1e-9)
            .count();
        if agreed < asked {
            self.differing += 1;
        }
        if agreed < asked || self.differing == 0 {
            self.agreed = self.agreed.map(|least| least.min(agreed.min(asked)));
        }
    }
}
