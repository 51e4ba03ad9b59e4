//! Which controls do what: those of the table, less those that the player has set otherwise.

use std::collections::BTreeMap;

use bevy::prelude::*;
use leafwing_input_manager::buttonlike::ButtonValue;
use leafwing_input_manager::input_map::{UpdatedActions, UpdatedValue};
use leafwing_input_manager::prelude::updating::CentralInputStore;
use leafwing_input_manager::prelude::*;

use super::{Action, CONTROLS, Control, Way};
use crate::game::equip::Told;
use crate::game::saying::Saying;
use crate::game::settings::Settings;
use crate::window::language::Language;

/// How far a stick moves before it counts.
pub(super) const DEAD: f32 = 0.25;

/// The controls of every action, in the order of [`CONTROLS`].
#[derive(Resource, Clone, Debug, PartialEq, Eq)]
pub struct Bindings {
    all: Vec<(Action, Vec<Control>)>,
}

impl Default for Bindings {
    fn default() -> Self {
        let all = CONTROLS
            .iter()
            .map(|line| (line.action, line.controls.to_vec()))
            .collect();
        Self { all }
    }
}

impl Bindings {
    /// The controls that settings ask for, and what in them cannot be understood: an action keeps its own controls then.
    #[must_use]
    pub fn of_settings(settings: &BTreeMap<String, Vec<String>>) -> (Self, Vec<String>) {
        let mut bindings = Self::default();
        let mut problems = Vec::new();
        for (name, codes) in settings {
            let Some((action, controls)) = bindings
                .all
                .iter_mut()
                .find(|(action, _)| format!("{action:?}") == *name)
            else {
                problems.push(name.clone());
                continue;
            };
            let kind = action.input_control_kind();
            let read: Vec<Option<Control>> = codes
                .iter()
                .map(|code| Control::from_code(code).filter(|control| control.kind() == kind))
                .collect();
            match read.iter().position(Option::is_none) {
                Some(bad) => problems.push(format!("{name}: {}", codes[bad])),
                None => *controls = read.into_iter().flatten().collect(),
            }
        }
        (bindings, problems)
    }

    /// The controls of an action; any one is enough.
    #[must_use]
    pub fn of(&self, action: Action) -> &[Control] {
        self.all
            .iter()
            .find(|(other, _)| *other == action)
            .map_or(&[], |(_, controls)| controls.as_slice())
    }

    /// What the first control of an action is called; empty if it has none.
    #[must_use]
    pub fn name(&self, action: Action, language: &Language) -> String {
        let first = self.of(action).first();
        first.map_or_else(String::new, |control| control.name(language))
    }

    /// Every action with its controls.
    pub fn iter(&self) -> impl Iterator<Item = (Action, &[Control])> {
        self.all
            .iter()
            .map(|(action, controls)| (*action, controls.as_slice()))
    }

    /// Another action that the same control does.
    #[must_use]
    pub fn clash(&self, action: Action, control: Control) -> Option<Action> {
        self.iter()
            .find(|(other, controls)| *other != action && controls.contains(&control))
            .map(|(other, _)| other)
    }

    /// Writes down that an action has these controls. What it comes with is not written down.
    pub fn rebind(
        settings: &mut BTreeMap<String, Vec<String>>,
        action: Action,
        controls: &[Control],
    ) {
        let name = format!("{action:?}");
        if Self::default().of(action) == controls {
            settings.remove(&name);
        } else {
            let codes = controls.iter().map(|control| control.code()).collect();
            settings.insert(name, codes);
        }
    }

    /// The same for the input manager.
    #[must_use]
    pub fn input_map(&self) -> InputMap<Action> {
        let mut map = InputMap::default();
        for (action, controls) in self.iter() {
            for control in controls {
                match *control {
                    Control::Key(key) => map.insert(action, key),
                    Control::Modifier(modifier) => map.insert(action, modifier),
                    Control::Button(button) => map.insert(action, button),
                    Control::Wheel => map.insert_axis(action, MouseScrollAxis::Y),
                    Control::Motion => map.insert_dual_axis(action, MouseMove::default()),
                    Control::Pad(button) => map.insert(action, button),
                    Control::Stick(axis, way) => map.insert(
                        action,
                        match way {
                            Way::Less => GamepadControlDirection::negative(axis),
                            Way::More => GamepadControlDirection::positive(axis),
                        }
                        .threshold(DEAD),
                    ),
                };
            }
        }
        map
    }
}

/// The keys a new player finds.
#[must_use]
pub fn default_keys() -> InputMap<Action> {
    Bindings::default().input_map()
}

/// The controls as the input manager reads them.
///
/// They are no component of the entity that holds the state of the actions: there the manager would compare every action
/// with every other each frame, for a control that is part of another's. None of ours can be: each is one key, button or axis.
#[derive(Resource)]
pub(super) struct Map(InputMap<Action>);

impl Default for Map {
    fn default() -> Self {
        Self(default_keys())
    }
}

/// What is held down and moved. An action is as far pressed as the one of its controls that is pressed most.
pub(super) fn read(
    map: Res<Map>,
    inputs: Res<CentralInputStore>,
    pads: Query<Entity, With<Gamepad>>,
    mut actions: Single<&mut ActionState<Action>>,
) {
    let pad = pads.iter().next().unwrap_or(Entity::PLACEHOLDER);
    let buttons = map.0.iter_buttonlike().map(|(action, controls)| {
        let value = controls.iter().fold(0.0, |most: f32, control| {
            most.max(control.value(&inputs, pad))
        });
        let pressed = controls.iter().any(|control| control.pressed(&inputs, pad));
        (
            *action,
            UpdatedValue::Button(ButtonValue { pressed, value }),
        )
    });
    let axes = map.0.iter_axislike().map(|(action, controls)| {
        let sum = controls
            .iter()
            .filter_map(|axis| axis.get_value(&inputs, pad));
        (*action, UpdatedValue::Axis(sum.sum()))
    });
    let planes = map.0.iter_dual_axislike().map(|(action, controls)| {
        let sum = controls
            .iter()
            .filter_map(|axes| axes.get_axis_pair(&inputs, pad));
        (*action, UpdatedValue::DualAxis(sum.sum()))
    });
    actions.update(UpdatedActions(buttons.chain(axes).chain(planes).collect()));
}

/// Takes up what the settings say of controls. What is held down is let go: its control may do something else now.
pub(super) fn follow(
    mut commands: Commands,
    settings: Res<Settings>,
    mut known: Local<BTreeMap<String, Vec<String>>>,
    mut bindings: ResMut<Bindings>,
    mut map: ResMut<Map>,
    mut actions: Single<&mut ActionState<Action>>,
) {
    if !settings.is_changed() || *known == settings.bindings {
        return;
    }
    known.clone_from(&settings.bindings);
    let (new, problems) = Bindings::of_settings(&settings.bindings);
    map.0 = new.input_map();
    actions.reset_all();
    *bindings = new;
    if !problems.is_empty() {
        let what = problems.join("; ");
        commands.write_message(Told {
            text: Saying::new(
                "notice-bindings",
                &[("what", &what)],
                format!("Controls in the settings that are unknown: {what}"),
            ),
            is_failure: true,
        });
    }
}
