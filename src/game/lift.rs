//! The cue is held as low as the player wishes and as high as balls and rails behind the cue ball ask.

use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::physics::cue::Shot;
use crate::physics::cue_path::{self, Lift};
use crate::physics::scene::Scene;
use crate::sim::clock::Clock;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// How much room the cue has for the present aim.
#[derive(Resource, Clone, Debug, Default)]
pub struct CueRoom {
    /// The least elevation and what is below; `None` if the cue has no room at any elevation.
    pub lift: Option<Lift>,
    /// What it was worked out for.
    known: Option<(Scene, usize, Shot)>,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<CueRoom>();
}

/// Raises the aim to the least elevation at which the cue is free, and lowers it again to what the player wished where
/// there is room. Nothing changes while balls move. Whoever plays strokes runs it after aiming and before striking.
pub fn raise(
    mut aim: ResMut<Aim>,
    mut room: ResMut<CueRoom>,
    clock: Res<Clock>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    if clock.moving || playfield.solver.is_crowd() {
        return;
    }
    let level = Shot {
        elevation: 0.0,
        speed: 0.0,
        ..aim.shot
    };
    let scene = snapshot(&playfield, &balls);
    let is_known = room
        .known
        .as_ref()
        .is_some_and(|(at, ball, shot)| *ball == aim.ball && *shot == level && *at == scene);
    if !is_known {
        room.lift = cue_path::lift(&scene, aim.ball, &level);
        room.known = Some((scene, aim.ball, level));
    }
    // A cue without any room is left as it is: the player is told.
    let least = room.lift.map_or(0.0, |lift| lift.elevation);
    let mut raised = *aim;
    raised.shot.elevation = aim.wish.max(least).min(Aim::TOP_ELEVATION.max(least));
    aim.set_if_neq(raised);
}
