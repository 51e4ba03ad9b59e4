//! A shared picture: another camera, the cameras of a scene, other laws; and how far a stroke may vary.

use bevy::prelude::*;
use masse::game::aim::Aim;
use masse::game::equip::OpenScene;
use masse::game::twin::{Twin, TwinLaws};
use masse::game::view::{Beside, CameraMode, FirstEye, View};
use masse::sim::clock::Clock;
use masse::window::{Heat, Stage};

use super::{app, choose, press, settle, step, until};

fn view(app: &App) -> View {
    *app.world().resource::<View>()
}

/// How many cameras look at the table, and how many of them are the first.
fn eyes(app: &mut App) -> (usize, usize) {
    let world = app.world_mut();
    let mut cameras = world.query_filtered::<&Camera, With<Camera3d>>();
    let all = cameras
        .iter(world)
        .filter(|camera| camera.is_active)
        .count();
    let first = world
        .query_filtered::<&Camera3d, With<FirstEye>>()
        .iter(world)
        .count();
    (all, first)
}

fn open(app: &mut App, name: &str) {
    app.world_mut().write_message(OpenScene {
        name: name.to_owned(),
        play: false,
    });
    until(app, name, |app| {
        let stage = app.world().resource::<Stage>();
        let messages = app.world().resource::<Messages<OpenScene>>();
        stage.on_table().is_some_and(|on| on.name == name)
            && messages.is_empty()
            && !app.world().resource::<Clock>().moving
    });
    settle(app);
}

#[test]
fn a_second_camera_comes_and_goes_with_its_key() {
    let mut app = app();
    assert_eq!(eyes(&mut app), (1, 1));
    press(&mut app, KeyCode::F7);
    assert_eq!(view(&app).beside, Beside::Camera(CameraMode::Overhead));
    assert_eq!(eyes(&mut app), (2, 1));
    press(&mut app, KeyCode::KeyC);
    assert_eq!(view(&app).camera, CameraMode::Overhead);
    press(&mut app, KeyCode::F7);
    assert_eq!(view(&app).beside, Beside::Nothing);
    assert_eq!(eyes(&mut app), (1, 1));
}

#[test]
fn a_scene_opens_with_its_first_camera_and_its_others_are_gone_through() {
    let mut app = app();
    open(&mut app, "power-draw");
    assert_eq!(view(&app).camera, CameraMode::Overhead);
    press(&mut app, KeyCode::F9);
    assert_eq!(view(&app).camera, CameraMode::Scene(1));
    press(&mut app, KeyCode::F7);
    assert_eq!(view(&app).beside, Beside::Camera(CameraMode::Overhead));
    press(&mut app, KeyCode::F9);
    assert_eq!(view(&app).camera, CameraMode::Overhead);
    press(&mut app, KeyCode::F9);
    // Its cameras go with the scene.
    press(&mut app, KeyCode::KeyN);
    until(&mut app, "a rack", |app| {
        app.world().resource::<Stage>().on_table().is_none()
    });
    step(&mut app);
    assert_eq!(view(&app).camera, CameraMode::BehindCue);
}

#[test]
fn the_coursework_is_played_beside_real_physics_and_goes_on_to_its_own_end() {
    let mut app = app();
    open(&mut app, "real-draw-english");
    press(&mut app, KeyCode::F8);
    assert_eq!(view(&app).beside, Beside::Laws);
    assert_eq!(eyes(&mut app), (2, 1));
    assert!(app.world().resource::<Twin>().record.is_none());
    press(&mut app, KeyCode::F5);
    until(&mut app, "a twin that moves", |app| {
        let twin = app.world().resource::<Twin>();
        twin.record.is_some() && twin.time > 0.2
    });
    let twin = app.world().resource::<Twin>();
    assert_eq!((twin.laws, &twin.failed), (TwinLaws::Coursework, &None));
    let record = twin.record.as_ref().expect("it is there");
    assert_eq!(twin.state(0), Some(record.state_at(0, twin.time)));
    let end = record.end_time;
    until(&mut app, "both ends", |app| {
        !app.world().resource::<Clock>().moving && app.world().resource::<Twin>().time >= end
    });
    press(&mut app, KeyCode::F8);
    assert_eq!(eyes(&mut app), (1, 1));
}

#[test]
fn the_studio_tells_how_far_a_stroke_may_vary() {
    let mut app = app();
    open(&mut app, "stop-shot");
    press(&mut app, KeyCode::F2);
    choose(&mut app, "How much it may vary");
    choose(&mut app, "Work it out");
    assert!(app.world().resource::<Heat>().is_working());
    until(&mut app, "a map", |app| {
        app.world().resource::<Heat>().met().is_some()
    });
    let met = app.world().resource::<Heat>().met();
    // The same as the functions below say.
    let mut scenario = masse::scenarios::library::open("stop-shot").expect("it is built in");
    // The butt of the cue may be raised where there is no room for it.
    let aimed = app.world().resource::<Aim>().shot;
    scenario.scene.shot.as_mut().expect("it has a shot").shot = aimed;
    let dials = (
        masse::scenarios::dial::Dial::Heading,
        masse::scenarios::dial::Dial::Speed,
    );
    let map = masse::scenarios::sensitivity::map(&scenario, dials, 41).expect("it is met");
    assert_eq!(met, Some(map.met()));
}
