//! Fouls, and the one place with the sentences that explain them.

use serde::{Deserialize, Serialize};

use crate::game::rules::targets::number;
use crate::physics::scene::Scene;

/// What was wrong with a stroke. Balls are indices in the scene, pockets indices in the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Foul {
    /// The cue ball fell.
    Scratch {
        /// Where.
        pocket: usize,
    },
    /// The cue ball left the table.
    CueBallOff,
    /// The cue ball met no ball.
    NoContact,
    /// The cue ball met a ball first that was not on.
    WrongBall {
        /// The ball met.
        hit: usize,
        /// The balls that might have been met.
        on: Vec<usize>,
    },
    /// Nothing was potted, and nothing reached a cushion after the contact.
    NoCushion,
    /// An object ball left the table.
    BallOff {
        /// The ball.
        ball: usize,
    },
    /// From in hand behind the head string the cue ball met a ball behind it without crossing it first.
    BehindString {
        /// The ball met.
        hit: usize,
    },
    /// A break that drove too few balls to cushions, in a game where that is a foul.
    WeakBreak {
        /// Balls driven to cushions.
        driven: usize,
        /// Balls that were needed.
        needed: usize,
    },
    /// A ball was potted that was not on.
    PottedNotOn {
        /// The ball.
        ball: usize,
    },
    /// The cue ball met two balls at once that were not both on.
    Together {
        /// One of them.
        one: usize,
        /// The other.
        other: usize,
    },
    /// The cue ball passed over a ball.
    Jump {
        /// The ball.
        over: usize,
    },
    /// A ball that touched the cue ball was moved by the stroke.
    Push {
        /// The ball.
        ball: usize,
    },
    /// The opponent was left snookered behind the free ball.
    SnookeredBehindFreeBall {
        /// The free ball.
        ball: usize,
    },
    /// The wrong ball was struck with the cue.
    WrongCueBall {
        /// The ball struck.
        struck: usize,
    },
    /// The opponent's frozen ball was shot into.
    IntoFrozen {
        /// The ball.
        ball: usize,
    },
}

impl Foul {
    /// The rule, as its code names it.
    #[must_use]
    pub fn rule(&self) -> &'static str {
        match self {
            Self::Scratch { .. } => "cue ball pocketed",
            Self::CueBallOff => "cue ball driven off the table",
            Self::NoContact => "no ball hit",
            Self::WrongBall { .. } => "wrong ball first",
            Self::NoCushion => "no cushion after contact",
            Self::BallOff { .. } => "object ball driven off the table",
            Self::BehindString { .. } => "bad play from behind the head string",
            Self::WeakBreak { .. } => "break requirements not met",
            Self::PottedNotOn { .. } => "ball not on potted",
            Self::Together { .. } => "two balls struck together",
            Self::Jump { .. } => "jump shot",
            Self::Push { .. } => "push stroke",
            Self::SnookeredBehindFreeBall { .. } => "snookered behind the free ball",
            Self::WrongCueBall { .. } => "wrong cue ball",
            Self::IntoFrozen { .. } => "frozen ball shot into",
        }
    }

    /// What happened, in a sentence that begins with the name of the rule.
    #[must_use]
    pub fn sentence(&self, scene: &Scene) -> String {
        let ball = |index: &usize| named(scene, *index);
        let what = match self {
            Self::Scratch { pocket } => {
                format!(
                    "the cue ball fell into the {} pocket",
                    pocket_named(scene, *pocket)
                )
            }
            Self::CueBallOff => "the cue ball left the table".to_owned(),
            Self::NoContact => "the cue ball met no other ball".to_owned(),
            Self::WrongBall { hit, on } => {
                format!(
                    "the cue ball met {} first, on was {}",
                    ball(hit),
                    listed(scene, on)
                )
            }
            Self::NoCushion => {
                "no ball was pocketed, and none reached a cushion after the contact".to_owned()
            }
            Self::BallOff { ball: off } => format!("{} left the table", ball(off)),
            Self::BehindString { hit } => format!(
                "from in hand behind the head string the cue ball met {} without crossing the string first",
                ball(hit)
            ),
            Self::WeakBreak { driven, needed } => format!(
                "no ball was pocketed and {driven} balls reached a cushion, {needed} were needed"
            ),
            Self::PottedNotOn { ball: potted } => {
                format!("{} was pocketed and was not on", ball(potted))
            }
            Self::Together { one, other } => format!(
                "the cue ball met {} and {} at once, and they were not both on",
                ball(one),
                ball(other)
            ),
            Self::Jump { over } => format!("the cue ball passed over {}", ball(over)),
            Self::Push { ball: touched } => {
                format!(
                    "{} touched the cue ball and was moved by the stroke",
                    ball(touched)
                )
            }
            Self::SnookeredBehindFreeBall { ball: free } => {
                format!(
                    "the opponent was left snookered behind the free ball, {}",
                    ball(free)
                )
            }
            Self::WrongCueBall { struck } => format!("the cue struck {}", ball(struck)),
            Self::IntoFrozen { ball: frozen } => {
                format!(
                    "the cue ball was shot into {}, which was frozen to it",
                    ball(frozen)
                )
            }
        };
        format!("{}: {what}.", capital(self.rule()))
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// What people call a ball: the 8, the cue ball, the blue, a red.
#[must_use]
pub fn named(scene: &Scene, ball: usize) -> String {
    match scene.balls.get(ball).map(|ball| ball.name.as_str()) {
        None => format!("ball number {ball}"),
        Some("cue") => "the cue ball".to_owned(),
        Some(name) if name.starts_with("red ") => "a red".to_owned(),
        Some(name) => format!("the {name}"),
    }
}

fn pocket_named(scene: &Scene, pocket: usize) -> String {
    let mut pockets = scene.table.pockets.iter();
    pockets
        .nth(pocket)
        .map_or_else(|| format!("number {pocket}"), |pocket| pocket.name.clone())
}

/// The balls in the order of their numbers, each name once.
#[must_use]
pub fn listed(scene: &Scene, balls: &[usize]) -> String {
    let mut names: Vec<String> = Vec::new();
    let mut balls = balls.to_vec();
    balls.sort_by_key(|&ball| (number(scene, ball), ball));
    for name in balls.iter().map(|ball| named(scene, *ball)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    match names.split_last() {
        None => "nothing".to_owned(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}
