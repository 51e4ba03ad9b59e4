//! Forces at the contacts.
//!
//! Where a slip has vanished, friction either holds it or lets it begin. Both are one rule: with k the slip rate
//! without the friction of this contact and D its inverse masses, k − D J′ = λ J′ with the smallest λ ≥ 0 for which
//! |J′| is within its limit. λ = 0 is sticking; with λ > 0 the slip begins in the direction of the force against it.

use glam::DVec2;

use super::{Point, Rate, Rub};

/// Normal impulse, in units of what compression takes, within which a held slip is drawn into the direction of its
/// force.
const DRAW: f64 = 0.02;

/// Rounds between two contacts that are both held.
const ROUNDS: usize = 64;

impl<const N: usize> Rub<N> {
    /// Forces and heat at a point, with these contacts held.
    #[inline]
    pub(super) fn rate(&self, at: &Point<N>, held: &[bool; N]) -> Rate<N> {
        let slips = self.slips(at);
        let mut friction = [DVec2::ZERO; N];
        // Force per normal force where the slip is free, and what draws the slip to the force where it is held.
        let mut direction = [DVec2::ZERO; N];
        for c in 0..N {
            if held[c] {
                direction[c] = slips[c] * (self.normal / DRAW);
            } else {
                let square = slips[c].length_squared();
                if square > 1e-200 {
                    direction[c] = slips[c] * (self.limits[c].friction / square.sqrt());
                }
            }
        }
        if held[0] {
            self.hold_first(held, &direction, &mut friction);
        } else {
            friction[0] = direction[0];
            self.others(held, &direction, &mut friction);
        }
        let mut heat = 0.0;
        for c in 0..N {
            heat += friction[c].dot(slips[c]);
        }
        Rate {
            friction,
            heat: heat.max(0.0),
        }
    }

    #[inline]
    fn pressure(&self, c: usize, first: DVec2) -> f64 {
        (self.limits[c].alpha + self.limits[c].beta * first.y).max(0.0)
    }

    /// Forces at all contacts but the first, whose force is known.
    #[inline]
    fn others(&self, held: &[bool; N], direction: &[DVec2; N], friction: &mut [DVec2; N]) {
        for c in 1..N {
            let pressure = self.pressure(c, friction[0]);
            friction[c] = if held[c] {
                // Only the first contact acts on it: two further contacts are on different balls.
                let k = DVec2::new(
                    -self.mobility_x[c][0] * friction[0].x,
                    self.drive[c] - self.mobility_y[c][0] * friction[0].y,
                );
                let limit = self.limits[c].friction * pressure;
                if k.length() <= limit * self.mobility_x[c][c] {
                    k / self.mobility_x[c][c]
                } else {
                    let k = k + direction[c];
                    k * (limit / k.length().max(1e-100))
                }
            } else {
                direction[c] * pressure
            };
        }
    }

    /// Forces where the first contact is held.
    #[cold]
    #[inline(never)]
    fn hold_first(&self, held: &[bool; N], direction: &[DVec2; N], friction: &mut [DVec2; N]) {
        let any_other = (1..N).any(|c| held[c]);
        let rounds = if any_other { ROUNDS } else { 1 };
        for _ in 0..rounds {
            let before = friction[0];
            friction[0] = self.first_force(held, direction, friction);
            self.others(held, direction, friction);
            if (friction[0] - before).abs().max_element() < 1e-13 {
                break;
            }
        }
    }

