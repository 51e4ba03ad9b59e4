//! The table of controls.

use bevy::prelude::*;
use leafwing_input_manager::prelude::*;

use super::{Action, Control, Way};

/// What belongs together in the help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// Where the ball goes.
    Aim,
    /// How it is struck.
    Strike,
    /// What is seen and heard.
    View,
    /// What lies on the table.
    Table,
    /// The last shot again.
    Replay,
}

impl Topic {
    /// Every topic in the order of the help.
    pub const ALL: [Self; 5] = [
        Self::Aim,
        Self::Strike,
        Self::View,
        Self::Table,
        Self::Replay,
    ];

    /// The key of its heading.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Aim => "topic-aim",
            Self::Strike => "topic-strike",
            Self::View => "topic-view",
            Self::Table => "topic-table",
            Self::Replay => "topic-replay",
        }
    }
}

/// A line of the table: an action and how to do it.
pub struct Line {
    /// The action.
    pub action: Action,
    /// Controls that do it; any one is enough.
    pub controls: &'static [Control],
    /// Where the help lists it.
    pub topic: Topic,
}

const fn line(action: Action, controls: &'static [Control], topic: Topic) -> Line {
    Line {
        action,
        controls,
        topic,
    }
}

/// Every action with the controls that a new player finds. The help explains them by [`Action::key`].
#[rustfmt::skip] // One action a line.
pub const CONTROLS: &[Line] = {
    use Action as A;
    use Control::{Button, Key, Modifier, Motion, Pad, Stick, Wheel};
    use GamepadAxis as G;
    use GamepadButton as P;
    use KeyCode as K;
    use Topic::{Aim, Replay, Strike, Table, View};
    use Way::{Less, More};
    &[
        line(A::Drag, &[Button(MouseButton::Left)], Aim),
        line(A::AimLeft, &[Key(K::ArrowLeft), Stick(G::LeftStickX, Less)], Aim),
        line(A::AimRight, &[Key(K::ArrowRight), Stick(G::LeftStickX, More)], Aim),
        line(A::Fine, &[Modifier(ModifierKey::Shift), Pad(P::LeftTrigger)], Aim),
        line(A::VeryFine, &[Modifier(ModifierKey::Control), Pad(P::RightTrigger)], Aim),
        line(A::NextBallLeft, &[Key(K::Comma), Pad(P::DPadLeft)], Aim),
        line(A::NextBallRight, &[Key(K::Period), Pad(P::DPadRight)], Aim),
        line(A::SideLeft, &[Key(K::KeyA), Stick(G::RightStickX, Less)], Aim),
        line(A::SideRight, &[Key(K::KeyD), Stick(G::RightStickX, More)], Aim),
        line(A::HeightUp, &[Key(K::KeyE), Stick(G::RightStickY, More)], Aim),
        line(A::HeightDown, &[Key(K::KeyQ), Stick(G::RightStickY, Less)], Aim),
        line(A::ElevationUp, &[Key(K::KeyW), Pad(P::DPadUp)], Aim),
        line(A::ElevationDown, &[Key(K::KeyS), Pad(P::DPadDown)], Aim),
        line(A::Center, &[Key(K::KeyX), Pad(P::RightThumb)], Aim),
        line(A::Strike, &[Key(K::Space), Pad(P::South)], Strike),
        line(A::Stroke, &[Key(K::KeyV), Button(MouseButton::Middle)], Strike),
        line(A::Move, &[Motion], Strike),
        line(A::PowerUp, &[Key(K::ArrowUp), Stick(G::LeftStickY, More)], Strike),
        line(A::PowerDown, &[Key(K::ArrowDown), Stick(G::LeftStickY, Less)], Strike),
        line(A::PowerWheel, &[Wheel], Strike),
        line(A::Look, &[Button(MouseButton::Right)], View),
        line(A::Camera, &[Key(K::KeyC), Pad(P::North)], View),
        line(A::Overhead, &[Key(K::KeyO), Pad(P::LeftTrigger2)], View),
        line(A::SceneCamera, &[Key(K::F9)], View),
        line(A::SecondCamera, &[Key(K::F7)], View),
        line(A::OtherLaws, &[Key(K::F8)], View),
        line(A::LookLeft, &[Key(K::Home), Key(K::Numpad4)], View),
        line(A::LookRight, &[Key(K::End), Key(K::Numpad6)], View),
        line(A::LookUp, &[Key(K::PageUp), Key(K::Numpad8)], View),
        line(A::LookDown, &[Key(K::PageDown), Key(K::Numpad2)], View),
        line(A::ZoomIn, &[Key(K::Equal), Key(K::NumpadAdd)], View),
        line(A::ZoomOut, &[Key(K::Minus), Key(K::NumpadSubtract)], View),
        line(A::Guides, &[Key(K::KeyG)], View),
        line(A::Preview, &[Key(K::KeyL), Pad(P::LeftThumb)], View),
        line(A::Trails, &[Key(K::KeyT)], View),
        line(A::FastForward, &[Key(K::KeyF), Pad(P::RightTrigger2)], View),
        line(A::Photo, &[Key(K::F10)], View),
        line(A::Mute, &[Key(K::KeyM)], View),
        line(A::Panel, &[Key(K::KeyP)], View),
        line(A::Help, &[Key(K::KeyH), Key(K::F1)], View),
        line(A::Close, &[Key(K::Escape), Pad(P::East), Pad(P::Start)], View),
        line(A::Retry, &[Key(K::KeyR), Pad(P::West)], Table),
        line(A::Undo, &[Key(K::KeyZ)], Table),
        line(A::Redo, &[Key(K::Backslash)], Table),
        line(A::Rack, &[Key(K::KeyN)], Table),
        line(A::Place, &[Key(K::KeyB)], Table),
        line(A::InHand, &[Key(K::KeyI)], Table),
        line(A::Call, &[Key(K::Enter)], Table),
        line(A::Studio, &[Key(K::F2)], Table),
        line(A::PreviousTrick, &[Key(K::F3)], Table),
        line(A::NextTrick, &[Key(K::F4)], Table),
        line(A::PlayTrick, &[Key(K::F5)], Table),
        line(A::TryTrick, &[Key(K::F6)], Table),
        line(A::Replay, &[Key(K::KeyY), Pad(P::Select)], Replay),
        line(A::ReplayHold, &[Key(K::KeyK)], Replay),
        line(A::ReplayBackwards, &[Key(K::KeyJ)], Replay),
        line(A::ReplaySlower, &[Key(K::Semicolon)], Replay),
        line(A::ReplayFaster, &[Key(K::Quote)], Replay),
        line(A::ReplayPrevious, &[Key(K::BracketLeft)], Replay),
        line(A::ReplayNext, &[Key(K::BracketRight)], Replay),
        line(A::ReplayLoop, &[Key(K::KeyU)], Replay),
    ]
};
