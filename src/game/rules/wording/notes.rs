//! What is said of everything that is no foul: notes, ends and choices.

use crate::game::rules::verdict::{Choice, Note, Over, Reason};
use crate::game::rules::wording::{all_of, ball, plural, who};
use crate::game::saying::{Saying, Value};
use crate::physics::scene::Scene;

impl Note {
    /// What it says, in a sentence; `names` are those of the players.
    #[must_use]
    #[expect(clippy::too_many_lines, reason = "one arm for each note")]
    pub fn saying(&self, scene: &Scene, names: &[String]) -> Saying {
        let player = |player: &usize| ("name", who(names, *player));
        let none = Vec::new;
        let (key, values, english) = match self {
            Self::Group {
                player: who,
                solids: true,
            } => ("note-solids", vec![player(who)], "{name} has the solids."),
            Self::Group { player: who, .. } => {
                ("note-stripes", vec![player(who)], "{name} has the stripes.")
            }
            Self::TwoFouls { player: who } => (
                "note-two-fouls",
                vec![player(who)],
                "{name} has made two fouls in a row; a third costs dearly.",
            ),
            Self::ThreeFoulPenalty {
                player: who,
                points,
            } => (
                "note-three-fouls",
                vec![player(who), ("points", i64::from(*points).into())],
                plural(
                    i64::from(*points),
                    "{name} loses 1 point for three fouls in a row.",
                    "{name} loses {points} points for three fouls in a row.",
                ),
            ),
            Self::IllegalBreak { driven } => (
                "note-illegal-break",
                vec![("driven", (*driven).into())],
                plural(
                    *driven as i64,
                    "The break pocketed nothing and drove 1 ball to a cushion.",
                    "The break pocketed nothing and drove {driven} balls to a cushion.",
                ),
            ),
            Self::ThreePointBreak { points } => (
                "note-three-point-break",
                vec![("points", (*points).into())],
                plural(
                    *points as i64,
                    "The break made 1 point, three are needed.",
                    "The break made {points} points, three are needed.",
                ),
            ),
            Self::StalemateWarning => (
                "note-stalemate-warning",
                none(),
                "Nothing has fallen for long; if that goes on, the rack is broken again.",
            ),
            Self::Stalemate => (
                "note-stalemate",
                none(),
                "Nobody makes progress: the rack is broken again.",
            ),
            Self::NotCalled { balls } => (
                "note-not-called",
                vec![
                    ("balls", all_of(scene, balls)),
                    ("count", balls.len().into()),
                ],
                "Not called: {balls} fell; the turn passes.",
            ),
            Self::Safety => ("note-safety", none(), "A safety: the turn passes."),
            Self::PenaltyPoints { points } => (
                "note-penalty",
                vec![("points", i64::from(*points).into())],
                plural(
                    i64::from(*points),
                    "1 point for the other side.",
                    "{points} points for the other side.",
                ),
            ),
            Self::Miss { in_a_row } if *in_a_row > 1 => (
                "note-misses",
                vec![("count", i64::from(*in_a_row).into())],
                "Foul and a miss, {count} in a row with a ball in full view.",
            ),
            Self::Miss { .. } => ("note-miss", none(), "Foul and a miss."),
            Self::FreeBall => ("note-free-ball", none(), "Free ball."),
            Self::RespottedBlack => (
                "note-respotted-black",
                none(),
                "The scores are level: the black is spotted again.",
            ),
            Self::PutBack { ball: back } => (
                "note-put-back",
                vec![("ball", ball(scene, *back).into())],
                "Put back: {ball}, which had hung too long when it fell.",
            ),
            Self::Rerack => (
                "note-rerack",
                none(),
                "The other balls are racked again and the run goes on.",
            ),
            Self::EqualisingInning { player: who } => (
                "note-equalising-inning",
                vec![player(who)],
                "{name} has a last inning to draw level.",
            ),
        };
        Saying::of(key, values, english)
    }

    /// The same in English.
    #[must_use]
    pub fn sentence(&self, scene: &Scene, names: &[String]) -> String {
        self.saying(scene, names).english
    }
}

impl Reason {
    /// Why it is over, as a part of a sentence.
    fn saying(self, scene: &Scene) -> Saying {
        let one = |index: usize| -> Vec<(&'static str, Value)> {
            vec![("ball", ball(scene, index).into())]
        };
        let (key, values, english) = match self {
            Self::WinningBall { ball } => (
                "over-winning-ball",
                one(ball),
                "{ball} was pocketed as it must be",
            ),
            Self::LosingBall { ball } => (
                "over-losing-ball",
                one(ball),
                "{ball} fell or left the table when it must not",
            ),
            Self::ThreeFouls => ("over-three-fouls", Vec::new(), "three fouls in a row"),
            Self::ThreeMisses => (
                "over-three-misses",
                Vec::new(),
                "three misses in a row with a ball in full view",
            ),
            Self::Points { needed } => (
                "over-points",
                vec![("points", i64::from(needed).into())],
                plural(
                    i64::from(needed),
                    "1 point was reached",
                    "{points} points were reached",
                ),
            ),
            Self::Innings { played } => (
                "over-innings",
                vec![("innings", i64::from(played).into())],
                plural(
                    i64::from(played),
                    "1 inning was played",
                    "{innings} innings were played",
                ),
            ),
            Self::LastBall => ("over-last-ball", Vec::new(), "the last ball is gone"),
            Self::Conceded => ("over-conceded", Vec::new(), "the other side gave up"),
        };
        Saying::of(key, values, english)
    }
}

impl Over {
    /// How it ended, in a sentence; `names` are those of the players.
    #[must_use]
    pub fn saying(&self, scene: &Scene, names: &[String]) -> Saying {
        let why = ("why", self.reason.saying(scene).into());
        match self.winner {
            Some(winner) => {
                let values = vec![("name", who(names, winner)), why];
                Saying::of("over-won", values, "{name} wins: {why}.")
            }
            None => Saying::of("over-drawn", vec![why], "Nobody wins: {why}."),
        }
    }

    /// The same in English.
    #[must_use]
    pub fn sentence(&self, scene: &Scene, names: &[String]) -> String {
        self.saying(scene, names).english
    }
}

impl Choice {
    /// What a button for it says.
    #[must_use]
    pub fn saying(self) -> Saying {
        let (key, english) = match self {
            Self::Accept => ("choice-accept", "Play from here"),
            Self::InHand => ("choice-in-hand", "Take the cue ball in hand"),
            Self::Break => ("choice-break", "Rack again and break"),
            Self::TheyBreak => ("choice-they-break", "Rack again, the other player breaks"),
            Self::HandBack => ("choice-hand-back", "Let the other player play"),
            Self::PutBack => (
                "choice-put-back",
                "Put the balls back, the other player plays again",
            ),
            Self::Spot => ("choice-spot", "Spot the balls that touch"),
            Self::GoFirst => ("choice-go-first", "Go first"),
            Self::GoSecond => ("choice-go-second", "Let the other player go first"),
        };
        Saying::new(key, &[], english)
    }
}
