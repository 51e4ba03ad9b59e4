//! From the table into the menu and back, and what is played meanwhile.

use bevy::input::ButtonState;
use bevy::prelude::*;
use bevy_egui::egui;
use masse::game::aim::Aim;
use masse::game::practice::Practice;
use masse::game::settings::Settings;
use masse::physics::scene::Rack;
use masse::sim::components::{BallIndex, Position};
use masse::window::page::{PageId, Screen};

use super::{app, choose, focused_place, for_input, key, page, press, screen, step, tab_to};

fn balls(app: &mut App) -> usize {
    let world = app.world_mut();
    world.query::<&BallIndex>().iter(world).count()
}

/// Frames until this holds; there is an end to patience.
fn until(app: &mut App, holds: impl Fn(&mut App) -> bool) {
    for _ in 0..400 {
        if holds(app) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
        step(app);
    }
    panic!("it never happened");
}

#[test]
fn with_keys_alone_a_new_game_is_begun_and_the_menu_left() {
    let mut app = app();
    assert_eq!(screen(&app), Screen::Table);
    press(&mut app, KeyCode::Escape);
    assert_eq!(
        (screen(&app), page(&app)),
        (Screen::Menu, Some(PageId::MAIN))
    );
    assert!(app.world().resource::<Time<Virtual>>().is_paused());

    choose(&mut app, "Practice and scenes");
    assert_eq!(page(&app), Some(PageId::NEW_GAME));
    choose(&mut app, "Rack 9-ball");
    assert_eq!((screen(&app), page(&app)), (Screen::Table, None));
    assert!(!app.world().resource::<Time<Virtual>>().is_paused());
    until(&mut app, |app| balls(app) == 10);
    assert_eq!(app.world().resource::<Practice>().rack, Rack::NineBall);

    press(&mut app, KeyCode::Escape);
    choose(&mut app, "Practice and scenes");
    choose(&mut app, "Stop shot");
    until(&mut app, |app| balls(app) == 2);
    assert!(
        app.world().resource::<Practice>().history.len() >= 2,
        "both can be undone"
    );
}

#[test]
fn escape_goes_back_page_by_page_and_never_ends_the_program() {
    let mut app = app();
    for _ in 0..3 {
        press(&mut app, KeyCode::Escape);
        choose(&mut app, "Settings");
        choose(&mut app, "Sound");
        assert_eq!(page(&app), Some(PageId("settings-sound")));
        press(&mut app, KeyCode::Escape);
        assert_eq!(page(&app), Some(PageId::SETTINGS));
        press(&mut app, KeyCode::Escape);
        assert_eq!(page(&app), Some(PageId::MAIN));
        press(&mut app, KeyCode::Escape);
        assert_eq!(screen(&app), Screen::Table);
    }
    assert!(app.should_exit().is_none());
    press(&mut app, KeyCode::Escape);
    assert!(tab_to(&mut app, "Quit"));
    key(&mut app, KeyCode::Enter, ButtonState::Pressed);
    assert!(app.should_exit().is_some());
}

#[test]
fn the_pointer_chooses_too() {
    let mut app = app();
    press(&mut app, KeyCode::Escape);
    assert!(tab_to(&mut app, "Settings"));
    let at = focused_place(&mut app).center();
    press(&mut app, KeyCode::Escape);
    press(&mut app, KeyCode::Escape);
    assert_eq!(page(&app), Some(PageId::MAIN));
    for pressed in [true, false] {
        for_input(&mut app, |input| {
            input.events.push(egui::Event::PointerMoved(at));
            input.events.push(egui::Event::PointerButton {
                pos: at,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: egui::Modifiers::NONE,
            });
        });
        step(&mut app);
    }
    step(&mut app);
    assert_eq!(page(&app), Some(PageId::SETTINGS));
}

#[test]
fn no_key_of_the_table_works_in_the_menu() {
    let mut app = app();
    let before = *app.world().resource::<Aim>();
    press(&mut app, KeyCode::Escape);
    for code in [
        KeyCode::KeyN,
        KeyCode::KeyX,
        KeyCode::KeyB,
        KeyCode::KeyA,
        KeyCode::KeyM,
    ] {
        press(&mut app, code);
    }
    assert_eq!(*app.world().resource::<Aim>(), before);
    assert!(!app.world().resource::<Practice>().placing);
    assert!(!app.world().resource::<Settings>().volume.muted);
    press(&mut app, KeyCode::Escape);
    press(&mut app, KeyCode::KeyM);
    assert!(
        app.world().resource::<Settings>().volume.muted,
        "at the table it does"
    );
}

#[test]
fn balls_wait_for_the_menu_only_if_they_shall() {
    let mut app = app();
    app.world_mut().resource_mut::<Settings>().pause_in_menu = false;
    press(&mut app, KeyCode::Escape);
    assert_eq!(screen(&app), Screen::Menu);
    assert!(!app.world().resource::<Time<Virtual>>().is_paused());
}

#[test]
fn balls_are_placed_with_keys_alone() {
    let mut app = app();
    let place = |app: &mut App, ball: usize| {
        let world = app.world_mut();
        let mut all = world.query::<(&BallIndex, &Position)>();
        let found = all.iter(world).find(|(index, _)| index.0 == ball);
        found.expect("it is there").1.0
    };
    let (cue, next) = (place(&mut app, 0), place(&mut app, 1));
    press(&mut app, KeyCode::KeyB);
    assert!(app.world().resource::<Practice>().placing);
    // A step is a centimetre, as it is seen on the screen.
    let seen = |app: &mut App, way: bevy::math::DVec3| {
        let world = app.world_mut();
        let mut cameras = world.query_filtered::<&GlobalTransform, With<Camera3d>>();
        let camera = cameras.single(world).expect("there is one");
        let right = camera.right().as_vec3().as_dvec3().with_y(0.0).normalize();
        (way.dot(right), way.cross(right).y)
    };
    let stepped = |app: &mut App, ball: usize, from: bevy::math::DVec3| {
        until(app, |app| {
            ((place(app, ball) - from).length() - 0.01).abs() < 1e-5
        });
        let way = place(app, ball) - from;
        seen(app, way)
    };
    press(&mut app, KeyCode::ArrowRight);
    let (right, _) = stepped(&mut app, 0, cue);
    assert!(right > 0.0099, "{right}");
    let cue = place(&mut app, 0);
    press(&mut app, KeyCode::ArrowUp);
    let (right, away) = stepped(&mut app, 0, cue);
    assert!(right.abs() < 1e-3 && away.abs() > 0.0099, "{right} {away}");
    press(&mut app, KeyCode::Period);
    press(&mut app, KeyCode::ArrowLeft);
    stepped(&mut app, 1, next);
    press(&mut app, KeyCode::Escape);
    assert!(!app.world().resource::<Practice>().placing);
    assert_eq!(screen(&app), Screen::Table, "Esc closed one thing only");
}
