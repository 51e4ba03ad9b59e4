//! Convergence: what the game uses against steps so fine that finer ones change nothing.

use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{Accuracy, Impulses, Limit, Rub};

const FINE: Accuracy = Accuracy {
    tolerance: 1e-11,
    capture: 1e-6,
    release: 1e-4,
    vanished: 1e-9,
};

/// A cushion impact with these slips in units of the closing speed.
fn cushion(sin: f64, friction: [f64; 2], slip: [DVec2; 2], restitution: f64) -> Rub<2> {
    let cos = (1.0 - sin * sin).sqrt();
    let limit = |friction, alpha, beta| Limit {
        friction,
        alpha,
        beta,
    };
    Rub {
        mobility_x: [[3.5, 1.0 - 2.5 * sin], [1.0 - 2.5 * sin, 3.5]],
        mobility_y: [[sin * sin + 2.5, 2.5 - sin], [2.5 - sin, 3.5]],
        drive: [sin * cos, -cos],
        normal: cos * cos,
        limits: [limit(friction[0], 1.0, 0.0), limit(friction[1], sin, cos)],
        slip,
        noise: 1e-15,
        restitution,
    }
}

fn apart(one: &Impulses<2>, two: &Impulses<2>) -> f64 {
    one.friction
        .iter()
        .zip(&two.friction)
        .map(|(one, two)| (*one - *two).length())
        .fold((one.normal - two.normal).abs(), f64::max)
}

#[test]
fn impacts_are_converged() {
    for (name, sin, friction, restitution, worst_allowed) in [
        ("snooker", 0.4, [0.14, 0.212], 0.98, 1e-4),
        ("pool", 0.27, [0.2, 0.2], 0.85, 3e-5),
    ] {
        let mut random = ChaCha8Rng::seed_from_u64(14);
        let mut errors = Vec::new();
        for i in 0..2000 {
            let mut draw = || random.random_range(-2.0..2.0);
            let mut slip = [DVec2::new(draw(), draw()), DVec2::new(draw(), draw())];
            if i % 4 == 0 {
                // A rolling ball.
                slip[1] = DVec2::ZERO;
            }
            let rub = cushion(sin, friction, slip, restitution);
            errors.push(apart(&rub.follow(&Accuracy::GAME), &rub.follow(&FINE)));
        }
        errors.sort_by(f64::total_cmp);
        let (median, most, worst) = (errors[1000], errors[1980], errors[1999]);
        println!("{name}: {median:e}, 99 % below {most:e}, worst {worst:e} of the closing speed");
        assert!(median < 3e-7 && most < 1e-5 && worst < worst_allowed);
    }
}
