//! Balls that come down into pockets: between the noses of the jaws and the liner, on the edge, on each other.

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use proptest::sample::select;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::Laws;
use masse::physics::laws::motion::MotionLaw;
use masse::physics::laws::pocket::{PocketLaw, Rim};
use masse::physics::scene::{Scene, SceneBall};
use masse::physics::table::Preset;

use super::scenes::keep;
use super::{attack, sound};
use crate::properties::inputs::{ball_ball_law, cushion_law, motion_law, slate_law};

/// A ball over a pocket, or at its edge.
#[derive(Clone, Debug)]
struct Drop {
    /// Direction from the middle of the pocket, and how far from there as a share of its radius.
    at: (f64, f64),
    /// Height of the centre over the slate in radii of the ball.
    height: f64,
    velocity: (f64, f64, f64),
    spin: Option<(f64, f64, f64)>,
    /// Radius in m, and decimal logarithm of the mass in kg.
    body: Option<(f64, f64)>,
}

fn drop() -> impl Strategy<Value = Drop> {
    let speed = || prop_oneof![2 => Just(0.0), 1 => -0.05..0.05_f64, 1 => -2.0..2.0_f64];
    let spin = || -100.0..100.0_f64;
    (
        (-3.2..3.2_f64, 0.0..1.7_f64),
        prop_oneof![1 => Just(1.0), 3 => 1.0..5.0_f64],
        (speed(), speed(), speed()),
        prop::option::weighted(0.3, (spin(), spin(), spin())),
        prop::option::weighted(0.4, (0.02..0.055_f64, -2.0..1.0_f64)),
    )
        .prop_map(|(at, height, velocity, spin, body)| Drop {
            at,
            height,
            velocity,
            spin,
            body,
        })
}

/// One to four balls at one pocket.
fn scene() -> impl Strategy<Value = Scene> {
    let presets = vec![Preset::NineFoot, Preset::SevenFoot, Preset::Snooker];
    let motion = motion_law().prop_filter("a closed form and weight", |law| {
        MotionLaw::is_closed_form(law) && law.gravity().is_some()
    });
    let rim = (0.0..0.012_f64, 0.0..0.8_f64).prop_map(|(edge, liner_restitution)| Rim {
        edge,
        liner_restitution,
    });
    let rim = prop_oneof![Just(Rim::default()), rim];
    let any = (motion, ball_ball_law(), cushion_law(), slate_law(), rim).prop_map(
        |(motion, ball_ball, cushion, slate, rim)| Laws {
            motion,
            ball_ball,
            cushion,
            slate,
            pocket: PocketLaw::Rim(rim),
        },
    );
    let laws = prop_oneof![1 => Just(Laws::default()), 2 => any];
    let drops = prop_oneof![
        1 => prop::collection::vec(drop(), 1..2),
        2 => prop::collection::vec(drop(), 2..5),
    ];
    (select(presets), 0_usize..6, laws, drops, 0.3..2.0_f64).prop_map(
        |(preset, pocket, laws, drops, time_limit)| {
            let mut scene = Scene::new(preset.table(), laws);
            scene.time_limit = time_limit;
            for drop in &drops {
                seat(&mut scene, pocket, drop);
            }
            scene
        },
    )
}

/// Puts a ball there if it has room.
fn seat(scene: &mut Scene, pocket: usize, drop: &Drop) {
    let mut ball = Ball {
        spins: drop.spin.is_some(),
        ..Ball::POOL
    };
    if let Some((radius, power)) = drop.body {
        ball.radius = radius;
        ball.mass = libm::pow(10.0, power);
    }
    let pocket = &scene.table.pockets[pocket];
    let (angle, far) = drop.at;
    let toward = DVec2::new(libm::cos(angle), libm::sin(angle));
    let point = pocket.center + far * pocket.radius * toward;
    let mut state = State::at_rest(DVec3::new(point.x, drop.height * ball.radius, point.y));
    state.velocity = drop.velocity.into();
    if drop.height == 1.0 {
        state.velocity.y = 0.0;
    }
    state.angular_velocity = drop.spin.map_or(DVec3::ZERO, DVec3::from);
    scene.balls.push(SceneBall {
        name: scene.balls.len().to_string(),
        ball,
        state,
    });
    if scene.check().is_err() {
        scene.balls.pop();
    }
}

#[test]
fn balls_wedged_in_pockets_are_sound_by_the_exact_solver() {
    attack(200, &scene(), |scene| keep("wedged", &scene, sound::exact));
}

#[test]
fn balls_wedged_in_pockets_are_sound_by_the_stepped_solver() {
    let inputs = (scene(), select(vec![1.0 / 30.0, 1.0 / 120.0, 1e-3]));
    attack(60, &inputs, |(scene, tick)| {
        keep("stepped-wedged", &scene, |scene| {
            sound::stepped(scene, tick)
        })
    });
}
