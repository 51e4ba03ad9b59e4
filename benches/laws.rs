//! What one impact costs by each registered law, over many states of the ball: `cargo bench --no-default-features --bench laws`.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use masse::physics::ball::{Ball, Motion, State};
use masse::physics::laws::ball_ball::{BallBallLaw, PairContact};
use masse::physics::laws::cushion::{CushionContact, CushionLaw};
use masse::physics::table::Nose;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const STATES: usize = 1000;

/// Balls that come at a cushion or at another ball at x > 0; every fourth one rolls.
fn states() -> Vec<State> {
    let mut random = ChaCha8Rng::seed_from_u64(2010);
    let mut draw = || random.random_range(-2.0..2.0);
    (0..STATES)
        .map(|i| {
            let velocity = DVec3::new(draw() + 2.1, 0.0, draw());
            let spin = DVec3::new(draw(), draw(), draw()) / Ball::POOL.radius;
            State {
                position: DVec3::Y * Ball::POOL.radius,
                velocity,
                angular_velocity: match i % 4 {
                    0 => Ball::POOL.rolling_spin(velocity),
                    _ => spin,
                },
                motion: Motion::Sliding,
            }
        })
        .collect()
}

fn name_of(law: &impl std::fmt::Debug) -> String {
    let text = format!("{law:?}");
    let end = text.find(|letter: char| !letter.is_alphanumeric());
    text[..end.unwrap_or(text.len())].to_owned()
}

fn laws(criterion: &mut Criterion) {
    let states = states();
    let ball = Ball::POOL;
    let mut group = criterion.benchmark_group("rebound");
    group.throughput(Throughput::Elements(STATES as u64));
    let contact = CushionContact {
        normal: -DVec3::X,
        nose_height: 1.4 * ball.radius,
        nose: Nose::Round { radius: 0.0 },
        restitution: None,
    };
    for law in CushionLaw::all() {
        group.bench_function(name_of(&law), |bench| {
            bench.iter(|| {
                for state in &states {
                    black_box(law.rebound(&ball, black_box(state), &contact));
                }
            });
        });
    }
    group.finish();
    let mut group = criterion.benchmark_group("collision");
    group.throughput(Throughput::Elements(STATES as u64));
    for law in BallBallLaw::all() {
        group.bench_function(name_of(&law), |bench| {
            bench.iter(|| {
                for state in &states {
                    let other = State::at_rest(state.position + 2.0 * ball.radius * DVec3::X);
                    let contact = PairContact::between(state, &other);
                    black_box(law.collide((&ball, black_box(state)), (&ball, &other), &contact));
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, laws);
criterion_main!(benches);
