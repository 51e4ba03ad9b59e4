//! Every shot of a match, as little as it takes to play it again.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::game::rules::{Call, Choice, Foul, GameState, Note, Over, Verdict};
use crate::physics::ball::{Motion, State};
use crate::physics::cue::Shot;
use crate::physics::scene::{PlannedShot, Scene};

/// Where one ball lies: centre in m, and whether it is in play.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Place {
    pub(super) at: DVec3,
    #[serde(default, skip_serializing_if = "is_rest")]
    pub(super) motion: Motion,
}

fn is_rest(motion: &Motion) -> bool {
    *motion == Motion::Rest
}

/// Where all balls lie at rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Lie {
    pub(super) places: Vec<Place>,
}

impl Lie {
    /// The places of the balls of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let place = |state: &State| Place {
            at: state.position,
            motion: state.motion,
        };
        Self {
            places: scene.balls.iter().map(|ball| place(&ball.state)).collect(),
        }
    }

    /// A scene with its balls there, without a stroke.
    #[must_use]
    pub fn on(&self, base: &Scene) -> Scene {
        let mut scene = Scene {
            shot: None,
            ..base.clone()
        };
        for (ball, place) in scene.balls.iter_mut().zip(&self.places) {
            ball.state = State {
                motion: place.motion,
                ..State::at_rest(place.at)
            };
        }
        scene
    }
}

/// A shot that was played, and what was said of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlayedShot {
    /// Which rack, from 0.
    pub rack: u32,
    /// Where the game stood before it.
    pub before: GameState,
    /// Where the balls lay before it.
    pub lie: Lie,
    /// The ball struck: index in the scene.
    pub ball: usize,
    /// The stroke.
    pub shot: Shot,
    /// What was called.
    pub call: Call,
    /// Seconds of thought.
    pub thought: f64,
    /// What was wrong.
    pub fouls: Vec<Foul>,
    /// Object balls that fell.
    pub pocketed: Vec<usize>,
    /// Of these, the ones potted as the rules ask.
    pub made: Vec<usize>,
    /// Change of each player's score.
    pub points: Vec<i32>,
    /// Things worth saying.
    pub notes: Vec<Note>,
    /// How the rack ended with it, if it did.
    pub over: Option<Over>,
    /// What was chosen after it.
    pub chosen: Vec<Choice>,
}

impl PlayedShot {
    /// The shot with what a referee said of it.
    pub(super) fn new(
        rack: u32,
        before: GameState,
        scene: &Scene,
        planned: PlannedShot,
        call: Call,
        thought: f64,
        verdict: &Verdict,
    ) -> Self {
        Self {
            rack,
            before,
            lie: Lie::of(scene),
            ball: planned.ball,
            shot: planned.shot,
            call,
            thought,
            fouls: verdict.fouls.clone(),
            pocketed: verdict.pocketed.clone(),
            made: verdict.made.clone(),
            points: verdict.points.clone(),
            notes: verdict.notes.clone(),
            over: verdict.next.standing.over,
            chosen: Vec::new(),
        }
    }

    /// Who played it.
    #[must_use]
    pub fn player(&self) -> usize {
        self.before.standing.turn
    }

    /// The scene of the shot, the stroke included.
    pub(super) fn scene(&self, base: &Scene) -> Scene {
        let mut scene = self.lie.on(base);
        scene.shot = Some(PlannedShot {
            ball: self.ball,
            shot: self.shot,
        });
        scene
    }
}
