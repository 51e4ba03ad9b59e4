//! What is said of fouls.

use crate::game::rules::foul::Foul;
use crate::game::rules::wording::{any_of, ball, plural, pocket};
use crate::game::saying::{Saying, Value};
use crate::physics::scene::Scene;

impl Foul {
    /// The rule, as its code names it.
    #[must_use]
    pub fn rule(&self) -> Saying {
        let (key, english) = match self {
            Self::Scratch { .. } => ("rule-scratch", "Cue ball pocketed"),
            Self::CueBallOff => ("rule-cue-ball-off", "Cue ball driven off the table"),
            Self::NoContact => ("rule-no-contact", "No ball hit"),
            Self::WrongBall { .. } => ("rule-wrong-ball", "Wrong ball first"),
            Self::NoCushion => ("rule-no-cushion", "No cushion after contact"),
            Self::BallOff { .. } => ("rule-ball-off", "Object ball driven off the table"),
            Self::BehindString { .. } => {
                ("rule-behind-string", "Bad play from behind the head string")
            }
            Self::WeakBreak { .. } => ("rule-weak-break", "Break requirements not met"),
            Self::PottedNotOn { .. } => ("rule-potted-not-on", "Ball not on potted"),
            Self::Together { .. } => ("rule-together", "Two balls struck together"),
            Self::Jump { .. } => ("rule-jump", "Jump shot"),
            Self::Push { .. } => ("rule-push", "Push stroke"),
            Self::SnookeredBehindFreeBall { .. } => {
                ("rule-free-ball", "Snookered behind the free ball")
            }
            Self::WrongCueBall { .. } => ("rule-wrong-cue-ball", "Wrong cue ball"),
            Self::IntoFrozen { .. } => ("rule-into-frozen", "Frozen ball shot into"),
        };
        Saying::new(key, &[], english)
    }

    /// What happened, in a sentence that begins with the name of the rule.
    #[must_use]
    pub fn saying(&self, scene: &Scene) -> Saying {
        let one = |index: &usize| -> Value { ball(scene, *index).into() };
        let (key, values, what) = match self {
            Self::Scratch { pocket: into } => (
                "foul-scratch",
                vec![("pocket", pocket(scene, *into).into())],
                "the cue ball fell into the {pocket} pocket",
            ),
            Self::CueBallOff => (
                "foul-cue-ball-off",
                Vec::new(),
                "the cue ball left the table",
            ),
            Self::NoContact => (
                "foul-no-contact",
                Vec::new(),
                "the cue ball met no other ball",
            ),
            Self::WrongBall { hit, on } => (
                "foul-wrong-ball",
                vec![("hit", one(hit)), ("on", any_of(scene, on))],
                "the cue ball met {hit} first, on was {on}",
            ),
            Self::NoCushion => (
                "foul-no-cushion",
                Vec::new(),
                "no ball was pocketed, and none reached a cushion after the contact",
            ),
            Self::BallOff { ball } => (
                "foul-ball-off",
                vec![("ball", one(ball))],
                "{ball} left the table",
            ),
            Self::BehindString { hit } => (
                "foul-behind-string",
                vec![("ball", one(hit))],
                "from in hand behind the head string the cue ball met {ball} without crossing the string first",
            ),
            Self::WeakBreak { driven, needed } => (
                "foul-weak-break",
                vec![("driven", (*driven).into()), ("needed", (*needed).into())],
                plural(
                    *driven as i64,
                    "no ball was pocketed and 1 ball reached a cushion, {needed} were needed",
                    "no ball was pocketed and {driven} balls reached a cushion, {needed} were needed",
                ),
            ),
            Self::PottedNotOn { ball } => (
                "foul-potted-not-on",
                vec![("ball", one(ball))],
                "{ball} was pocketed and was not on",
            ),
            Self::Together { one: first, other } => (
                "foul-together",
                vec![("one", one(first)), ("other", one(other))],
                "the cue ball met {one} and {other} at once, and they were not both on",
            ),
            Self::Jump { over } => (
                "foul-jump",
                vec![("ball", one(over))],
                "the cue ball passed over {ball}",
            ),
            Self::Push { ball } => (
                "foul-push",
                vec![("ball", one(ball))],
                "{ball} touched the cue ball and was moved by the stroke",
            ),
            Self::SnookeredBehindFreeBall { ball } => (
                "foul-free-ball",
                vec![("ball", one(ball))],
                "the opponent was left snookered behind the free ball, {ball}",
            ),
            Self::WrongCueBall { struck } => (
                "foul-wrong-cue-ball",
                vec![("ball", one(struck))],
                "the cue struck {ball}",
            ),
            Self::IntoFrozen { ball } => (
                "foul-into-frozen",
                vec![("ball", one(ball))],
                "the cue ball was shot into {ball}, which was frozen to it",
            ),
        };
        let sentence = format!("{}: {what}.", self.rule().english);
        Saying::of(key, values, &sentence)
    }

    /// The same in English.
    #[must_use]
    pub fn sentence(&self, scene: &Scene) -> String {
        self.saying(scene).english
    }
}
