//! Crowds on cloth against the exact solver.

use masse::physics::ball::Ball;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::Solver;
use masse::sim::stepped::crowd::Crowd;
use masse::sim::stepping;

use super::{SMOOTH, as_crowd, gas, play};

/// Until chaos has its way, the tick makes no difference.
#[test]
fn slide_roll_and_spin_follow_the_exact_solver() {
    for (ball, speed) in [(Ball::POOL, 0.6), (SMOOTH, 0.6)] {
        let mut scene = gas(49, 0.2, speed, Laws::default(), ball);
        for (k, placed) in scene.balls.iter_mut().enumerate() {
            if ball.spins {
                placed.state.angular_velocity = glam::DVec3::new(10.0, 0.3 * k as f64 - 7.0, 5.0);
            }
        }
        let mut exact = scene.clone();
        exact.solver = Solver::Exact;
        for rate in [60_u32, 240] {
            let ticks = rate / 2;
            let rate = f64::from(rate);
            exact.time_limit = 0.5;
            let record = solve(&exact, Limits::default()).expect("a sound scene");
            assert!(record.events.len() > 80, "{} events", record.events.len());
            as_crowd(&mut scene, 1.0 / rate, None);
            let (states, _) = play(&scene, ticks, 1);
            for (i, (one, other)) in states.iter().zip(&record.end).enumerate() {
                let error = (one.position - other.position).length();
                assert!(error < 1e-9, "{rate} Hz, ball {i}: {error} m");
                let error = (one.angular_velocity - other.angular_velocity).length();
                assert!(error < 1e-6, "{rate} Hz, ball {i}: {error} rad/s");
                assert_eq!(one.motion, other.motion, "{rate} Hz, ball {i}");
            }
        }
    }
}

#[test]
fn a_crowd_on_cloth_comes_to_rest_and_never_gains_energy() {
    let scene = gas(900, 0.4, 1.0, Laws::default(), Ball::POOL);
    let mut last = f64::INFINITY;
    let mut app = masse::sim::stepping::headless_app(&scene);
    for tick in 0..4000 {
        masse::sim::stepping::step(&mut app, 1);
        let energy = app
            .world()
            .resource::<masse::sim::stepped::crowd::Census>()
            .energy;
        assert!(
            energy <= last * (1.0 + 1e-12),
            "tick {tick}: {last} J became {energy} J"
        );
        last = energy;
        if !app.world().resource::<masse::sim::clock::Clock>().moving {
            break;
        }
    }
    assert_eq!(last, 0.0);
    assert!(!app.world().resource::<masse::sim::clock::Clock>().moving);
}

/// A ball that rests is not written again and again, but one that was hit is, at once.
#[test]
fn components_are_the_states_of_the_crowd_also_of_balls_that_rested_for_long() {
    let mut scene = gas(400, 0.3, 0.0, Laws::default(), Ball::POOL);
    scene.balls[0].state.velocity = glam::DVec3::new(3.0, 0.0, 2.6);
    scene.balls[399].state.angular_velocity.y = 60.0;
    let start: Vec<_> = scene.balls.iter().map(|ball| ball.state.position).collect();
    let mut app = stepping::headless_app(&scene);
    let mut late = 0;
    for tick in 0..300 {
        stepping::step(&mut app, 1);
        let states = stepping::states(&mut app);
        let crowd = app.world().resource::<Crowd>();
        for (number, state) in states.iter().enumerate() {
            assert_eq!(Some(*state), crowd.state(number), "tick {tick}, {number}");
            late += u32::from(tick == 100 && state.position == start[number]);
        }
    }
    let end = stepping::states(&mut app);
    let stayed = end
        .iter()
        .zip(&start)
        .filter(|(state, start)| state.position == **start);
    let stayed = stayed.count() as u32;
    assert!(stayed > 100, "{stayed} were never hit");
    assert!(
        late > stayed,
        "{late} lay still after 100 ticks, {stayed} for good"
    );
}
