//! The Galton board: where balls end that run past rows of pegs.

use glam::{DVec2, DVec3};
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::{BallBallLaw, Frictionless};
use masse::physics::laws::cushion::{CushionLaw, Mirror};
use masse::physics::laws::motion::{Incline, MotionLaw};
use masse::physics::scene::Scene;
use masse::physics::table::PegBoard;
use masse::scenarios::library::open;
use masse::sim::stepping;

use super::SMOOTH;

/// Pegs as near as lets a ball pass with a fifth of its diameter to spare.
const BOARD: PegBoard = PegBoard {
    rows: 10,
    pitch: 0.11,
    peg_radius: 0.0207,
    room: 0.3,
    funnel: 0.3,
    mouth: 0.1,
    bins: 0.3,
};
const BALLS: usize = 800;

fn binomial(rows: usize) -> Vec<f64> {
    let mut share = vec![1.0 / f64::from(1 << rows)];
    for k in 0..rows {
        share.push(share[k] * (rows - k) as f64 / (k + 1) as f64);
    }
    share
}

/// Shares of a normal distribution with this mean and spread, in bins of width 1 around 0, 1, ...
fn normal(bins: usize, mean: f64, spread: f64) -> Vec<f64> {
    let below = |x: f64| 0.5 * libm::erfc((mean - x) / (spread * std::f64::consts::SQRT_2));
    let edge = |k: usize| match k {
        0 => 0.0,
        _ if k == bins => 1.0,
        _ => below(k as f64 - 0.5),
    };
    (0..bins).map(|bin| edge(bin + 1) - edge(bin)).collect()
}

/// Pearson's sum over bins, those with less than five expected put together, and its degrees of freedom.
fn chi_square(counts: &[usize], shares: &[f64]) -> (f64, usize) {
    let all = counts.iter().sum::<usize>() as f64;
    let (mut sum, mut groups, mut seen, mut expected) = (0.0, 0, 0.0, 0.0);
    let mut rest = (0.0, 0.0);
    for (count, share) in counts.iter().zip(shares) {
        seen += *count as f64;
        expected += all * share;
        if expected >= 5.0 {
            sum += (seen - expected) * (seen - expected) / expected;
            groups += 1;
            (seen, expected) = (0.0, 0.0);
        }
        rest = (seen, expected);
    }
    if rest.1 > 1e-9 {
        sum += (rest.0 - rest.1) * (rest.0 - rest.1) / rest.1;
    }
    (sum, groups - 1)
}

/// Mean and variance of the bin.
fn moments(counts: &[usize]) -> (f64, f64) {
    let all = counts.iter().sum::<usize>() as f64;
    let mean = counts
        .iter()
        .enumerate()
        .map(|(bin, count)| bin as f64 * *count as f64)
        .sum::<f64>()
        / all;
    let of = |(bin, count): (usize, &usize)| {
        let off = bin as f64 - mean;
        off * off * *count as f64
    };
    (
        mean,
        counts.iter().enumerate().map(of).sum::<f64>() / (all - 1.0),
    )
}

/// Balls one by one, by the exact solver. They lose most of their speed at a peg, so that each row is nearly a toss of its
/// own.
#[test]
fn balls_that_fall_alone_are_spread_as_a_bell() {
    let laws = Laws {
        motion: MotionLaw::Inclined(Incline { x: 0.0, z: 2.0 }),
        ball_ball: BallBallLaw::Frictionless(Frictionless { restitution: 0.3 }),
        cushion: CushionLaw::Mirror(Mirror {
            restitution: 0.3.into(),
        }),
        ..Laws::ideal()
    };
    let mut counts = vec![0; BOARD.rows as usize + 1];
    for k in 0..BALLS {
        let mut scene = Scene::new(BOARD.build(), laws);
        // Anywhere in the middle of the mouth, by the golden section: evenly, without a pattern.
        let share = libm::fmod(k as f64 * 0.618_033_988_749_895, 1.0) - 0.5;
        let mouth = BOARD.mouth();
        scene.place("1", SMOOTH, 0.04 * share, mouth.y - 0.05);
        scene.balls[0].state.velocity = DVec3::new(0.05 * share, 0.0, 0.3);
        scene.time_limit = 12.0;
        let end = solve(&scene, Limits::default()).expect("sound").end[0].position;
        let bin = BOARD.bin(DVec2::new(end.x, end.z));
        counts[bin.unwrap_or_else(|| panic!("ball {k} hangs at {end}"))] += 1;
    }
    let (mean, variance) = moments(&counts);
    let rows = BOARD.rows as usize;
    let tosses = chi_square(&counts, &binomial(rows));
    let bell = chi_square(&counts, &normal(rows + 1, mean, variance.sqrt()));
    println!(
        "{counts:?}: mean {mean:.3}, variance {variance:.3} (binomial {})",
        0.25 * rows as f64
    );
    println!(
        "chi square {:.1} of {} against the binomial, {:.1} of {} against a normal of its own width",
        tosses.0,
        tosses.1,
        bell.0,
        bell.1 - 2
    );
    // What chance alone exceeds once in a thousand times, for eight and for six degrees of freedom.
    assert!(tosses.1 == 8 && tosses.0 < 26.1, "{tosses:?}");
    assert!(bell.1 - 2 == 6 && bell.0 < 22.5, "{bell:?}");
    let error = (variance / BALLS as f64).sqrt();
    assert!((mean - 0.5 * rows as f64).abs() < 3.0 * error, "{mean}");
}

/// All balls of the library's board at once: they hinder each other, and all end in bins.
#[test]
fn a_crowd_fills_the_bins_of_the_board() {
    let scenario = open("galton").expect("built in");
    let scene = scenario.scene;
    let board = PegBoard {
        rows: 14,
        pitch: 0.115,
        peg_radius: 0.019,
        room: 1.0,
        funnel: 0.5,
        mouth: 0.13,
        bins: 1.6,
    };
    assert_eq!(scene.table, board.build());
    let mut app = stepping::headless_app(&scene);
    stepping::step(&mut app, 60 * 240);
    let states = stepping::states(&mut app);
    let mut counts = vec![0; 15];
    for (i, state) in states.iter().enumerate() {
        let place = DVec2::new(state.position.x, state.position.z);
        let bin = board.bin(place);
        counts[bin.unwrap_or_else(|| panic!("ball {i} is still at {place}"))] += 1;
        let half = 0.5 * DVec2::new(scene.table.length, scene.table.width) - SMOOTH.radius;
        assert!(place.abs().cmple(half + 1e-3).all(), "ball {i} at {place}");
    }
    let (mean, variance) = moments(&counts);
    let bell = chi_square(&counts, &normal(15, mean, variance.sqrt()));
    println!(
        "{counts:?}: mean {mean:.3}, variance {variance:.3}, chi square {:.1} of {} against a normal",
        bell.0,
        bell.1 - 2
    );
    let error = (variance / states.len() as f64).sqrt();
    assert!((mean - 7.0).abs() < 4.0 * error, "{mean}, {error}");
}
