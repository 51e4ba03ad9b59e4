//! Pockets as they are: hang, tip, fall, rattle.

use glam::{DVec2, DVec3};

use masse::physics::ball::{Ball, Motion, State};
use masse::physics::laws::Laws;
use masse::physics::laws::pocket::{PocketLaw, Rim};
use masse::physics::record::{EndReason, EventKind, Record};
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

use super::play;

const R: f64 = Ball::POOL.radius;

/// One ball on a nine-foot table that rolls straight at the middle of the foot-left corner pocket, to stop after this
/// way in m beyond the edge of its slate.
fn roll_to(beyond: f64) -> (Scene, DVec2) {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let pocket = scene
        .table
        .pockets
        .iter()
        .find(|pocket| pocket.name == "foot left")
        .expect("there is one");
    let (center, radius) = (pocket.center, pocket.radius);
    let from = center + DVec2::new(-0.5, 0.5);
    let way = from.distance(center) - radius + beyond;
    let speed = (2.0 * 0.01 * 9.81 * way).sqrt();
    let direction = (center - from).normalize();
    let ball = scene.place("1", Ball::POOL, from.x, from.y);
    let velocity = speed * DVec3::new(direction.x, 0.0, direction.y);
    scene.balls[ball].state.velocity = velocity;
    scene.balls[ball].state.angular_velocity = Ball::POOL.rolling_spin(velocity);
    (scene, center)
}

fn potted(record: &Record) -> bool {
    record.end[0].motion == Motion::Pocketed
}

#[test]
fn a_slow_ball_hangs_or_tips_by_where_its_centre_is() {
    for beyond in [1e-3, 1e-5, 1e-7] {
        let (hanging, center) = roll_to(-beyond);
        let record = play(&hanging);
        assert!(!potted(&record), "falls though it stops {beyond} m before");
        let end = record.end[0].position;
        let gap = center.distance(DVec2::new(end.x, end.z)) - hanging.table.pockets[4].radius;
        assert!(
            (gap - beyond).abs() < 1e-10,
            "hangs {gap} m before the edge"
        );
        assert_eq!(end.y, R);
        let (tipping, _) = roll_to(beyond);
        assert!(potted(&play(&tipping)), "hangs though {beyond} m beyond");
    }
}

/// Rolls a ball over a rounded edge by the equation of motion of the angle, φ'' = (5/7) (g/ℓ) sin φ, in fine steps of
/// fourth order, until the edge no longer presses: time, angle and rate.
fn pendulum(speed: f64, edge: f64) -> (f64, f64, f64) {
    let length = R + edge;
    let pull = 5.0 / 7.0 * 9.81 / length;
    let (mut angle, mut rate, mut time) = (0.0_f64, speed / length, 0.0);
    let step = 1e-6;
    while rate * rate * length < 9.81 * libm::cos(angle) {
        let slope = |angle: f64, rate: f64| (rate, pull * libm::sin(angle));
        let a = slope(angle, rate);
        let b = slope(angle + 0.5 * step * a.0, rate + 0.5 * step * a.1);
        let c = slope(angle + 0.5 * step * b.0, rate + 0.5 * step * b.1);
        let d = slope(angle + step * c.0, rate + step * c.1);
        angle += step / 6.0 * (a.0 + 2.0 * b.0 + 2.0 * c.0 + d.0);
        rate += step / 6.0 * (a.1 + 2.0 * b.1 + 2.0 * c.1 + d.1);
        time += step;
    }
    (time, angle, rate)
}

#[test]
fn a_slow_ball_rolls_over_the_edge_as_a_pendulum_does() {
    for beyond in [0.0005, 0.005, 0.05, 0.5] {
        let (scene, _) = roll_to(beyond);
        let record = play(&scene);
        let at = |to: Motion| {
            record
                .events
                .iter()
                .find(|event| event.first.after.motion == to)
                .expect("it tips and falls")
        };
        let (tips, falls) = (at(Motion::Tipping), at(Motion::Airborne));
        let speed = tips.first.before.velocity.length();
        let (time, angle, rate) = pendulum(speed, 0.003);
        let took = falls.time - tips.time;
        assert!((took / time - 1.0).abs() < 2e-3, "{took} s, not {time} s");
        let velocity = falls.first.after.velocity;
        let length = R + 0.003;
        assert!((velocity.length() - rate * length).abs() < 1e-5);
        assert!((velocity.y + rate * length * libm::sin(angle)).abs() < 1e-5);
        // Rolling: the point that touches the edge does not slip.
        let inward = DVec3::new(velocity.x, 0.0, velocity.z).normalize();
        let normal = libm::cos(angle) * DVec3::Y + libm::sin(angle) * inward;
        let slip = velocity - R * falls.first.after.angular_velocity.cross(normal);
        assert!(slip.length() < 1e-5, "slips at {slip}");
        // On the way it stays on the edge.
        for i in 0..100 {
            let state = record.state_at(0, tips.time + took * f64::from(i) / 100.0);
            let center = scene.table.pockets[4].center;
            let out = scene.table.pockets[4].radius
                - center.distance(DVec2::new(state.position.x, state.position.z));
            let up = state.position.y + 0.003;
            let distance = (out * out + up * up).sqrt();
            assert!((distance - length).abs() < 5e-5, "{distance} m");
        }
    }
}

