//! Asking for a control: the next key, button or stick that is pressed is taken.

use bevy::input::ButtonState;
use bevy::input::gamepad::{GamepadAxisChangedEvent, GamepadButtonStateChangedEvent};
use bevy::input::keyboard::KeyboardInput;
use bevy::input::mouse::MouseButtonInput;
use bevy::prelude::*;
use bevy_egui::{EguiInput, PrimaryEguiContext};

use crate::game::settings::Settings;
use crate::window::WindowSystems;
use crate::window::action::{Action, Bindings, Control, Way};
use crate::window::page::Screen;

/// How far a stick is moved to be meant.
const MEANT: f32 = 0.7;

/// A control that is asked for.
#[derive(Clone, Copy, Debug)]
pub(in crate::window::menu) struct Question {
    /// What it shall do.
    pub(super) action: Action,
    /// Which control of the action gives way to it; none if it comes as well.
    slot: Option<usize>,
    /// What was pressed before the question is no answer: it is read once and forgotten.
    is_new: bool,
}

/// The control that is asked for, if one is.
#[derive(Resource, Debug, Default)]
pub(in crate::window::menu) struct Asking(pub(super) Option<Question>);

impl Asking {
    /// Asks for a control that does this, instead of another or as well.
    pub(super) fn ask(&mut self, action: Action, slot: Option<usize>) {
        self.0 = Some(Question {
            action,
            slot,
            is_new: true,
        });
    }
}

/// Whether a control is asked for.
pub(in crate::window::menu) fn is_asking(asking: Res<Asking>) -> bool {
    asking.0.is_some()
}

/// The same, outside systems.
pub(in crate::window::menu) fn asks(world: &World) -> bool {
    world.resource::<Asking>().0.is_some()
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Asking>()
        .add_systems(
            PreUpdate,
            take.run_if(in_state(Screen::Menu).and_then(is_asking))
                .in_set(WindowSystems::Asking),
        )
        .add_systems(OnExit(Screen::Menu), |mut asking: ResMut<Asking>| {
            asking.0 = None;
        });
}

/// Takes the control that is pressed; Esc takes none. The panels hear nothing of it.
#[expect(clippy::too_many_arguments, reason = "every kind of control")]
fn take(
    mut keys: MessageReader<KeyboardInput>,
    mut buttons: MessageReader<MouseButtonInput>,
    mut pads: MessageReader<GamepadButtonStateChangedEvent>,
    mut sticks: MessageReader<GamepadAxisChangedEvent>,
    mut inputs: Query<&mut EguiInput, With<PrimaryEguiContext>>,
    bindings: Res<Bindings>,
    mut asking: ResMut<Asking>,
    mut settings: ResMut<Settings>,
) {
    let Some(Question {
        action,
        slot,
        is_new,
    }) = asking.0
    else {
        return;
    };
    let key = keys.read().filter(|key| key.state == ButtonState::Pressed);
    let key = key.map(|key| Control::of_key(key.key_code)).last();
    let button = buttons
        .read()
        .filter(|button| button.state == ButtonState::Pressed);
    let button = button.map(|button| Control::Button(button.button)).last();
    let pad = pads
        .read()
        .filter(|pad| pad.state == ButtonState::Pressed)
        .map(|pad| Control::Pad(pad.button))
        .last();
    let stick = sticks
        .read()
        .filter(|stick| stick.value.abs() > MEANT)
        .map(|stick| {
            let way = if stick.value < 0.0 {
                Way::Less
            } else {
                Way::More
            };
            Control::Stick(stick.axis, way)
        })
        .last();
    for mut input in &mut inputs {
        input.events.clear();
    }
    if is_new {
        asking.0 = Some(Question {
            is_new: false,
            action,
            slot,
        });
        return;
    }
    let Some(control) = key.or(button).or(pad).or(stick) else {
        return;
    };
    asking.0 = None;
    if control == Control::Key(KeyCode::Escape) {
        return;
    }
    let mut controls = bindings.of(action).to_vec();
    match slot.and_then(|slot| controls.get_mut(slot)) {
        Some(old) => *old = control,
        None => controls.push(control),
    }
    let mut unique: Vec<Control> = Vec::new();
    for control in controls {
        if !unique.contains(&control) {
            unique.push(control);
        }
    }
    Bindings::rebind(&mut settings.bindings, action, &unique);
}
