//! A gamepad alone: aims, opens the menu, chooses, and is asked for controls.

use bevy::input::gamepad::{
    GamepadConnection, GamepadConnectionEvent, RawGamepadAxisChangedEvent,
    RawGamepadButtonChangedEvent, RawGamepadEvent,
};
use bevy::prelude::*;
use masse::game::aim::Aim;
use masse::window::action::{Action, Bindings, Control};
use masse::window::page::{Open, PageId, Screen};

use super::{app, choose, page, screen, step};

fn connected() -> (App, Entity) {
    let mut app = app();
    let pad = app.world_mut().spawn_empty().id();
    let connection = GamepadConnection::Connected {
        name: "pad".to_owned(),
        vendor_id: None,
        product_id: None,
    };
    app.world_mut()
        .write_message(GamepadConnectionEvent::new(pad, connection));
    step(&mut app);
    step(&mut app);
    (app, pad)
}

fn button(app: &mut App, gamepad: Entity, button: GamepadButton) {
    for value in [1.0, 0.0] {
        let event = RawGamepadButtonChangedEvent::new(gamepad, button, value);
        app.world_mut()
            .write_message(RawGamepadEvent::Button(event));
        step(app);
    }
    step(app);
}

fn stick(app: &mut App, gamepad: Entity, axis: GamepadAxis, value: f32) {
    let event = RawGamepadAxisChangedEvent::new(gamepad, axis, value);
    app.world_mut().write_message(RawGamepadEvent::Axis(event));
    step(app);
}

/// By how much the heading changes while the stick is held so for a while.
fn turned(value: f32) -> f64 {
    let (mut app, pad) = connected();
    // Frames of their own clock: on a busy machine those of the wall would be few.
    let frame = std::time::Duration::from_micros(16_667);
    app.insert_resource(bevy::time::TimeUpdateStrategy::ManualDuration(frame));
    let before = app.world().resource::<Aim>().shot.heading;
    stick(&mut app, pad, GamepadAxis::LeftStickX, value);
    for _ in 0..12 {
        step(&mut app);
    }
    (before - app.world().resource::<Aim>().shot.heading).to_degrees()
}

#[test]
fn the_stick_turns_the_cue_the_faster_the_farther_it_is_moved() {
    let (none, little, much) = (turned(0.1), turned(0.5), turned(0.95));
    assert_eq!(none, 0.0);
    assert!(little > 0.0 && much > 2.0 * little, "{little} {much}");
    assert!(turned(-0.5) < 0.0);
}

#[test]
fn the_menu_is_opened_steered_and_left() {
    let (mut app, pad) = connected();
    button(&mut app, pad, GamepadButton::Start);
    assert_eq!(screen(&app), Screen::Menu);
    // The first entry has the focus: back to the table.
    button(&mut app, pad, GamepadButton::South);
    assert_eq!(screen(&app), Screen::Table);
    button(&mut app, pad, GamepadButton::Start);
    button(&mut app, pad, GamepadButton::DPadDown);
    button(&mut app, pad, GamepadButton::South);
    assert_eq!(page(&app), Some(PageId::NEW_GAME));
    button(&mut app, pad, GamepadButton::East);
    assert_eq!(page(&app), Some(PageId::MAIN));
    button(&mut app, pad, GamepadButton::East);
    assert_eq!(screen(&app), Screen::Table);
}

#[test]
fn buttons_and_sticks_are_taken_as_controls() {
    for (is_stick, wanted) in [
        (false, Control::Pad(GamepadButton::North)),
        (
            true,
            Control::Stick(GamepadAxis::RightStickY, masse::window::action::Way::Less),
        ),
    ] {
        let (mut app, pad) = connected();
        let controls = PageId("settings-controls");
        app.world_mut().resource_mut::<Open>().go(controls);
        step(&mut app);
        step(&mut app);
        choose(&mut app, "F1");
        step(&mut app);
        if is_stick {
            stick(&mut app, pad, GamepadAxis::RightStickY, -0.9);
        } else {
            button(&mut app, pad, GamepadButton::North);
        }
        step(&mut app);
        let bindings = app.world().resource::<Bindings>();
        assert!(bindings.of(Action::Help).contains(&wanted), "{wanted:?}");
        assert_eq!(page(&app), Some(controls));
    }
}
