//! The window without a person: one frame from the software driver, and the order of the systems that draw it.

use std::collections::HashMap;

use bevy::ecs::schedule::Schedules;
use bevy::prelude::*;
use glam::DVec3;

use masse::game::view::CameraMode;
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use masse::sim::playfield::lay_out;
use masse::window::snapshot::{Picture, picture};
use masse::window::{unseen, windowed};

fn scene() -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.place("cue", Ball::POOL, -0.6, 0.0);
    scene.place("2", Ball::POOL, 0.3, 0.2);
    scene.place("3", Ball::POOL, 0.5, -0.3);
    scene
}

/// Mean colour of the pixels around a point of the world, in the order red, green, blue.
fn colour_at(picture: &Picture, x: f64, y: f64, z: f64) -> [f64; 3] {
    let point = DVec3::new(x, y, z);
    let (column, row) = picture
        .pixel_of(point)
        .unwrap_or_else(|| panic!("{point} is not in the picture"));
    let mut sum = [0.0; 3];
    for (dx, dy) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let colour = picture.colour((column + dx, row + dy));
        for channel in 0..3 {
            sum[channel] += f64::from(colour[channel]) / 4.0;
        }
    }
    sum
}

#[test]
fn a_frame_shows_cloth_balls_rails_and_pockets_where_they_are() {
    let scene = scene();
    let picture = picture(&scene, (640, 360), CameraMode::Overhead, &[])
        .expect("a software driver is enough to draw with");
    let top = |name: &str| {
        let state = scene.balls[scene.ball_named(name).expect("placed above")].state;
        // Beside the number that lies on top.
        let at = state.position + DVec3::new(0.0, 0.02, 0.019);
        colour_at(&picture, at.x, at.y, at.z)
    };

    let [red, green, blue] = colour_at(&picture, 0.1, 0.0, -0.1);
    assert!(
        green > 60.0 && green > 2.0 * red && blue > red && green > blue,
        "cloth {red} {green} {blue}"
    );

    let [red, green, blue] = top("cue");
    assert!(
        red.min(green).min(blue) > 110.0,
        "cue ball {red} {green} {blue}"
    );
    let [red, green, blue] = top("2");
    assert!(
        blue > 1.5 * red && blue > 1.3 * green,
        "the 2 is blue: {red} {green} {blue}"
    );
    let [red, green, blue] = top("3");
    assert!(
        red > 2.0 * green && red > 2.0 * blue,
        "the 3 is red: {red} {green} {blue}"
    );

    let [red, green, blue] = colour_at(&picture, 0.8, 0.042, 0.76);
    assert!(
        red > 1.4 * green && red > 1.4 * blue && red > 25.0,
        "rail {red} {green} {blue}"
    );

    for pocket in &scene.table.pockets {
        let [red, green, blue] = colour_at(&picture, pocket.center.x, 0.0, pocket.center.y);
        assert!(
            red.max(green).max(blue) < 40.0,
            "{} {red} {green} {blue}",
            pocket.name
        );
    }
}

/// The whole windowed program, with neither window nor graphics card nor loudspeaker.
pub(crate) fn blind() -> App {
    let mut app = App::new();
    app.add_plugins(unseen()).add_plugins(windowed());
    lay_out(app.world_mut(), &scene());
    app.finish();
    app.cleanup();
    app
}

/// Pairs of systems without an order that touch the same data and at least one of which has a name that starts so.
fn ambiguities(app: &App, start: &str) -> Vec<String> {
    let mut found = Vec::new();
    let components = app.world().components();
    for (label, schedule) in app.world().resource::<Schedules>().iter() {
        // A schedule that has not run yet is not built yet.
        let Ok(systems) = schedule.systems() else {
            continue;
        };
        let names: HashMap<_, _> = systems
            .map(|(key, system)| (key, system.name().to_string()))
            .collect();
        for (first, second, what) in schedule.graph().conflicting_systems().iter() {
            let (first, second) = (&names[first], &names[second]);
            // A point at which commands are applied changes only what the systems before it asked for.
            if [first, second]
                .iter()
                .any(|name| name.ends_with("apply_deferred"))
            {
                continue;
            }
            if first.starts_with(start) || second.starts_with(start) {
                let what: Vec<_> = what.iter().map(|id| components.get_name(*id)).collect();
                found.push(format!("{label:?}: {first} and {second} on {what:?}"));
            }
        }
    }
    found
}

#[test]
fn the_windowed_app_has_no_ambiguity_of_ours_in_any_schedule() {
    let mut app = blind();
    for _ in 0..4 {
        app.update();
    }
    let found = ambiguities(&app, "masse::");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn an_ambiguity_in_the_windowed_app_is_found() {
    fn first(mut view: ResMut<masse::game::view::View>) {
        view.trails = true;
    }
    fn second(mut view: ResMut<masse::game::view::View>) {
        view.trails = false;
    }
    let mut app = blind();
    app.add_systems(Last, (first, second));
    app.update();
    let found = ambiguities(
        &app,
        "it::window::an_ambiguity_in_the_windowed_app_is_found::first",
    );
    assert_eq!(found.len(), 1, "{found:?}");
}
