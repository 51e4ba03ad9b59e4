//! A scene of the ladder, played by every method.

use crate::report::speed_and_error::fit::{Convergence, convergence, pareto};
use crate::report::speed_and_error::play::SAMPLES;
use crate::report::speed_and_error::{Errors, Method, Rung, Truth};

/// Error in m that is no more than rounding, however little a scene amplifies it.
const ROUNDING: f64 = 1e-9;

/// One method in one scene.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The method.
    pub method: Method,
    /// Processor time in s for a second of the scene.
    pub cost: f64,
    /// Its errors.
    pub errors: Errors,
}

/// One scene, played by every method.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The scene.
    pub rung: Rung,
    /// What the exact solver says of each start.
    pub truths: Vec<Truth>,
    /// Every method that can play it, the exact one first.
    pub measured: Vec<Measured>,
}

impl Comparison {
    /// The furthest in m that a turn of 1e-13 rad carries a ball before the horizon.
    #[must_use]
    pub fn floor(&self) -> f64 {
        self.truths
            .iter()
            .map(|truth| truth.floor)
            .fold(0.0, f64::max)
    }

    /// Times in s up to which the starts are compared: the shortest and the longest.
    #[must_use]
    pub fn until(&self) -> (f64, f64) {
        let times = || self.truths.iter().map(|truth| truth.until);
        (
            times().fold(f64::INFINITY, f64::min),
            times().fold(0.0, f64::max),
        )
    }

    /// The methods of a family, by tick.
    pub fn family(&self, of: Method) -> impl Iterator<Item = &Measured> {
        self.measured
            .iter()
            .filter(move |measured| measured.method.family() == of.family())
    }

    /// How the error of a family falls with the tick.
    #[must_use]
    pub fn convergence(&self, of: Method) -> Convergence {
        let points: Vec<(f64, f64)> = self
            .family(of)
            .filter_map(|measured| {
                Some((
                    1.0 / f64::from(measured.method.rate()?),
                    measured.errors.rms,
                ))
            })
            .collect();
        convergence(&points, ROUNDING.max(self.floor()))
    }

    /// Whether located contacts converge as they should.
    #[must_use]
    pub fn keeps_order(&self) -> bool {
        match self.convergence(Method::Located(SAMPLES)) {
            Convergence::Rounding => true,
            Convergence::Order { order, .. } => order >= 2.0,
            Convergence::Unknown => false,
        }
    }

    /// The methods that no other beats in cost and error both, cheapest first.
    #[must_use]
    pub fn front(&self) -> Vec<usize> {
        let points: Vec<(f64, f64)> = self
            .measured
            .iter()
            .map(|m| (m.cost, m.errors.rms))
            .collect();
        pareto(&points)
    }
}
