//! One control: what it is called in the file of the settings and on the screen.

use bevy::prelude::*;
use leafwing_input_manager::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::window::language::Language;

/// Which way along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// To the left, or down.
    Less,
    /// To the right, or up.
    More,
}

/// A key, button or movement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Control {
    /// A key by its place on the keyboard.
    Key(KeyCode),
    /// Either of two modifier keys.
    Modifier(ModifierKey),
    /// A button of the mouse.
    Button(MouseButton),
    /// The wheel.
    Wheel,
    /// Any movement of the mouse.
    Motion,
    /// A button of any gamepad.
    Pad(GamepadButton),
    /// A stick or a trigger of any gamepad, moved one way; how far counts.
    Stick(GamepadAxis, Way),
}

impl Control {
    /// What a player presses when this key goes down: a modifier means both of its keys.
    #[must_use]
    pub fn of_key(key: KeyCode) -> Self {
        [
            ModifierKey::Alt,
            ModifierKey::Control,
            ModifierKey::Shift,
            ModifierKey::Super,
        ]
        .into_iter()
        .find(|modifier| modifier.keycodes().contains(&key))
        .map_or(Self::Key(key), Self::Modifier)
    }

    /// The kind of input that an action needs for this control.
    pub fn kind(self) -> InputControlKind {
        match self {
            Self::Wheel => InputControlKind::Axis,
            Self::Motion => InputControlKind::DualAxis,
            _ => InputControlKind::Button,
        }
    }

    /// What the file of the settings calls it, such as `Key Space`, `Mouse Middle` or `Stick LeftStickX+`.
    #[must_use]
    pub fn code(self) -> String {
        match self {
            Self::Key(key) => format!("Key {}", spelled(&key)),
            Self::Modifier(modifier) => format!("Modifier {}", spelled(&modifier)),
            Self::Button(button) => format!("Mouse {}", spelled(&button)),
            Self::Wheel => "Wheel".to_owned(),
            Self::Motion => "Motion".to_owned(),
            Self::Pad(button) => format!("Pad {}", spelled(&button)),
            Self::Stick(axis, Way::Less) => format!("Stick {}-", spelled(&axis)),
            Self::Stick(axis, Way::More) => format!("Stick {}+", spelled(&axis)),
        }
    }

    /// The control that the file calls so.
    #[must_use]
    pub fn from_code(code: &str) -> Option<Self> {
        let (kind, name) = code.split_once(' ').unwrap_or((code, ""));
        Some(match kind {
            "Key" => Self::Key(read(name)?),
            "Modifier" => Self::Modifier(read(name)?),
            "Mouse" => Self::Button(read(name)?),
            "Wheel" => Self::Wheel,
            "Motion" => Self::Motion,
            "Pad" => Self::Pad(read(name)?),
            "Stick" => match (name.strip_suffix('-'), name.strip_suffix('+')) {
                (Some(axis), _) => Self::Stick(read(axis)?, Way::Less),
                (_, Some(axis)) => Self::Stick(read(axis)?, Way::More),
                _ => return None,
            },
            _ => return None,
        })
    }

    /// What the screen calls it.
    #[must_use]
    pub fn name(self, language: &Language) -> String {
        match self {
            Self::Key(key) => key_name(key, language),
            Self::Modifier(ModifierKey::Control) => language.text("key-control").to_owned(),
            Self::Modifier(ModifierKey::Shift) => language.text("key-shift").to_owned(),
            Self::Modifier(modifier) => format!("{modifier:?}"),
            Self::Button(MouseButton::Left) => language.text("mouse-left").to_owned(),
            Self::Button(MouseButton::Right) => language.text("mouse-right").to_owned(),
            Self::Button(MouseButton::Middle) => language.text("mouse-middle").to_owned(),
            Self::Button(button) => {
                language.with("mouse-other", &[("name", spelled(&button).into())])
            }
            Self::Wheel => language.text("mouse-wheel").to_owned(),
            Self::Motion => language.text("mouse-motion").to_owned(),
            Self::Pad(button) => pad_name(button, language),
            Self::Stick(axis, way) => stick_name(axis, way, language),
        }
    }
}

