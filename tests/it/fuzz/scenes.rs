//! Random valid scenes for both solvers: 1 to 60 balls of any mass and radius, to 30 m/s and 500 rad/s, by any law.

use proptest::prelude::*;
use proptest::sample::select;

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::laws::Laws;
use masse::physics::laws::motion::MotionLaw;
use masse::physics::laws::pocket::PocketLaw;
use masse::physics::scene::{PlannedShot, Rack, Scene};
use masse::physics::table::Preset;
use masse::scenarios::file::{self, Scenario};

use super::places::{guest, seat, table};
use super::{attack, sound};
use crate::cli::folder;
use crate::properties::inputs::{ball_ball_law, cushion_law, motion_law, slate_law};

/// Any laws with a closed form.
fn laws() -> impl Strategy<Value = Laws> {
    let pocket = select(PocketLaw::all());
    let motion = motion_law().prop_filter("closed form", MotionLaw::is_closed_form);
    let default = Just(Laws::default());
    prop_oneof![
        1 => default,
        4 => (motion, ball_ball_law(), cushion_law(), slate_law(), pocket).prop_map(
            |(motion, ball_ball, cushion, slate, pocket)| Laws { motion, ball_ball, cushion, slate, pocket },
        ),
    ]
}

/// Any scene that passes its check, with at least one ball.
fn scene() -> impl Strategy<Value = Scene> {
    let guests = prop_oneof![
        3 => prop::collection::vec(guest(), 1..8),
        1 => prop::collection::vec(guest(), 1..60),
    ];
    (table(), laws(), guests, any::<bool>(), 0.1..6.0_f64).prop_map(
        |(table, laws, guests, one_kind, time_limit)| {
            let mut scene = Scene::new(table, laws);
            // Without friction nothing comes to rest and many balls meet often.
            scene.time_limit = match laws.motion.gravity() {
                Some(_) => time_limit,
                None => 0.2 * time_limit,
            };
            for guest in &guests {
                seat(&mut scene, guest, one_kind);
            }
            scene
        },
    )
}

/// Breaks as nobody plays them: up to 30 m/s, jumped, with all english that the tip holds.
fn extreme_break() -> impl Strategy<Value = Scene> {
    let shot = (
        -0.06..0.06_f64,
        0.0..0.5_f64,
        (-0.4..0.4_f64, -0.4..0.4_f64),
        3.0..20.0_f64,
    );
    (
        select(Preset::NAMED.to_vec()),
        select(vec![Rack::NineBall, Rack::EightBall]),
        select(vec![0.0, 1e-9, 1e-6, 1e-4, 1e-3]),
        any::<u64>(),
        shot,
        prop::option::weighted(0.3, laws()),
    )
        .prop_map(
            |(preset, rack, gap, seed, (heading, elevation, (side, height), speed), laws)| {
                let mut scene = Scene::new(preset.table(), laws.unwrap_or_default());
                rack.place(&mut scene, Ball::POOL, gap, seed);
                let elevation = if elevation < 0.25 { 0.0 } else { elevation };
                let shot = Shot {
                    heading,
                    elevation,
                    side,
                    height,
                    speed,
                };
                scene.shot = Some(PlannedShot { ball: 0, shot });
                scene.time_limit = if scene.laws.motion.gravity().is_some() {
                    20.0
                } else {
                    1.0
                };
                scene
            },
        )
        .prop_filter("playable", |scene| scene.check().is_ok())
}

/// Runs a check and writes the scene down if it fails.
pub fn keep(
    name: &str,
    scene: &Scene,
    check: impl Fn(&Scene) -> Result<u64, String>,
) -> Result<(), String> {
    if scene.check().is_err() {
        return Ok(());
    }
    let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| check(scene)));
    let outcome = outcome.unwrap_or_else(|_| Err("it panics".to_owned()));
    outcome.map(|_| ()).map_err(|error| {
        let scenario = Scenario::plain(name, &error, scene.clone());
        let text = file::write(&scenario).unwrap_or_else(|error| error.to_string());
        let place = folder(&format!("fuzz-{name}")).join("failed.ron");
        let _ = std::fs::write(&place, text);
        format!("{error}\nthe scene is in {}", place.display())
    })
}

#[test]
fn any_scene_is_sound_by_the_exact_solver() {
    attack(150, &scene(), |scene| keep("exact", &scene, sound::exact));
}

#[test]
fn any_scene_is_sound_by_the_stepped_solver() {
    let inputs = (scene(), select(vec![1.0 / 30.0, 1.0 / 120.0, 1e-3]));
    attack(60, &inputs, |(scene, tick)| {
        keep("stepped", &scene, |scene| sound::stepped(scene, tick))
    });
}

#[test]
fn extreme_breaks_are_sound_by_the_exact_solver() {
    attack(60, &extreme_break(), |scene| {
        keep("breaks", &scene, sound::exact)
    });
}

#[test]
fn extreme_breaks_are_sound_by_the_stepped_solver() {
    attack(15, &extreme_break(), |scene| {
        keep("stepped-breaks", &scene, |scene| {
            sound::stepped(scene, 1.0 / 120.0)
        })
    });
}

#[test]
fn a_scene_file_keeps_every_bit() {
    attack(200, &scene(), |scene| {
        if scene.balls.is_empty() {
            return Ok(());
        }
        let scenario = Scenario::plain("random", "", scene);
        let text = file::write(&scenario).map_err(|error| error.to_string())?;
        let back = file::parse(&text, "random").map_err(|error| format!("{error}\n{text}"))?;
        if back == scenario {
            Ok(())
        } else {
            Err(format!("{back:?}\nis not\n{scenario:?}"))
        }
    });
}
