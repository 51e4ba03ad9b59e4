//! A match at the table: whose turn it is, what the referee says, and computer players at the cue.
//!
//! The rules and the players are pure; this is where they meet the table. A person's stroke comes as a
//! [`Strike`](crate::sim::messages::Strike) like any other and is vetoed where it is not theirs to play. When the balls
//! rest, the record goes to the match, and the table is laid out as the referee leaves it. A computer player thinks in a
//! task, shows what it means to do, and strikes.

mod computer;
mod desk;
mod referee;
mod saves;

use std::path::PathBuf;

use bevy::prelude::*;

use crate::game::Keeping;
use crate::game::matches::store::StoreError;
use crate::game::matches::{
    Hindrance, Match, Mind, Phase, Refused, SavedError, Session, Setup, Store,
};
use crate::game::players::Progress;
use crate::game::practice::{obey, settle, take_up};
use crate::game::replay::{leave, leave_for_scene};
use crate::game::rules::{Call, Choice, Game, Verdict};
use crate::game::saying::Saying;
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;
use crate::sim::SimSystems;
use crate::sim::messages::LoadScene;
use computer::AtTheCue;

/// The match that is played at the table, if there is one.
#[derive(Resource, Debug, Default)]
pub struct Turns {
    session: Option<Session>,
    /// The stroke that is being played, and how long it was thought about in s.
    stroke: Option<(Shot, f64)>,
    /// When the player at the table could begin to think, in s of the fixed clock.
    since: f64,
    computer: Option<AtTheCue>,
    /// What was said of the last stroke, and who played it.
    said: Option<(usize, Verdict)>,
    /// Whether the cue is to be taken up for the table that was laid out.
    cue_is_due: bool,
    /// Why the last save failed, if it did.
    unsaved: Option<String>,
}

/// Where matches are saved; nowhere by default.
#[derive(Resource, Clone, Debug, Default)]
pub struct MatchStore(pub Option<Store>);

/// What a player asks of the match.
#[derive(Message, Clone, Debug)]
pub enum TurnCommand {
    /// Begin this match with the table, the laws, the cue and the balls of a scene.
    Begin {
        /// What is agreed on.
        setup: Box<Setup>,
        /// What it is played with.
        like: Box<Scene>,
    },
    /// Go on with the match that saved itself last.
    Resume,
    /// Leave the match; the table stays as it lies, for practice.
    Leave,
    /// Say what the next stroke is meant to do.
    Call(Call),
    /// Take one of the choices offered.
    Choose(Choice),
    /// Set up the next rack.
    NextRack,
    /// Give up the rack.
    Concede,
    /// Take back the last shot, and those of computer players after the last one of a person.
    Undo,
    /// Do not wait for the computer player: it plays the best it has found so far.
    Hurry,
    /// Show a shot of this match again, counted from 0.
    Watch(usize),
}

/// What became of a command, or of a stroke.
#[derive(Message, Debug)]
pub enum TurnNews {
    /// A match has begun, or goes on.
    Begun,
    /// The referee has spoken: [`Turns::said`].
    Judged,
    /// Somebody has chosen.
    Chosen {
        /// Who.
        player: usize,
        /// What.
        choice: Choice,
    },
    /// Something was not allowed.
    Refused(Refused),
    /// Something went wrong; the match is as it was.
    Failed(Saying),
    /// The match was saved, and a file that could not be replaced was put aside.
    PutAside {
        /// Where it is now.
        kept: PathBuf,
        /// Why it could not be replaced.
        why: SavedError,
    },
    /// The match could not be saved; it goes on, and every shot tries again.
    NotSaved(StoreError),
    /// The match is saved again after it could not be.
    SavedAgain,
}

impl Turns {
    /// The match.
    #[must_use]
    pub fn game(&self) -> Option<&Match> {
        self.session.as_ref().map(Session::game)
    }

    /// Whether a match is on.
    #[must_use]
    pub fn is_on(&self) -> bool {
        self.session.is_some()
    }