/// The name of a value in RON. It has one: these types are plain enums.
fn spelled(value: &impl Serialize) -> String {
    ron::to_string(value).unwrap_or_default()
}

fn read<T: DeserializeOwned>(name: &str) -> Option<T> {
    ron::from_str(name).ok()
}

fn pad_name(button: GamepadButton, language: &Language) -> String {
    let along = |way: &str| language.with("pad-cross", &[("way", way.to_owned().into())]);
    let name = match button {
        GamepadButton::DPadLeft => return along("←"),
        GamepadButton::DPadRight => return along("→"),
        GamepadButton::DPadUp => return along("↑"),
        GamepadButton::DPadDown => return along("↓"),
        GamepadButton::South => "A / ×".to_owned(),
        GamepadButton::East => "B / ○".to_owned(),
        GamepadButton::West => "X / □".to_owned(),
        GamepadButton::North => "Y / △".to_owned(),
        GamepadButton::LeftTrigger => "L1".to_owned(),
        GamepadButton::RightTrigger => "R1".to_owned(),
        GamepadButton::LeftTrigger2 => "L2".to_owned(),
        GamepadButton::RightTrigger2 => "R2".to_owned(),
        GamepadButton::LeftThumb => "L3".to_owned(),
        GamepadButton::RightThumb => "R3".to_owned(),
        other => spelled(&other),
    };
    language.with("pad-button", &[("name", name.into())])
}

fn stick_name(axis: GamepadAxis, way: Way, language: &Language) -> String {
    let [left, right, down, up] = ["←", "→", "↓", "↑"];
    let (key, [less, more]) = match axis {
        GamepadAxis::LeftStickX => ("pad-left-stick", [left, right]),
        GamepadAxis::LeftStickY => ("pad-left-stick", [down, up]),
        GamepadAxis::RightStickX => ("pad-right-stick", [left, right]),
        GamepadAxis::RightStickY => ("pad-right-stick", [down, up]),
        other => {
            let sign = if way == Way::Less { "−" } else { "+" };
            let name = format!("{} {sign}", spelled(&other));
            return language.with("pad-button", &[("name", name.into())]);
        }
    };
    let way = if way == Way::Less { less } else { more };
    language.with(key, &[("way", way.to_owned().into())])
}

fn key_name(key: KeyCode, language: &Language) -> String {
    let word = |key| language.text(key).to_owned();
    match key {
        KeyCode::Comma => ",".to_owned(),
        KeyCode::Period => ".".to_owned(),
        KeyCode::Equal => "+".to_owned(),
        KeyCode::Minus => "-".to_owned(),
        KeyCode::NumpadAdd => "Num +".to_owned(),
        KeyCode::NumpadSubtract => "Num -".to_owned(),
        KeyCode::Semicolon => ";".to_owned(),
        KeyCode::Quote => "'".to_owned(),
        KeyCode::BracketLeft => "[".to_owned(),
        KeyCode::BracketRight => "]".to_owned(),
        KeyCode::Escape => "Esc".to_owned(),
        KeyCode::Space => word("key-space"),
        KeyCode::Enter => word("key-enter"),
        KeyCode::Home => word("key-home"),
        KeyCode::End => word("key-end"),
        KeyCode::PageUp => word("key-page-up"),
        KeyCode::PageDown => word("key-page-down"),
        KeyCode::ArrowLeft => "←".to_owned(),
        KeyCode::ArrowRight => "→".to_owned(),
        KeyCode::ArrowUp => "↑".to_owned(),
        KeyCode::ArrowDown => "↓".to_owned(),
        other => {
            let name = spelled(&other);
            let name = name.replace("Numpad", "Num ");
            name.strip_prefix("Key").unwrap_or(&name).to_owned()
        }
    }
}
