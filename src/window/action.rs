//! Everything a player can do with keys and mouse: one table for the controls and for the help.

use bevy::prelude::*;
use leafwing_input_manager::plugin::InputManagerSystem;
use leafwing_input_manager::prelude::*;

/// One thing a player can do. [`CONTROLS`] says how and what for.
#[derive(Actionlike, Clone, Copy, Debug, PartialEq, Eq, Hash, Reflect)]
pub enum Action {
    /// Turn the cue to the left.
    AimLeft,
    /// Turn the cue to the right.
    AimRight,
    /// Point at the next ball to the left.
    NextBallLeft,
    /// Point at the next ball to the right.
    NextBallRight,
    /// Ten times finer steps while held.
    Fine,
    /// A hundred times finer steps while held.
    VeryFine,
    /// Raise the butt of the cue.
    ElevationUp,
    /// Lower the butt of the cue.
    ElevationDown,
    /// Move the tip to the left.
    SideLeft,
    /// Move the tip to the right.
    SideRight,
    /// Move the tip up: follow.
    HeightUp,
    /// Move the tip down: draw.
    HeightDown,
    /// Tip to the centre, cue level.
    Center,
    /// Strike harder.
    PowerUp,
    /// Strike softer.
    PowerDown,
    /// Power by the wheel.
    #[actionlike(Axis)]
    PowerWheel,
    /// Strike as aimed.
    Strike,
    /// Stroke by hand while held.
    Stroke,
    /// Drag: aim, or move a ball.
    Drag,
    /// Turn the camera by dragging.
    Look,
    /// Movement of the mouse.
    #[actionlike(DualAxis)]
    Move,
    /// Camera nearer.
    ZoomIn,
    /// Camera farther.
    ZoomOut,
    /// Next camera.
    Camera,
    /// To the overhead camera and back.
    Overhead,
    /// Show or hide the guides.
    Guides,
    /// Show or hide the preview.
    Preview,
    /// Show or hide the trails.
    Trails,
    /// Retry the last shot.
    Retry,
    /// Undo the last step.
    Undo,
    /// A new rack.
    Rack,
    /// Place balls by dragging.
    Place,
    /// Cue ball in hand.
    InHand,
    /// Play faster while held.
    FastForward,
    /// Silence.
    Mute,
    /// Show or hide the shot panel.
    Panel,
    /// Show or hide the help.
    Help,
    /// Close what is open, or quit.
    Close,
    /// Replay the last shot, or leave the replay.
    Replay,
    /// Hold the replay or go on.
    ReplayHold,
    /// Turn the replay round.
    ReplayBackwards,
    /// Half as fast.
    ReplaySlower,
    /// Twice as fast.
    ReplayFaster,
    /// To the next event.
    ReplayNext,
    /// To the event before.
    ReplayPrevious,
    /// Begin again at the end.
    ReplayLoop,
}

/// A key, button or movement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
}

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

    /// Its heading.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Aim => "Aim",
            Self::Strike => "Strike",
            Self::View => "See and hear",
            Self::Table => "Table",
            Self::Replay => "Replay",
        }
    }
}

/// A line of the table: an action, how to do it, what it does.
pub struct Line {
    /// The action.
    pub action: Action,
    /// Controls that do it; any one is enough.
    pub controls: &'static [Control],
    /// Where the help lists it.
    pub topic: Topic,
    /// What the help says.
    pub what: &'static str,
}

const fn line(
    action: Action,
    controls: &'static [Control],
    topic: Topic,
    what: &'static str,
) -> Line {
    Line {
        action,
        controls,
        topic,
        what,
    }
}

