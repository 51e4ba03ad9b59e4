//! The table of controls: nothing is left out of it, nothing is in it twice.

use std::collections::HashSet;

use bevy::reflect::{TypeInfo, Typed};
use leafwing_input_manager::prelude::*;
use masse::window::action::{Action, CONTROLS, Control, Topic, default_keys};

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
fn no_control_does_two_things_and_every_one_has_a_name() {
    let mut names = HashSet::new();
    for line in CONTROLS {
        assert!(
            !line.controls.is_empty(),
            "{:?} has no control",
            line.action
        );
        assert!(line.what.len() > 3, "{:?} is not explained", line.action);
        for control in line.controls {
            let name = Control::name(*control);
            assert!(names.insert(name.clone()), "{name} does two things");
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
