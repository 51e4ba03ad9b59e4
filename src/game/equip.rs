//! Other equipment on the open table: another table, other balls, cloth, cushions or cue.

use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::practice::{BREAK_SPEED, Practice, aim_at_next, obey, take_up};
use crate::game::racking;
use crate::game::replay::Replay;
use crate::game::saying::Saying;
use crate::game::turns::Turns;
use crate::physics::equipment::{BallSet, Equipment};
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::messages::LoadScene;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// Play with this equipment as soon as nothing moves.
#[derive(Message, Clone, Debug, PartialEq)]
pub struct Equip {
    /// What to play with.
    pub equipment: Equipment,
    /// Whether to rack again. Else the balls stay where they are if they have room there.
    pub rack: bool,
}

/// The player asks for a preset by its name or its file.
#[derive(Message, Clone, Debug, PartialEq, Eq)]
pub struct ChoosePreset(pub String);

/// The player asks for a scene by its name, its file or its shared text.
#[derive(Message, Clone, Debug, PartialEq, Eq)]
pub struct OpenScene {
    /// What it is called.
    pub name: String,
    /// Whether to play it at once. Else it is laid out at rest, with the cue at its shot.
    pub play: bool,
}

/// Something a player should know.
#[derive(Message, Clone, Debug, PartialEq, Eq)]
pub struct Told {
    /// One line or more.
    pub text: Saying,
    /// Whether something went wrong.
    pub is_failure: bool,
}

/// The preset that is played with: a built-in name or a file. None if nobody chose one.
#[derive(Resource, Clone, Debug, Default, PartialEq, Eq)]
pub struct PresetInUse(pub Option<String>);

/// What waits until the balls rest; the last wish counts.
#[derive(Resource, Debug, Default)]
pub(super) struct Waiting(Option<Equip>);

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<PresetInUse>()
        .init_resource::<Waiting>()
        .add_message::<Equip>()
        .add_message::<ChoosePreset>()
        .add_message::<OpenScene>()
        .add_message::<Told>()
        .add_systems(
            FixedUpdate,
            (wait, equip.run_if(is_waited_for))
                .chain()
                .after(obey)
                .before(take_up)
                .before(SimSystems::Strike),
        );
}

fn wait(mut asked: MessageReader<Equip>, mut waiting: ResMut<Waiting>) {
    if let Some(newest) = asked.read().last() {
        waiting.0 = Some(newest.clone());
    }
}

/// Nothing is exchanged under moving balls, nor under a replay of the old ones.
fn is_waited_for(waiting: Res<Waiting>, clock: Res<Clock>, replay: Res<Replay>) -> bool {
    waiting.0.is_some() && !clock.moving && !replay.is_active()
}

/// Brings the equipment to the table. Where only laws or the cue are others nothing is laid out again. A match is played
/// with what was agreed on.
#[expect(
    clippy::too_many_arguments,
    reason = "the table, the match, what is wished for and what becomes of it"
)]
pub(super) fn equip(
    mut waiting: ResMut<Waiting>,
    mut playfield: ResMut<Playfield>,
    mut practice: ResMut<Practice>,
    mut aim: ResMut<Aim>,
    mut load: MessageWriter<LoadScene>,
    mut told: MessageWriter<Told>,
    turns: Res<Turns>,
    balls: BallQuery,
) {
    let Some(Equip { equipment, rack }) = waiting.0.take() else {
        return;
    };
    if turns.is_agreed() {
        told.write(Told {
            text: Saying::new(
                "notice-agreed",
                &[],
                "A match is played with what was agreed on: leave it first.",
            ),
            is_failure: true,
        });
        return;
    }
    let mut scene = snapshot(&playfield, &balls);
    let same_balls = BallSet::in_scene(&scene) == Some(equipment.balls);
    if !rack && same_balls && scene.table == equipment.table {
        playfield.laws = equipment.laws;
        playfield.cue = equipment.cue;
        if !equipment.laws.motion.is_closed_form() {
            playfield.solver = equipment.scene().solver;
        }
        return;
    }
    practice.history.laid(scene.clone(), *aim);
    let solver = scene.solver;
    let stays = !rack && equipment.take_over(&mut scene);
    if !stays {
        scene = racking::playable(&equipment, solver, practice.rack, practice.next_seed());
        aim.set_tip(0.0, 0.0);
        aim.set_elevation(0.0);
        aim.set_speed(BREAK_SPEED);
        aim_at_next(&mut aim, &scene, practice.rack);
        if !rack {
            told.write(Told {
                text: Saying::new(
                    "notice-no-room",
                    &[],
                    "The balls have no room on this table: racked again.",
                ),
                is_failure: false,
            });
        }
    }
    load.write(LoadScene(scene));
}
