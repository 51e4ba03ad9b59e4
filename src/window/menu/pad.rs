//! A gamepad in the menu: cross and left stick move the focus and turn sliders, the lower button chooses.

use bevy::prelude::*;
use bevy_egui::{EguiInput, PrimaryEguiContext, egui};

/// How far the stick is moved to be a press.
const PUSHED: f32 = 0.6;
/// Seconds until a held direction is taken again, at first and then.
const REPEAT: [f32; 2] = [0.4, 0.12];

/// A direction that is held.
#[derive(Default)]
pub(super) struct Held {
    key: Option<egui::Key>,
    /// Seconds until it is taken again.
    wait: f32,
}

/// Gives the panels the keys that the gamepad stands for.
pub(super) fn steer(
    pads: Query<&Gamepad>,
    time: Res<Time<Real>>,
    mut held: Local<Held>,
    mut inputs: Query<&mut EguiInput, With<PrimaryEguiContext>>,
) {
    let mut keys = Vec::new();
    let direction = pads.iter().find_map(direction);
    if direction == held.key {
        held.wait -= time.delta_secs();
        if held.wait <= 0.0 {
            keys.extend(direction);
            held.wait = REPEAT[1];
        }
    } else {
        keys.extend(direction);
        *held = Held {
            key: direction,
            wait: REPEAT[0],
        };
    }
    if pads
        .iter()
        .any(|pad| pad.just_pressed(GamepadButton::South))
    {
        keys.push(egui::Key::Enter);
    }
    let Ok(mut input) = inputs.single_mut() else {
        return;
    };
    for key in keys {
        for pressed in [true, false] {
            input.events.push(egui::Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: egui::Modifiers::NONE,
            });
        }
    }
}

/// The direction that a gamepad points in.
fn direction(pad: &Gamepad) -> Option<egui::Key> {
    let stick = pad.left_stick();
    [
        (GamepadButton::DPadUp, stick.y, egui::Key::ArrowUp),
        (GamepadButton::DPadDown, -stick.y, egui::Key::ArrowDown),
        (GamepadButton::DPadLeft, -stick.x, egui::Key::ArrowLeft),
        (GamepadButton::DPadRight, stick.x, egui::Key::ArrowRight),
    ]
    .into_iter()
    .find(|(button, moved, _)| pad.pressed(*button) || *moved > PUSHED)
    .map(|(.., key)| key)
}
