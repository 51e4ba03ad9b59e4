//! Everything a player can do with keys, mouse and gamepad: one table for the controls and for the help, and what the
//! player has made of it.

mod bindings;
mod control;
mod controls;
mod latch;

pub use bindings::{Bindings, default_keys};
pub use control::{Control, Way};
pub use controls::{CONTROLS, Line, Topic};
pub use latch::Latched;

use bevy::ecs::message::MessageUpdateSystems;
use bevy::prelude::*;
use leafwing_input_manager::plugin::InputManagerSystem;
use leafwing_input_manager::prelude::*;
use leafwing_input_manager::systems::update_action_state;

/// One thing a player can do. [`CONTROLS`] says how; the help says what for.
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
    /// Turn the camera to the left.
    LookLeft,
    /// Turn the camera to the right.
    LookRight,
    /// Raise the camera.
    LookUp,
    /// Lower the camera.
    LookDown,
    /// Camera nearer.
    ZoomIn,
    /// Camera farther.
    ZoomOut,
    /// Next camera.
    Camera,
    /// Next camera of the scene.
    SceneCamera,
    /// A second camera beside the first, or the whole picture.
    SecondCamera,
    /// The same stroke by other laws beside it, or the whole picture.
    OtherLaws,
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
    /// Do again what was undone.
    Redo,
    /// A new rack.
    Rack,
    /// Place balls by dragging.
    Place,
    /// Cue ball in hand.
    InHand,
    /// Call the ball that is aimed at.
    Call,
    /// Open or close the studio.
    Studio,
    /// Play the trick shot that lies on the table.
    PlayTrick,
    /// Lay the trick shot out to try it.
    TryTrick,
    /// To the trick shot before.
    PreviousTrick,
    /// To the next trick shot.
    NextTrick,
    /// Play faster while held.
    FastForward,
    /// Photo mode, or back from it.
    Photo,
    /// Silence.
    Mute,
    /// Show or hide the shot panel.
    Panel,
    /// Show or hide the help.
    Help,
    /// Close what is open, or open the menu.
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

impl Action {
    /// The key under which languages explain it.
    #[must_use]
    pub fn key(self) -> String {
        let mut key = "action".to_owned();
        for c in format!("{self:?}").chars() {
            if c.is_ascii_uppercase() {
                key.push('-');
            }
            key.push(c.to_ascii_lowercase());
        }
        key
    }
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(InputManagerPlugin::<Action>::default())
        .init_resource::<Bindings>()
        .init_resource::<bindings::Map>()
        .init_resource::<Latched>()
        .add_systems(Startup, |mut commands: Commands| {
            commands.spawn((Name::new("Controls"), ActionState::<Action>::default()));
        })
        .add_systems(
            PreUpdate,
            bindings::read
                .in_set(InputManagerSystem::Update)
                .after(update_action_state::<Action>),
        )
        .add_systems(First, bindings::follow.after(MessageUpdateSystems))
        .add_systems(
            PreUpdate,
            (latch::feel_sticks, latch::catch_taps, latch::hold)
                .chain()
                .in_set(InputManagerSystem::ManualControl),
        );
}
