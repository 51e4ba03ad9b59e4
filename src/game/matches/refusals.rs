//! Why a match does not do what was asked, and how that is said.

use thiserror::Error;

use crate::game::rules::{Call, Choice};
use crate::game::saying::Saying;
use crate::physics::scene::SceneError;

/// What stands in the way of something.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum Hindrance {
    /// A choice is due.
    #[error("there is something to choose first")]
    ToChoose,
    /// A stroke is due.
    #[error("a stroke comes first")]
    ToPlay,
    /// The rack is over.
    #[error("the rack is over")]
    RackOver,
    /// The match is over.
    #[error("the match is over")]
    MatchOver,
    /// The cue ball is not in hand.
    #[error("the cue ball is not in hand")]
    NotInHand,
    /// Only the cue ball may be moved.
    #[error("only a cue ball in hand may be moved")]
    NotTheCueBall,
    /// Nobody agreed on taking back shots.
    #[error("it was not agreed on")]
    NotAgreed,
    /// Only in practice balls are moved freely.
    #[error("this is no practice")]
    NoPractice,
    /// Somebody else is at the table.
    #[error("another player is at the table")]
    NotTheirTurn,
    /// There is no match.
    #[error("no match is on")]
    NoMatch,
    /// There is a match, which the menu leaves.
    #[error("a match is on; it is left in the menu")]
    MatchOn,
}

impl Hindrance {
    fn saying(self) -> Saying {
        let key = match self {
            Self::ToChoose => "hindrance-to-choose",
            Self::ToPlay => "hindrance-to-play",
            Self::RackOver => "hindrance-rack-over",
            Self::MatchOver => "hindrance-match-over",
            Self::NotInHand => "hindrance-not-in-hand",
            Self::NotTheCueBall => "hindrance-not-the-cue-ball",
            Self::NotAgreed => "hindrance-not-agreed",
            Self::NoPractice => "hindrance-no-practice",
            Self::NotTheirTurn => "hindrance-not-their-turn",
            Self::NoMatch => "hindrance-no-match",
            Self::MatchOn => "hindrance-match-on",
        };
        Saying::new(key, &[], self.to_string())
    }
}

/// Why a ball may not lie somewhere.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum NoPlace {
    /// It is not within the area.
    #[error("outside the area")]
    Outside,
    /// Another ball or a cushion is there.
    #[error("no room")]
    NoRoom,
}

/// Why something is not done. The match is then as it was.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Refused {
    /// The wrong number of players.
    #[error("players: {given} players, {game} is for {least} to {most}")]
    Players {
        /// The game.
        game: &'static str,
        /// Players given.
        given: usize,
        /// Least.
        least: usize,
        /// Most.
        most: usize,
    },
    /// A player's index that is none.
    #[error("{field}: there is no player number {player}, there are {count}")]
    NoSuchPlayer {
        /// The field.
        field: &'static str,
        /// Index given.
        player: usize,
        /// Number of players.
        count: usize,
    },
    /// No rack to win.
    #[error("race: 0 racks, at least 1 is needed")]
    NoRace,
    /// The table does not fit the game.
    #[error("table: {pockets} pockets, {game} is played on a table {with} pockets")]
    Table {
        /// The game.
        game: &'static str,
        /// Pockets of the table.
        pockets: usize,
        /// `with` or `without`.
        with: &'static str,
    },
    /// The scene cannot be played.
    #[error(transparent)]
    Scene(SceneError),
    /// It is not the time for this.
    #[error("{what} is not possible now: {now}")]
    NotNow {
        /// What was tried.
        what: &'static str,
        /// What the match waits for.
        now: Hindrance,
    },
    /// The cue ball may not lie there.
    #[error("cue ball: it may not be put down at x {x} m, z {z} m: {why}")]
    Place {
        /// Place in m.
        x: f64,
        /// Place in m.
        z: f64,
        /// Why.
        why: NoPlace,
    },
    /// Something that may not be called now.
    #[error("call: {call:?} may not be called now")]
    Call {
        /// The call.
        call: Call,
    },
    /// A choice that was not offered.
    #[error("choice: {choice:?} was not offered")]
    Choice {
        /// The choice.
        choice: Choice,
    },
    /// A record of other balls.
    #[error("record: it has {given} balls, the table has {count}")]
    Record {
        /// Balls in the record.
        given: usize,
        /// Balls on the table.
        count: usize,
    },
    /// Seconds that are none.
    #[error("thought: {seconds} s is no time")]
    Thought {
        /// The seconds.
        seconds: f64,
    },
    /// Too many shots to take back.
    #[error("undo: {asked} shots, {played} have been played")]
    TooFar {
        /// Shots to take back.
        asked: usize,
        /// Shots played.
        played: usize,
    },
}

impl Refused {
    /// What a player is told.
    #[must_use]
    pub fn saying(&self) -> Saying {
        let none = Vec::new();
        match self {
            Self::NotNow { now, .. } => Saying::of(
                "refused-now",
                vec![("why", now.saying().into())],
                "Not possible now: {why}.",
            ),
            Self::Place {
                why: NoPlace::Outside,
                ..
            } => Saying::of(
                "refused-outside",
                none,
                "The cue ball must be put down within the line.",
            ),
            Self::Place {
                why: NoPlace::NoRoom,
                ..
            } => Saying::of("refused-no-room", none, "There is no room for the ball."),
            Self::Call { .. } => Saying::of("refused-call", none, "That may not be called now."),
            Self::Choice { .. } => Saying::of("refused-choice", none, "That was not offered."),
            Self::TooFar { .. } => Saying::of(
                "refused-too-far",
                none,
                "There is no shot left to take back.",
            ),
            Self::Players { .. }
            | Self::NoSuchPlayer { .. }
            | Self::NoRace
            | Self::Table { .. }
            | Self::Scene(_)
            | Self::Record { .. }
            | Self::Thought { .. } => Saying::of(
                "refused-other",
                vec![("reason", self.to_string().as_str().into())],
                "That is not possible: {reason}.",
            ),
        }
    }
}