    /// What the match waits for; `None` without a match, and while balls move.
    #[must_use]
    pub fn phase(&self) -> Option<Phase> {
        let game = self.game().filter(|_| self.stroke.is_none())?;
        Some(game.phase())
    }

    /// Who is at the table.
    #[must_use]
    pub fn player(&self) -> Option<usize> {
        self.game().map(|game| game.state().standing.turn)
    }

    /// Whether the player at the table is a computer.
    #[must_use]
    pub fn is_computers(&self) -> bool {
        self.game().is_some_and(is_computers)
    }

    /// Whether a person may strike: always without a match.
    #[must_use]
    pub fn may_strike(&self) -> bool {
        !self.is_on() || (self.phase() == Some(Phase::Play) && !self.is_computers())
    }

    /// Whether a person has the cue ball in hand: it alone may be moved then, and only within its area.
    #[must_use]
    pub fn places_cue_ball(&self) -> bool {
        self.is_on() && self.hinders_placing().is_none() && !self.is_practice()
    }

    /// What hinders whoever is at the table from moving balls in a match.
    #[must_use]
    pub fn hinders_placing(&self) -> Option<Hindrance> {
        let Some(game) = self.game() else {
            return Some(Hindrance::NoMatch);
        };
        if !self.may_strike() {
            return Some(Hindrance::NotTheirTurn);
        }
        let free = self.is_practice() || game.state().standing.in_hand.is_some();
        (!free).then_some(Hindrance::NotInHand)
    }

    /// Whether a match is on whose table, laws and cue are agreed on: any but free practice.
    #[must_use]
    pub fn is_agreed(&self) -> bool {
        self.is_on() && !self.is_practice()
    }

    fn is_practice(&self) -> bool {
        let game = self.game().map(|game| &game.setup().game);
        matches!(game, Some(Game::FreePractice(_)))
    }

    /// What the referee said last, and of whom.
    #[must_use]
    pub fn said(&self) -> Option<&(usize, Verdict)> {
        self.said.as_ref()
    }

    /// How far the computer player has come, while one thinks.
    #[must_use]
    pub fn progress(&self) -> Option<Progress> {
        self.computer.as_ref().and_then(AtTheCue::progress)
    }

    /// The name of the level of the computer player at the table.
    #[must_use]
    pub fn level(&self) -> Option<&str> {
        self.game().and_then(level_name)
    }
}

fn level_name(game: &Match) -> Option<&str> {
    let player = game.setup().players.get(game.state().standing.turn)?;
    match &player.mind {
        Mind::Person => None,
        Mind::Computer { level } => Some(level),
    }
}

fn is_computers(game: &Match) -> bool {
    level_name(game).is_some()
}

/// A person may strike now: a run condition for whatever moves the cue.
#[must_use]
pub fn may_strike(turns: Res<Turns>) -> bool {
    turns.may_strike()
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Turns>()
        .init_resource::<MatchStore>()
        .add_message::<TurnCommand>()
        .add_message::<TurnNews>()
        .add_systems(
            FixedUpdate,
            (
                (desk::give_way, desk::obey, leave_for_scene)
                    .chain()
                    .after(leave)
                    .before(obey)
                    .before(SimSystems::Strike),
                (
                    desk::make_room.run_if(on_message::<LoadScene>),
                    desk::take_cue.run_if(|turns: Res<Turns>| turns.cue_is_due),
                    referee::veto,
                    computer::play,
                )
                    .chain()
                    .after(take_up)
                    .before(SimSystems::Strike),
                (
                    referee::begin,
                    referee::judge,
                    referee::recover,
                    saves::tell,
                )
                    .chain()
                    .after(settle)
                    .in_set(SimSystems::Judge),
            ),
        )
        .add_systems(
            Last,
            // It changes nothing on the table: whatever runs beside it.
            saves::finish
                .run_if(on_message::<AppExit>)
                .in_set(Keeping)
                .ambiguous_with_all(),
        );
}
