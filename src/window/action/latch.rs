//! What the input manager does not do: taps within one frame, how far a stick is moved, holds that are toggles.

use bevy::prelude::*;
use leafwing_input_manager::buttonlike::ButtonState;
use leafwing_input_manager::prelude::*;

use super::bindings::DEAD;
use super::{Action, Bindings, Control, Way};
use crate::game::settings::{Settings, Toggles};
use crate::sim::messages::Strike;

/// Actions that last from one press to the next, and last now.
#[derive(Resource, Clone, Debug, Default, PartialEq, Eq)]
pub struct Latched(Vec<Action>);

impl Latched {
    /// The actions that last now.
    pub fn iter(&self) -> impl Iterator<Item = Action> {
        self.0.iter().copied()
    }

    /// Starts or ends an action, as a press of its control would.
    pub fn flip(&mut self, action: Action) {
        if let Some(at) = self.0.iter().position(|other| *other == action) {
            self.0.remove(at);
        } else {
            self.0.push(action);
        }
    }
}

/// The actions that may be toggles, and whether they are.
fn toggles(set: Toggles) -> [(Action, bool); 4] {
    [
        (Action::Fine, set.fine),
        (Action::VeryFine, set.very_fine),
        (Action::Stroke, set.stroke),
        (Action::FastForward, set.fast_forward),
    ]
}

/// A stick moves an action as far as it is moved: from 0 at the edge of what counts to 1.
pub(super) fn feel_sticks(
    mut actions: Single<&mut ActionState<Action>>,
    bindings: Res<Bindings>,
    pads: Query<&Gamepad>,
) {
    if pads.is_empty() {
        return;
    }
    for (action, controls) in bindings.iter() {
        if !controls.iter().any(|c| matches!(c, Control::Stick(..))) || !actions.pressed(&action) {
            continue;
        }
        let moved = controls.iter().filter_map(|control| match control {
            Control::Stick(axis, way) => {
                let sign = if *way == Way::Less { -1.0 } else { 1.0 };
                let most = pads.iter().filter_map(|pad| pad.get(*axis));
                most.map(|value| (sign * value - DEAD) / (1.0 - DEAD))
                    .reduce(f32::max)
            }
            _ => None,
        });
        // Pressed by something else it is pressed fully.
        if let Some(value) = moved.reduce(f32::max).filter(|value| *value > 0.0) {
            actions.set_button_value(&action, value.min(1.0));
        }
    }
}

/// A key that went down and up again within one frame counts as pressed in it: where frames are slow, no tap is lost.
pub(super) fn catch_taps(
    mut actions: Single<&mut ActionState<Action>>,
    bindings: Res<Bindings>,
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
    pads: Query<&Gamepad>,
) {
    let is_key_tapped = |key: KeyCode| keys.just_pressed(key) && !keys.pressed(key);
    for (action, controls) in bindings.iter() {
        let is_tapped = controls.iter().any(|control| match control {
            Control::Key(key) => is_key_tapped(*key),
            Control::Modifier(modifier) => modifier.keycodes().into_iter().any(is_key_tapped),
            Control::Button(button) => buttons.just_pressed(*button) && !buttons.pressed(*button),
            Control::Pad(button) => pads
                .iter()
                .any(|pad| pad.just_pressed(*button) && !pad.pressed(*button)),
            Control::Wheel | Control::Motion | Control::Stick(..) => false,
        });
        if is_tapped {
            actions.press(&action);
        }
    }
}

/// Holds that are toggles last from one press to the next. A stroke by hand is over with the strike.
pub(super) fn hold(
    mut actions: Single<&mut ActionState<Action>>,
    settings: Res<Settings>,
    mut latched: ResMut<Latched>,
    mut strikes: MessageReader<Strike>,
    mut down: Local<Vec<Action>>,
) {
    let struck = strikes.read().count() > 0;
    for (action, is_toggle) in toggles(settings.toggles) {
        // What lasts is told from what is held by the controls alone, before it is made to last.
        let held = actions.pressed(&action);
        let pressed = held && !down.contains(&action);
        down.retain(|other| *other != action);
        down.extend(held.then_some(action));
        let lasts = latched.0.contains(&action);
        let ends = lasts && (pressed || (struck && action == Action::Stroke));
        let begins = !lasts && pressed && is_toggle;
        if begins || ends {
            latched.flip(action);
        }
        if ends {
            actions.release(&action);
        } else if begins || lasts {
            let data = actions.button_data_mut_or_default(&action);
            data.state = if begins {
                ButtonState::JustPressed
            } else {
                ButtonState::Pressed
            };
            data.value = 1.0;
        }
    }
}
