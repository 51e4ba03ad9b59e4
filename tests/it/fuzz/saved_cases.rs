//! Every scene that ever failed, played again: `tests/data/hard`. The description of each tells what went wrong.

use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::laws::pocket::PocketLaw;
use masse::physics::scene::{Scene, SceneError};
use masse::physics::table::Preset;
use masse::scenarios::file;

use super::sound;

#[test]
fn every_scene_that_ever_failed_is_sound() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hard");
    let mut paths: Vec<_> = std::fs::read_dir(&folder)
        .expect("the folder of saved cases")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "ron"))
        .collect();
    paths.sort();
    assert!(!paths.is_empty());
    let mut failed = Vec::new();
    for path in paths {
        let scenario = file::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let ticks = [1.0 / 30.0, 1.0 / 120.0, 1e-3];
        let outcomes = std::iter::once(sound::exact(&scenario.scene))
            .chain(ticks.map(|tick| sound::stepped(&scenario.scene, tick)));
        failed.extend(
            outcomes
                .filter_map(Result::err)
                .map(|error| format!("{name}: {error}")),
        );
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

/// A pool table with one ball here.
fn lying(x: f64, z: f64, radius: f64) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let ball = Ball {
        radius,
        ..Ball::POOL
    };
    scene.place("ball", ball, x, z);
    scene
}

/// Balls were taken for lying on slate where there is wood, behind the holes and beside the throats of pockets, and rolled
/// off over nothing.
#[test]
fn a_ball_on_wood_is_refused() {
    let radius = Ball::POOL.radius;
    for (x, z) in [
        (-1.414_927, -0.660_131),
        (-1.400_852, 0.726_188),
        (1.3642, -0.6672),
        (-1.375_308, 0.567_127),
        (0.119_557, -0.7043),
        (1.388_887, -0.667_067),
    ] {
        let refused = lying(x, z, radius).check();
        let off = matches!(refused, Err(SceneError::OffTable { .. }));
        assert!(off, "{x}, {z}: {refused:?}");
    }
    // On the shelves of a side and of a corner pocket there is room.
    for (x, z) in [(0.0, 0.6), (1.2, 0.565)] {
        assert_eq!(lying(x, z, radius).check(), Ok(()), "{x}, {z}");
    }
}

/// A ball under the noses met them with its very centre, where there is no normal, and was nowhere afterwards.
#[test]
fn a_ball_that_no_nose_holds_is_refused() {
    let refused = lying(0.8, 0.0, 0.01).check();
    assert!(
        matches!(refused, Err(SceneError::NotHeld { .. })),
        "{refused:?}"
    );
    // Nor may it come down from the air: it met a nose a million times within an instant.
    let mut scene = lying(0.0, 0.0, 0.01);
    scene.balls[0].state.position.y += 0.17;
    assert!(matches!(scene.check(), Err(SceneError::NotHeld { .. })));
}

/// Two kilograms of 6 cm radius sank into a side pocket until noses, edge and liner held them from all sides: no speed led out
/// of there, and they were touched without end.
#[test]
fn a_ball_that_no_pocket_takes_is_refused() {
    let large = lying(0.2, 0.0, 0.0599);
    let refused = large.check();
    assert!(
        matches!(refused, Err(SceneError::TooLargeForPocket { .. })),
        "{refused:?}"
    );
    // Where nothing falls there is nothing to be wedged in.
    let mut captured = large;
    captured.laws.pocket = PocketLaw::Capture;
    assert_eq!(captured.check(), Ok(()));
}
