//! How the table looks: every quality shows the same things on whatever driver there is, every cloth and every style is
//! told from the others.

use bevy::math::Vec2;
use glam::DVec3;

use masse::game::settings::{ClothColour, Quality, Settings, TableStyle};
use masse::game::view::{CameraInput, CameraMode};
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use masse::window::NoDisplay;
use masse::window::snapshot::{Picture, picture_with};

fn scene() -> Scene {
    let mut scene = Scene::new(Preset::SevenFoot.table(), Laws::default());
    scene.place("cue", Ball::POOL, -0.2, 0.05);
    scene.place("2", Ball::POOL, 0.2, -0.05);
    scene.place("3", Ball::POOL, 0.2 + 2.0 * Ball::POOL.radius, -0.05);
    scene
}

/// From above, or none where there is nothing to draw with.
fn drawn(settings: &Settings) -> Option<Picture> {
    let closer = CameraInput {
        orbit: Vec2::ZERO,
        ..CameraInput::default()
    };
    match picture_with(
        &scene(),
        (320, 180),
        CameraMode::Overhead,
        &[closer],
        settings,
    ) {
        Ok(picture) => Some(picture),
        Err(NoDisplay::Adapter) => {
            println!("there is no adapter to draw with, not even a software driver");
            None
        }
        Err(error) => panic!("{error}"),
    }
}

fn colour(picture: &Picture, x: f64, y: f64, z: f64) -> [f64; 3] {
    let pixel = picture
        .pixel_of(DVec3::new(x, y, z))
        .unwrap_or_else(|| panic!("{x} {y} {z} is not in the picture"));
    picture.colour(pixel).map(f64::from)
}

#[test]
fn every_quality_shows_cloth_balls_wood_and_shade() {
    for quality in [Quality::Low, Quality::Medium, Quality::High, Quality::Ultra] {
        let settings = Settings {
            quality,
            ..Settings::default()
        };
        let Some(picture) = drawn(&settings) else {
            return;
        };
        let [red, green, blue] = colour(&picture, 0.0, 0.0, -0.2);
        assert!(
            green > 60.0 && green > 2.0 * red && green > blue && blue > red,
            "{quality:?}: cloth {red} {green} {blue}"
        );
        let top = 2.0 * Ball::POOL.radius;
        let white = colour(&picture, -0.2, top, 0.05);
        assert!(white.iter().all(|c| *c > 100.0), "{quality:?}: {white:?}");
        let [red, green, blue] = colour(&picture, 0.2, top, -0.035);
        assert!(
            blue > red && blue > green,
            "{quality:?}: the 2 is blue: {red} {green} {blue}"
        );
        // Close to a ball the cloth is darker than in the open.
        let open = colour(&picture, 0.0, 0.0, 0.05)[1];
        let close = colour(&picture, -0.2 + 1.12 * Ball::POOL.radius, 0.0, 0.05)[1];
        assert!(close < 0.97 * open, "{quality:?}: no shade: {close} {open}");
        let half = 0.5 * scene().table.width;
        let [red, _, blue] = colour(&picture, 0.12, 0.04, half + 0.1);
        assert!(red > 1.3 * blue, "{quality:?}: mahogany {red} {blue}");
    }
}

#[test]
fn no_two_cloths_and_no_two_styles_look_alike() {
    let low = Settings {
        quality: Quality::Low,
        ..Settings::default()
    };
    let apart =
        |a: &[f64; 3], b: &[f64; 3]| -> f64 { a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum() };
    let mut cloths: Vec<[f64; 3]> = Vec::new();
    for cloth in ClothColour::ALL {
        let Some(picture) = drawn(&Settings {
            cloth,
            ..low.clone()
        }) else {
            return;
        };
        cloths.push(colour(&picture, 0.0, 0.0, -0.2));
    }
    let half = 0.5 * scene().table.length;
    let mut rails: Vec<[f64; 3]> = Vec::new();
    for table in TableStyle::ALL {
        let Some(picture) = drawn(&Settings {
            table,
            wood: table.wood(),
            ..low.clone()
        }) else {
            return;
        };
        rails.push(colour(
            &picture,
            0.3 * half,
            0.04,
            0.5 * scene().table.width + 0.1,
        ));
    }
    for list in [&cloths, &rails] {
        for (i, a) in list.iter().enumerate() {
            for b in &list[..i] {
                assert!(apart(a, b) > 25.0, "{a:?} {b:?}");
            }
        }
    }
}
