//! Friction at several contacts of an impact while its normal impulse grows.
//!
//! A ball that is pressed against a cushion is pressed against the cloth too; a ball that rubs on another presses
//! itself or the other into the cloth. Such an impact has no closed form: with the normal impulse P as time, the slip
//! of every contact turns, vanishes or begins anew, and each changes the others. [`Rub`] follows it.
//!
//! The impulse of contact c opposes its slip, Jc′ = μc Nc sc/|sc|, with N = 1 at the first contact, the one that
//! carries P, and Nc = max(0, αc + βc J₀′·y) at the others. Slips and closing speed are linear in the impulses.
//! Compression lasts until the closing speed is zero, restitution until the work given back is e² times the work put
//! in (Stronge's energetic restitution). Work is kept as energy lost less heat of friction, so that the kinetic energy
//! afterwards is below the one before by construction, however coarse the steps.
//!
//! Numerics: Dormand & Prince's pair of orders 5 and 4 with step control, the end of compression and the end of
//! restitution located. A slip that vanishes is held: if friction can hold it, the force is the one that does, and if
//! it cannot, the force points where the slip that begins will point (λ J′ = slip rate, see [`hold`]). So nothing
//! chatters, and a step is never shortened for a contact that sticks.

mod hold;
mod step;

#[cfg(test)]
mod tests;

use glam::DVec2;

/// Limits of the friction of one contact: μ (α + β J₀′·y), never below 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    /// Coefficient of friction μ.
    pub friction: f64,
    /// Normal impulse at this contact per normal impulse at the first, without friction at the first.
    pub alpha: f64,
    /// What friction at the first adds to it.
    pub beta: f64,
}

/// An impact with N contacts. Speeds are in units of the first closing speed, inverse masses in units of any mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rub<const N: usize> {
    /// How much slip along x an impulse along x takes away: entry [c][d] for slip at c and impulse at d.
    pub mobility_x: [[f64; N]; N],
    /// The same along y. For all but the first contact the own entries along x and y are equal.
    pub mobility_y: [[f64; N]; N],
    /// Slip along y at each contact that one unit of normal impulse adds.
    pub drive: [f64; N],
    /// Closing speed that one unit of normal impulse takes away.
    pub normal: f64,
    /// Limits of friction; those of the first are (μ, 1, 0).
    pub limits: [Limit; N],
    /// Slip at the start.
    pub slip: [DVec2; N],
    /// Slip that is no more than rounding of the velocities it was computed from.
    pub noise: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
}

/// The impulses of an impact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impulses<const N: usize> {
    /// Normal impulse at the first contact.
    pub normal: f64,
    /// Friction at each contact, to be subtracted along the slip.
    pub friction: [DVec2; N],
}

/// How closely an impact is followed, in units of the closing speed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Accuracy {
    /// Error of one step.
    pub tolerance: f64,
    /// A slip below this that friction can hold is stopped at once.
    pub capture: f64,
    /// A slip that begins is free when it is above this.
    pub release: f64,
    /// A slip below this has vanished.
    pub vanished: f64,
}

impl Accuracy {
    /// Results within 1e-6 of converged ones: see the tests.
    pub(super) const GAME: Self = Self {
        tolerance: 3e-7,
        capture: 1e-4,
        release: 1e-3,
        vanished: 1e-7,
    };
}

/// More steps than any impact with sensible numbers takes: what is left then is a ball that is wedged.
const MOST_STEPS: usize = 1000;

/// Where an impact is.
#[derive(Clone, Copy, Debug)]
struct Point<const N: usize> {
    impulse: f64,
    friction: [DVec2; N],
    heat: f64,
}

/// How fast it goes on: forces at all contacts, and heat.
#[derive(Clone, Copy, Debug)]
struct Rate<const N: usize> {
    friction: [DVec2; N],
    heat: f64,
}

impl<const N: usize> Rub<N> {
    fn slips(&self, at: &Point<N>) -> [DVec2; N] {
        std::array::from_fn(|c| {
            let mut slip = self.slip[c];
            slip.y += self.drive[c] * at.impulse;
            for d in 0..N {
                slip.x -= self.mobility_x[c][d] * at.friction[d].x;
                slip.y -= self.mobility_y[c][d] * at.friction[d].y;
            }
            slip
        })
    }

    fn slip_rates(&self, rate: &Rate<N>) -> [DVec2; N] {
        std::array::from_fn(|c| {
            let mut change = DVec2::new(0.0, self.drive[c]);
            for d in 0..N {
                change.x -= self.mobility_x[c][d] * rate.friction[d].x;
                change.y -= self.mobility_y[c][d] * rate.friction[d].y;
            }
            change
        })
    }

    /// Closing speed: the impulses change it as they are changed by P, by symmetry of the inverse masses.
    fn closing(&self, at: &Point<N>) -> f64 {
        let mut closing = 1.0 - self.normal * at.impulse;
        for c in 0..N {
            closing += self.drive[c] * at.friction[c].y;
        }
        closing
    }

    fn closing_rate(&self, rate: &Rate<N>) -> f64 {
        let mut change = -self.normal;
        for c in 0..N {
            change += self.drive[c] * rate.friction[c].y;
        }
        change
    }

    /// Work stored in the contact: energy lost, less heat.
    fn work(&self, at: &Point<N>) -> f64 {
        let slips = self.slips(at);
        let mut lost = at.impulse * (1.0 + self.closing(at));
        for (friction, (slip, first)) in at.friction.iter().zip(slips.iter().zip(&self.slip)) {
            lost += friction.dot(*slip + *first);
        }
        0.5 * lost - at.heat
    }

    /// Follows the impact to its end.
    pub(super) fn follow(&self, accuracy: &Accuracy) -> Impulses<N> {
        let mut walk = step::Walk::new(self, accuracy);
        walk.compress();
        walk.restore();

        Impulses {
            normal: walk.at.impulse,
            friction: walk.at.friction,
        }
    }
}
