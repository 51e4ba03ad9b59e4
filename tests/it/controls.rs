//! The table of controls: nothing is left out of it, nothing is in it twice; and what players make of it.

use std::collections::{BTreeMap, HashSet};

use bevy::prelude::{GamepadAxis, KeyCode, MouseButton};
use bevy::reflect::{TypeInfo, Typed};
use leafwing_input_manager::prelude::*;
use masse::window::action::{Action, Bindings, CONTROLS, Control, Topic, Way, default_keys};
use masse::window::language::Language;

#[test]
fn every_action_is_in_the_help_once() {
    let TypeInfo::Enum(actions) = Action::type_info() else {
        panic!("Action is an enum");
    };
    let listed: HashSet<String> = CONTROLS
        .iter()
        .map(|line| format!("{:?}", line.action))
        .collect();
    assert_eq!(listed.len(), CONTROLS.len(), "an action is listed twice");
    for name in actions.variant_names() {
        assert!(listed.contains(*name), "{name} is missing");
    }
    for topic in Topic::ALL {
        assert!(CONTROLS.iter().any(|line| line.topic == topic));
    }
}

#[test]
fn no_control_does_two_things_and_every_one_has_a_name_and_a_code() {
    let language = Language::default();
    let mut names = HashSet::new();
    for line in CONTROLS {
        assert!(
            !line.controls.is_empty(),
            "{:?} has no control",
            line.action
        );
        for control in line.controls {
            let name = Control::name(*control, &language);
            assert!(names.insert(name.clone()), "{name} does two things");
            assert_eq!(Control::from_code(&control.code()), Some(*control));
            assert_eq!(control.kind(), line.action.input_control_kind());
        }
    }
}

#[test]
fn the_default_keys_hold_the_whole_table() {
    let keys = default_keys();
    for line in CONTROLS {
        let bound = match line.action.input_control_kind() {
            InputControlKind::Button => keys.get_buttonlike(&line.action).map(Vec::len),
            InputControlKind::Axis => keys.get_axislike(&line.action).map(Vec::len),
            InputControlKind::DualAxis => keys.get_dual_axislike(&line.action).map(Vec::len),
            InputControlKind::TripleAxis => None,
        };
        assert_eq!(bound, Some(line.controls.len()), "{:?}", line.action);
    }
}

#[test]
fn keyboard_and_gamepad_alone_can_aim_strike_and_reach_the_menu() {
    use Action as A;
    let needed = [
        A::AimLeft,
        A::AimRight,
        A::PowerUp,
        A::PowerDown,
        A::SideLeft,
        A::SideRight,
        A::HeightUp,
        A::HeightDown,
        A::ElevationUp,
        A::ElevationDown,
        A::Strike,
        A::Close,
    ];
    let bindings = Bindings::default();
    for action in needed {
        let controls = bindings.of(action);
        let has = |is: fn(&Control) -> bool| controls.iter().any(is);
        assert!(has(|c| matches!(c, Control::Key(_))), "{action:?}");
        assert!(
            has(|c| matches!(c, Control::Pad(_) | Control::Stick(..))),
            "{action:?}"
        );
    }
}

#[test]
fn bindings_are_written_down_only_where_they_differ_and_come_back() {
    let mut settings = BTreeMap::new();
    let controls = [
        Control::Key(KeyCode::F5),
        Control::Button(MouseButton::Other(8)),
        Control::Stick(GamepadAxis::RightZ, Way::Less),
    ];
    Bindings::rebind(&mut settings, Action::Strike, &controls);
    Bindings::rebind(&mut settings, Action::Mute, &[]);
    let (bindings, problems) = Bindings::of_settings(&settings);
    assert_eq!(problems, Vec::<String>::new());
    assert_eq!(bindings.of(Action::Strike), controls);
    assert_eq!(bindings.of(Action::Mute), []);
    let default = Bindings::default();
    assert_eq!(bindings.of(Action::Undo), default.of(Action::Undo));
    Bindings::rebind(&mut settings, Action::Strike, default.of(Action::Strike));
    Bindings::rebind(&mut settings, Action::Mute, default.of(Action::Mute));
    assert!(settings.is_empty());
}

#[test]
fn a_clash_is_seen_from_both_sides() {
    let mut settings = BTreeMap::new();
    let space = Control::Key(KeyCode::Space);
    Bindings::rebind(&mut settings, Action::Undo, &[space]);
    let (bindings, _) = Bindings::of_settings(&settings);
    assert_eq!(bindings.clash(Action::Undo, space), Some(Action::Strike));
    assert_eq!(bindings.clash(Action::Strike, space), Some(Action::Undo));
    let other = Control::Key(KeyCode::KeyR);
    assert_eq!(bindings.clash(Action::Retry, other), None);
}

#[test]
fn bindings_that_are_no_good_are_named_and_the_action_keeps_its_own() {
    let entry = |action: &str, control: &str| (action.to_owned(), vec![control.to_owned()]);
    let settings = BTreeMap::from([
        entry("Strike", "Key Nowhere"),
        entry("Undo", "Lever"),
        entry("Mute", "Wheel"),
        entry("PowerWheel", "Key KeyA"),
        entry("Levitate", "Key KeyA"),
        entry("Retry", "Key KeyA) (evil"),
        entry("Help", "Stick LeftStickX"),
    ]);
    let (bindings, problems) = Bindings::of_settings(&settings);
    assert_eq!(bindings, Bindings::default());
    assert_eq!(problems.len(), settings.len(), "{problems:?}");
    for name in settings.keys() {
        assert!(
            problems
                .iter()
                .any(|problem| problem.starts_with(name.as_str()))
        );
    }
}

#[test]
fn either_shift_key_means_both() {
    for key in [KeyCode::ShiftLeft, KeyCode::ShiftRight] {
        assert_eq!(Control::of_key(key), Control::Modifier(ModifierKey::Shift));
    }
    assert_eq!(Control::of_key(KeyCode::F9), Control::Key(KeyCode::F9));
}