/// Every action with its controls. The help and the default keys are made from it.
#[rustfmt::skip] // One action a line.
pub const CONTROLS: &[Line] = {
    use Action as A;
    use Control::{Button, Key, Modifier, Motion, Wheel};
    use KeyCode as K;
    use Topic::{Aim, Replay, Strike, Table, View};
    &[
        line(A::Drag, &[Button(MouseButton::Left)], Aim, "drag to turn the cue; from overhead the cue points at the pointer"),
        line(A::AimLeft, &[Key(K::ArrowLeft)], Aim, "turn left: a tap is 1°, hold to keep turning"),
        line(A::AimRight, &[Key(K::ArrowRight)], Aim, "turn right"),
        line(A::Fine, &[Modifier(ModifierKey::Shift)], Aim, "hold: ten times finer, keys and mouse"),
        line(A::VeryFine, &[Modifier(ModifierKey::Control)], Aim, "hold: a hundred times finer; with Shift a thousand times: 0.001°"),
        line(A::NextBallLeft, &[Key(K::Comma)], Aim, "point at the next ball to the left"),
        line(A::NextBallRight, &[Key(K::Period)], Aim, "point at the next ball to the right"),
        line(A::SideLeft, &[Key(K::KeyA)], Aim, "tip to the left: left english"),
        line(A::SideRight, &[Key(K::KeyD)], Aim, "tip to the right: right english"),
        line(A::HeightUp, &[Key(K::KeyE)], Aim, "tip up: follow"),
        line(A::HeightDown, &[Key(K::KeyQ)], Aim, "tip down: draw"),
        line(A::ElevationUp, &[Key(K::KeyW)], Aim, "raise the butt of the cue"),
        line(A::ElevationDown, &[Key(K::KeyS)], Aim, "lower the butt of the cue"),
        line(A::Center, &[Key(K::KeyX)], Aim, "tip to the centre, cue level"),
        line(A::Strike, &[Key(K::Space)], Strike, "strike with the power set"),
        line(A::Stroke, &[Key(K::KeyV), Button(MouseButton::Middle)], Strike, "hold, pull the mouse back and push: the cue goes at the speed of your hand"),
        line(A::Move, &[Motion], Strike, "moves what is held: cue, ball or camera"),
        line(A::PowerUp, &[Key(K::ArrowUp)], Strike, "more power"),
        line(A::PowerDown, &[Key(K::ArrowDown)], Strike, "less power"),
        line(A::PowerWheel, &[Wheel], Strike, "power; with the right button held, zoom"),
        line(A::Look, &[Button(MouseButton::Right)], View, "drag to turn the camera; with Shift to move it"),
        line(A::Camera, &[Key(K::KeyC)], View, "next camera: behind the cue, overhead, free"),
        line(A::Overhead, &[Key(K::KeyO)], View, "overhead and back; you can shoot from there"),
        line(A::ZoomIn, &[Key(K::Equal), Key(K::NumpadAdd)], View, "nearer"),
        line(A::ZoomOut, &[Key(K::Minus), Key(K::NumpadSubtract)], View, "farther"),
        line(A::Guides, &[Key(K::KeyG)], View, "aim line and ghost ball"),
        line(A::Preview, &[Key(K::KeyL)], View, "paths of all balls for the present aim"),
        line(A::Trails, &[Key(K::KeyT)], View, "paths of the last shot"),
        line(A::FastForward, &[Key(K::KeyF)], View, "hold: play eight times as fast"),
        line(A::Mute, &[Key(K::KeyM)], View, "sound on or off"),
        line(A::Panel, &[Key(K::KeyP)], View, "shot panel"),
        line(A::Help, &[Key(K::KeyH), Key(K::F1)], View, "this help"),
        line(A::Close, &[Key(K::Escape)], View, "close what is open; twice to quit"),
        line(A::Retry, &[Key(K::KeyR)], Table, "back to before the last shot, aimed as it was"),
        line(A::Undo, &[Key(K::KeyZ)], Table, "undo a shot, a placed ball or a new rack, as often as you like"),
        line(A::Rack, &[Key(K::KeyN)], Table, "new rack: 8-ball and 9-ball in turn"),
        line(A::Place, &[Key(K::KeyB)], Table, "place balls: drag them; again to go on aiming"),
        line(A::InHand, &[Key(K::KeyI)], Table, "cue ball in hand"),
        line(A::Replay, &[Key(K::KeyY)], Replay, "replay the last shot; again to go back to the table"),
        line(A::ReplayHold, &[Key(K::KeyK)], Replay, "hold or go on; so does Space"),
        line(A::ReplayBackwards, &[Key(K::KeyJ)], Replay, "backwards or forwards"),
        line(A::ReplaySlower, &[Key(K::Semicolon)], Replay, "half as fast"),
        line(A::ReplayFaster, &[Key(K::Quote)], Replay, "twice as fast"),
        line(A::ReplayPrevious, &[Key(K::BracketLeft)], Replay, "to the event before"),
        line(A::ReplayNext, &[Key(K::BracketRight)], Replay, "to the next event"),
        line(A::ReplayLoop, &[Key(K::KeyU)], Replay, "begin again at the end"),
    ]
};

impl Control {
    /// What the help calls it.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Key(key) => key_name(key),
            Self::Modifier(ModifierKey::Control) => "Ctrl".to_owned(),
            Self::Modifier(modifier) => format!("{modifier:?}"),
            Self::Button(button) => format!("{button:?} button"),
            Self::Wheel => "Wheel".to_owned(),
            Self::Motion => "Mouse".to_owned(),
        }
    }
}

fn key_name(key: KeyCode) -> String {
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
        KeyCode::ArrowLeft => "←".to_owned(),
        KeyCode::ArrowRight => "→".to_owned(),
        KeyCode::ArrowUp => "↑".to_owned(),
        KeyCode::ArrowDown => "↓".to_owned(),
        other => {
            let name = format!("{other:?}");
            name.strip_prefix("Key").unwrap_or(&name).to_owned()
        }
    }
}

/// The keys a new player finds.
#[must_use]
pub fn default_keys() -> InputMap<Action> {
    let mut map = InputMap::default();
    for Line {
        action, controls, ..
    } in CONTROLS
    {
        for control in *controls {
            match *control {
                Control::Key(key) => map.insert(*action, key),
                Control::Modifier(modifier) => map.insert(*action, modifier),
                Control::Button(button) => map.insert(*action, button),
                Control::Wheel => map.insert_axis(*action, MouseScrollAxis::Y),
                Control::Motion => map.insert_dual_axis(*action, MouseMove::default()),
            };
        }
    }
    map
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(InputManagerPlugin::<Action>::default())
        .add_systems(Startup, |mut commands: Commands| {
            commands.spawn((Name::new("Controls"), default_keys()));
        })
        .add_systems(
            PreUpdate,
            catch_taps.in_set(InputManagerSystem::ManualControl),
        );
}

/// A key that went down and up again within one frame counts as pressed in it: where frames are slow, no tap is lost.
fn catch_taps(
    mut actions: Single<&mut ActionState<Action>>,
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
) {
    let is_key_tapped = |key: KeyCode| keys.just_pressed(key) && !keys.pressed(key);
    for line in CONTROLS {
        let is_tapped = line.controls.iter().any(|control| match control {
            Control::Key(key) => is_key_tapped(*key),
            Control::Modifier(modifier) => modifier.keycodes().into_iter().any(is_key_tapped),
            Control::Button(button) => buttons.just_pressed(*button) && !buttons.pressed(*button),
            Control::Wheel | Control::Motion => false,
        });
        if is_tapped {
            actions.press(&line.action);
        }
    }
}
