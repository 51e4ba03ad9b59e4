//! Settings that take effect at once, and controls that are asked for.

use bevy::input::ButtonState;
use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;
use bevy_egui::{EguiContext, egui};
use masse::game::settings::Settings;
use masse::game::view::View;
use masse::window::action::{Action, Bindings, Control};
use masse::window::language::Language;
use masse::window::page::{Open, PageId, Screen};

use super::{app, choose, for_input, is_pressed, key, page, press, screen, step};

fn open(app: &mut App, id: &'static str) {
    app.world_mut().resource_mut::<Open>().go(PageId(id));
    step(app);
    step(app);
}

#[test]
fn a_language_is_spoken_at_once_and_scale_and_switches_are_set_with_keys() {
    let mut app = app();
    open(&mut app, "settings-general");
    choose(&mut app, "Deutsch");
    assert_eq!(app.world().resource::<Language>().code(), "de");
    let settings = app.world().resource::<Settings>();
    assert_eq!(settings.language.as_deref(), Some("de"));
    choose(&mut app, "125 %");
    choose(&mut app, "Weniger Bewegung");
    choose(&mut app, "Ein Muster für jede Farbe");
    choose(&mut app, "Aufrechte Nummern über den Kugeln");
    let settings = app.world().resource::<Settings>();
    assert_eq!(settings.scale, 1.25);
    assert!(settings.reduced_motion && settings.marks.patterns && settings.marks.labels);
    choose(&mut app, "Zurück");
    choose(&mut app, "Einstellungen");
    choose(&mut app, "Alles wie am Anfang");
    assert_eq!(*app.world().resource::<Settings>(), Settings::default());
}

#[test]
fn letters_stay_so_small_that_the_window_can_be_used() {
    let mut app = app();
    app.world_mut().resource_mut::<Settings>().scale = 3.0;
    for _ in 0..4 {
        for_input(&mut app, |input| {
            let small = egui::vec2(320.0, 240.0);
            input.screen_rect = Some(egui::Rect::from_min_size(egui::Pos2::ZERO, small));
        });
        app.update();
    }
    let mut contexts = app.world_mut().query::<&mut EguiContext>();
    let mut context = contexts.single_mut(app.world_mut()).expect("one screen");
    assert_eq!(context.get_mut().zoom_factor(), 1.0);
    assert_eq!(app.world().resource::<Settings>().scale, 3.0);
}

#[test]
fn a_control_is_asked_for_and_taken() {
    let mut app = app();
    open(&mut app, "settings-controls");
    choose(&mut app, "Space");
    // Enter led to the question; it is no answer.
    step(&mut app);
    assert!(app.world().resource::<Settings>().bindings.is_empty());
    press(&mut app, KeyCode::F5);
    let bindings = app.world().resource::<Bindings>();
    let has = |action, code| bindings.of(action).contains(&Control::Key(code));
    assert!(has(Action::Strike, KeyCode::F5) && !has(Action::Strike, KeyCode::Space));

    // The new control does it, the old one does nothing.
    app.world_mut().resource_mut::<Open>().close();
    step(&mut app);
    step(&mut app);
    key(&mut app, KeyCode::Space, ButtonState::Pressed);
    assert!(!is_pressed(&mut app, Action::Strike));
    key(&mut app, KeyCode::Space, ButtonState::Released);
    key(&mut app, KeyCode::F5, ButtonState::Pressed);
    assert!(is_pressed(&mut app, Action::Strike));
    key(&mut app, KeyCode::F5, ButtonState::Released);
}

#[test]
fn escape_takes_no_control_and_leaves_the_page_open() {
    let mut app = app();
    open(&mut app, "settings-controls");
    choose(&mut app, "F1");
    press(&mut app, KeyCode::Escape);
    assert_eq!(page(&app), Some(PageId("settings-controls")));
    assert!(app.world().resource::<Settings>().bindings.is_empty());
    press(&mut app, KeyCode::Escape);
    assert_eq!(page(&app), Some(PageId::MAIN));
}

#[test]
fn a_clash_is_counted_and_everything_can_be_reset() {
    let mut app = app();
    open(&mut app, "settings-controls");
    choose(&mut app, "F1");
    press(&mut app, KeyCode::KeyZ);
    let bindings = app.world().resource::<Bindings>();
    let control = Control::Key(KeyCode::KeyZ);
    assert_eq!(bindings.clash(Action::Help, control), Some(Action::Undo));
    choose(&mut app, "All controls as at first");
    step(&mut app);
    assert_eq!(*app.world().resource::<Bindings>(), Bindings::default());
}

#[test]
fn toggles_last_from_one_press_to_the_next() {
    let mut app = app();
    let tap = |app: &mut App, code| {
        key(app, code, ButtonState::Pressed);
        key(app, code, ButtonState::Released);
    };
    tap(&mut app, KeyCode::ShiftLeft);
    assert!(!is_pressed(&mut app, Action::Fine), "a hold is a hold");
    let mut settings = app.world_mut().resource_mut::<Settings>();
    settings.toggles.fine = true;
    settings.toggles.stroke = true;
    for round in 0..2 {
        for code in [KeyCode::ShiftLeft, KeyCode::KeyV] {
            tap(&mut app, code);
        }
        for _ in 0..5 {
            step(&mut app);
            assert!(is_pressed(&mut app, Action::Fine), "{round}");
            assert!(is_pressed(&mut app, Action::Stroke), "{round}");
            assert!(!is_pressed(&mut app, Action::VeryFine));
        }
        for code in [KeyCode::ShiftLeft, KeyCode::KeyV] {
            tap(&mut app, code);
        }
        step(&mut app);
        assert!(!is_pressed(&mut app, Action::Fine), "{round}");
        assert!(!is_pressed(&mut app, Action::Stroke), "{round}");
    }
}

#[test]
fn the_panel_is_reached_with_tab_and_left_with_escape() {
    let mut app = app();
    let trails = app.world().resource::<View>().trails;
    choose(&mut app, "Trails");
    assert_ne!(app.world().resource::<View>().trails, trails);
    assert!(
        app.world()
            .resource::<EguiWantsInput>()
            .wants_keyboard_input()
    );
    press(&mut app, KeyCode::Escape);
    assert_eq!(screen(&app), Screen::Table, "it only gave the keys back");
    step(&mut app);
    assert!(
        !app.world()
            .resource::<EguiWantsInput>()
            .wants_keyboard_input()
    );
}