    /// The force at the first contact when slip at the others is free, or their force known.
    #[expect(
        clippy::needless_range_loop,
        reason = "one index runs through several lists"
    )]
    fn first_force(
        &self,
        held: &[bool; N],
        direction: &[DVec2; N],
        friction: &[DVec2; N],
    ) -> DVec2 {
        let mut active: [bool; N] = std::array::from_fn(|c| {
            let limit = &self.limits[c];
            limit.alpha > 0.0 || (limit.alpha == 0.0 && limit.beta * self.drive[0] > 0.0)
        });
        let mut force = DVec2::ZERO;
        for _ in 0..3 {
            let mut k = DVec2::new(0.0, self.drive[0]);
            // Along x and y, and what force along y costs along x, since it presses on the others.
            let mut d = DVec2::new(self.mobility_x[0][0], self.mobility_y[0][0]);
            let mut across = 0.0;
            for c in 1..N {
                let (x, y) = (self.mobility_x[0][c], self.mobility_y[0][c]);
                if held[c] {
                    k -= DVec2::new(x * friction[c].x, y * friction[c].y);
                } else if active[c] {
                    let Limit { alpha, beta } = Limit::of(self, c);
                    k -= alpha * DVec2::new(x * direction[c].x, y * direction[c].y);
                    across += beta * x * direction[c].x;
                    d.y += beta * y * direction[c].y;
                }
            }
            force = hold(self.limits[0].friction, k, direction[0], d, across);
            let mut settled = true;
            for c in 1..N {
                let pressed = self.pressure(c, force) > 0.0;
                settled &= pressed == active[c];
                active[c] = pressed;
            }
            if settled {
                break;
            }
        }
        force
    }

    /// The impulses that stop the slip of a contact at once.
    pub(super) fn stop(&self, contact: usize, held: &[bool; N], at: &Point<N>) -> [DVec2; N] {
        let slips = self.slips(at);
        let mut impulses = [DVec2::ZERO; N];
        let slip = slips[contact];
        let mut d = DVec2::new(
            self.mobility_x[contact][contact],
            self.mobility_y[contact][contact],
        );
        if contact > 0 {
            impulses[contact] = slip / d;
            return impulses;
        }
        let mut push = [DVec2::ZERO; N];
        let mut across = 0.0;
        let rate = self.rate(at, held);
        for c in 1..N {
            if !held[c] && self.pressure(c, rate.friction[0]) > 0.0 {
                let size = slips[c].length().max(1e-100);
                push[c] = slips[c] * (self.limits[c].friction * self.limits[c].beta / size);
                across += self.mobility_x[0][c] * push[c].x;
                d.y += self.mobility_y[0][c] * push[c].y;
            }
        }
        let y = slip.y / d.y;
        impulses[0] = DVec2::new((slip.x - across * y) / d.x, y);
        for c in 1..N {
            impulses[c] = push[c] * y;
        }
        impulses
    }
}

/// The part of [`super::Limit`] that the normal impulse depends on.
struct Limit {
    alpha: f64,
    beta: f64,
}

impl Limit {
    fn of<const N: usize>(rub: &Rub<N>, c: usize) -> Self {
        let super::Limit { alpha, beta, .. } = rub.limits[c];
        Self { alpha, beta }
    }
}

/// The force J with k − (d + λ) J − (`across` J.y, 0) = 0, |J| ≤ `limit`, and the least λ ≥ 0.
fn hold(limit: f64, k: DVec2, draw: DVec2, d: DVec2, across: f64) -> DVec2 {
    let held = DVec2::new((k.x - across * k.y / d.y) / d.x, k.y / d.y);
    if held.length_squared() <= limit * limit {
        return held;
    }
    let k = k + draw;
    let force = |lambda: f64| {
        let y = k.y / (d.y + lambda);
        DVec2::new((k.x - across * y) / (d.x + lambda), y)
    };
    let mut lambda = 0.0;
    let mut sought = force(0.0);
    if sought.length_squared() <= limit * limit {
        return sought;
    }
    if limit == 0.0 {
        return DVec2::ZERO;
    }
    // 1/|J| is nearly linear in λ.
    for _ in 0..12 {
        let size = sought.length();
        let y = -sought.y / (d.y + lambda);
        let slope = DVec2::new((-across * y - sought.x) / (d.x + lambda), y);
        let step = size * (size / limit - 1.0) * size / -sought.dot(slope);
        lambda = (lambda + step).max(0.0);
        sought = force(lambda);
        if step.abs() <= 1e-13 * lambda {
            break;
        }
    }
    sought * (limit / sought.length())
}