#[test]
fn the_fall_is_seen_and_ends_at_the_bottom() {
    let (scene, _) = roll_to(0.2);
    let record = play(&scene);
    let tips = record
        .events
        .iter()
        .find(|event| event.first.after.motion.flies())
        .expect("it tips")
        .time;
    let gone = record
        .events
        .iter()
        .find(|event| matches!(event.kind, EventKind::Pocketed { .. }))
        .expect("it falls");
    let depth = scene.table.pockets[4].depth;
    assert!((gone.first.before.position.y + depth).abs() < 1e-12);
    assert!(gone.time - tips > (2.0 * (R + depth) / 9.81_f64).sqrt());
    let mut height = R;
    for i in 1..=200 {
        let time = tips + (gone.time - tips) * f64::from(i) / 200.0;
        let now = record.state_at(0, time.min(gone.time - 1e-9)).position.y;
        assert!(now <= height + 1e-6, "rises in the pocket");
        height = now;
    }
}

/// Plays a ball from the middle of the table at the mouth of the foot-left corner, `aside` m from the middle of the hole.
fn play_at(aside: f64, speed: f64, pocket: PocketLaw) -> (Scene, Record) {
    let mut scene = Scene::new(
        Preset::NineFoot.table(),
        Laws {
            pocket,
            ..Laws::default()
        },
    );
    let center = scene.table.pockets[4].center;
    let from = DVec2::new(0.4, 0.1);
    let direction = (center - from).normalize();
    let start = from + aside * direction.perp();
    let ball = scene.place("1", Ball::POOL, start.x, start.y);
    let velocity = speed * DVec3::new(direction.x, 0.0, direction.y);
    scene.balls[ball].state.velocity = velocity;
    scene.balls[ball].state.angular_velocity = Ball::POOL.rolling_spin(velocity);
    let record = play(&scene);
    (scene, record)
}

/// Width in m of the offsets, stroke by stroke of 0.5 mm, from which a ball drops on its first way to the pocket.
fn opening(speed: f64) -> f64 {
    let drops = |aside: f64| {
        let (_, record) = play_at(aside, speed, PocketLaw::Rim(Rim::default()));
        record
            .events
            .iter()
            .take_while(|event| {
                // A cushion far from the pocket is another way.
                let place = event.first.before.position;
                !(matches!(event.kind, EventKind::Cushion { .. }) && place.x < 1.0)
            })
            .any(|event| matches!(event.kind, EventKind::Pocketed { .. }))
    };
    5e-4 * (-200..=200)
        .filter(|step| drops(5e-4 * f64::from(*step)))
        .count() as f64
}

#[test]
fn a_pocket_takes_less_of_a_fast_ball() {
    let widths: Vec<f64> = [0.6, 2.0, 5.0].map(opening).to_vec();
    println!("opening for 0.6, 2 and 5 m/s: {widths:?} m");
    assert!(widths[0] > 0.03 && widths[0] < 0.116, "{widths:?}");
    assert!(
        widths[0] >= widths[1] && widths[1] >= widths[2],
        "{widths:?}"
    );
}

#[test]
fn no_ball_is_taken_before_the_end_of_the_slate() {
    let mut rattled = 0;
    for law in [PocketLaw::Capture, PocketLaw::Rim(Rim::default())] {
        for step in -60..=60 {
            for speed in [0.5, 3.0, 12.0] {
                let (scene, record) = play_at(1e-3 * f64::from(step), speed, law);
                assert_eq!(record.reason, Some(EndReason::Rest));
                let hole = |state: &State| {
                    let place = DVec2::new(state.position.x, state.position.z);
                    scene
                        .table
                        .pockets
                        .iter()
                        .map(|pocket| place.distance(pocket.center) - pocket.radius)
                        .fold(f64::INFINITY, f64::min)
                };
                for event in &record.events {
                    let (before, after) = (event.first.before, event.first.after);
                    if !before.motion.flies() && (after.motion.flies() || !after.motion.in_play()) {
                        assert!(hole(&before).abs() < 1e-9, "{} m before", hole(&before));
                    }
                    rattled += usize::from(event.kind == EventKind::Slate);
                    if !after.motion.flies() && after.motion.in_play() {
                        assert!(hole(&after) > -1e-9, "on air: {event:?}");
                    }
                }
            }
        }
    }
    println!("{rattled} returns to the slate");
}
