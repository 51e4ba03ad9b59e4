//! The errors of a hand have the statistics that they should have.

use masse::game::players::{Deviation, Level, Noise};
use masse::physics::ball::Ball;
use masse::physics::cue::{Cue, Shot};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// How many strokes are drawn.
const DRAWN: usize = 40_000;

/// Mean and standard deviation of a quantity of strokes that are meant alike.
fn spread(noise: Noise, of: impl Fn(&Shot) -> f64) -> (f64, f64) {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let meant = Shot {
        elevation: 0.3,
        ..Shot::default()
    };
    let values: Vec<f64> = (0..DRAWN)
        .map(|_| of(&noise.apply(&Deviation::draw(&mut rng), &meant, Ball::POOL.radius)))
        .collect();
    let mean = values.iter().sum::<f64>() / DRAWN as f64;
    let square = values
        .iter()
        .map(|value| (value - mean) * (value - mean))
        .sum::<f64>();
    (mean, (square / DRAWN as f64).sqrt())
}

#[test]
fn a_hand_errs_as_fastfiz_says_times_its_factor() {
    for factor in [0.5, 1.0, 2.0] {
        let noise = Noise::times(factor);
        let radius = Ball::POOL.radius;
        let quantities: [(&dyn Fn(&Shot) -> f64, f64, f64); 5] = [
            (&|shot| shot.side * radius, 0.0, 0.000_5),
            (&|shot| shot.height * radius, 0.0, 0.000_5),
            (
                &|shot| shot.elevation.to_degrees(),
                0.3_f64.to_degrees(),
                0.1,
            ),
            (&|shot| shot.heading.to_degrees(), 0.0, 0.125),
            (&|shot| shot.speed, 2.0, 0.075),
        ];
        for (of, meant, deviation) in quantities {
            let (mean, found) = spread(noise, of);
            let expected = factor * deviation;
            // Four standard errors of a mean and of a standard deviation.
            let error = 4.0 * expected / (DRAWN as f64).sqrt();
            assert!((mean - meant).abs() < error, "{mean} for {meant}");
            assert!((found - expected).abs() < error, "{found} for {expected}");
        }
    }
}

#[test]
fn errors_are_independent_and_normal() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let drawn: Vec<[f64; 5]> = (0..DRAWN).map(|_| Deviation::draw(&mut rng).0).collect();
    let mean = |of: &dyn Fn(&[f64; 5]) -> f64| drawn.iter().map(of).sum::<f64>() / DRAWN as f64;
    for i in 0..5 {
        for j in 0..i {
            assert!(
                mean(&|d| d[i] * d[j]).abs() < 4.0 / (DRAWN as f64).sqrt(),
                "{i} {j}"
            );
        }
        let within = mean(&|d| f64::from(u8::from(d[i].abs() < 1.0)));
        assert!((within - 0.682_689).abs() < 0.01, "{within}");
        let far = mean(&|d| f64::from(u8::from(d[i].abs() < 2.0)));
        assert!((far - 0.954_5).abs() < 0.005, "{far}");
    }
}

#[test]
fn a_sure_hand_does_what_it_means_and_no_hand_leaves_the_ball() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let meant = Shot {
        side: 0.4,
        height: -0.3,
        speed: 0.05,
        ..Shot::default()
    };
    for _ in 0..2000 {
        let deviation = Deviation::draw(&mut rng);
        assert_eq!(Noise::times(0.0).apply(&deviation, &meant, 0.03), meant);
        let wild = Noise::times(60.0).apply(&deviation, &meant, 0.03);
        assert!(
            wild.offset() <= 0.951 && wild.speed > 0.0 && wild.elevation >= 0.0,
            "{wild:?}"
        );
    }
}

#[test]
fn levels_go_from_weak_to_strong() {
    let names: Vec<&str> = Level::ALL.iter().map(|level| level.name).collect();
    assert!(names.len() >= 5);
    for pair in Level::ALL.windows(2) {
        let direction = |level: &Level| level.hand().direction(&Cue::default(), &Ball::POOL);
        assert!(
            direction(&pair[0]) > direction(&pair[1]),
            "{} {}",
            pair[0].name,
            pair[1].name
        );
        let (weak, strong) = (pair[0].skills, pair[1].skills);
        assert!(weak.budget < strong.budget && weak.pot_rate < strong.pot_rate);
    }
    for name in names {
        assert_eq!(
            Level::named(&name.to_uppercase()).map(|level| level.name),
            Some(name)
        );
    }
    assert_eq!(Level::named("nobody"), None);
}
