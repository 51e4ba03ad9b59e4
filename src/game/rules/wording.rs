//! Everything that the rules say to people, in English, in one place.

use crate::game::rules::foul::Foul;
use crate::game::rules::targets::number;
use crate::game::rules::verdict::{Choice, Note, Over, Reason};
use crate::physics::scene::Scene;

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

/// Somebody by name; players without one are counted.
fn who(names: &[String], player: usize) -> String {
    let name = names.get(player).filter(|name| !name.is_empty());
    name.map_or_else(|| format!("player {}", player + 1), Clone::clone)
}

fn count(number: i32, one: &str, many: &str) -> String {
    if number == 1 {
        format!("1 {one}")
    } else {
        format!("{number} {many}")
    }
}

impl Note {
    /// What it says, in a sentence; `names` are those of the players.
    #[must_use]
    pub fn sentence(&self, scene: &Scene, names: &[String]) -> String {
        let what = match self {
            Self::Group { player, solids } => {
                let group = if *solids { "solids" } else { "stripes" };
                format!("{} has the {group}", who(names, *player))
            }
            Self::TwoFouls { player } => {
                format!(
                    "{} has made two fouls in a row; a third costs dearly",
                    who(names, *player)
                )
            }
            Self::ThreeFoulPenalty { player, points } => {
                let points = count(*points, "point", "points");
                format!(
                    "{} loses {points} for three fouls in a row",
                    who(names, *player)
                )
            }
            Self::IllegalBreak { driven } => {
                let balls = count(*driven as i32, "ball", "balls");
                format!("the break pocketed nothing and drove {balls} to a cushion")
            }
            Self::ThreePointBreak { points } => {
                let points = count(*points as i32, "point", "points");
                format!("the break made {points}, three are needed")
            }
            Self::StalemateWarning => {
                "nothing has fallen for long; if that goes on, the rack is broken again".to_owned()
            }
            Self::Stalemate => "nobody makes progress: the rack is broken again".to_owned(),
            Self::NotCalled { balls } => {
                format!(
                    "{} fell without being called; the turn passes",
                    all_of(scene, balls)
                )
            }
            Self::Safety => "a safety: the turn passes".to_owned(),
            Self::PenaltyPoints { points } => {
                format!("{} for the other side", count(*points, "point", "points"))
            }
            Self::Miss { in_a_row } if *in_a_row > 1 => {
                format!("foul and a miss, {in_a_row} in a row with a ball in full view")
            }
            Self::Miss { .. } => "foul and a miss".to_owned(),
            Self::FreeBall => "free ball".to_owned(),
            Self::RespottedBlack => "the scores are level: the black is spotted again".to_owned(),
            Self::PutBack { ball } => {
                format!(
                    "{} had hung too long when it fell, and is put back",
                    named(scene, *ball)
                )
            }
            Self::Rerack => "the other balls are racked again and the run goes on".to_owned(),
            Self::EqualisingInning { player } => {
                format!("{} has a last inning to draw level", who(names, *player))
            }
        };
        format!("{}.", capital(&what))
    }
}

/// All of these balls, each name once.
fn all_of(scene: &Scene, balls: &[usize]) -> String {
    listed(scene, balls).replace(" or ", " and ")
}

impl Over {
    /// How it ended, in a sentence; `names` are those of the players.
    #[must_use]
    pub fn sentence(&self, scene: &Scene, names: &[String]) -> String {
        let why = match self.reason {
            Reason::WinningBall { ball } => {
                format!("{} was pocketed as it must be", named(scene, ball))
            }
            Reason::LosingBall { ball } => {
                format!(
                    "{} fell or left the table when it must not",
                    named(scene, ball)
                )
            }
            Reason::ThreeFouls => "three fouls in a row".to_owned(),
            Reason::ThreeMisses => "three misses in a row with a ball in full view".to_owned(),
            Reason::Points { needed } => {
                format!("{} were reached", count(needed, "point", "points"))
            }
            Reason::Innings { played } => {
                format!("{} were played", count(played as i32, "inning", "innings"))
            }
            Reason::LastBall => "the last ball is gone".to_owned(),
            Reason::Conceded => "the other side gave up".to_owned(),
        };
        match self.winner {
            Some(winner) => format!("{} wins: {why}.", capital(&who(names, winner))),
            None => format!("Nobody wins: {why}."),
        }
    }
}

impl Choice {
    /// What a button for it says.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Accept => "Play from here",
            Self::InHand => "Take the cue ball in hand",
            Self::Break => "Rack again and break",
            Self::TheyBreak => "Rack again, the other player breaks",
            Self::HandBack => "Let the other player play",
            Self::PutBack => "Put the balls back, the other player plays again",
            Self::Spot => "Spot the balls that touch",
            Self::GoFirst => "Go first",
            Self::GoSecond => "Let the other player go first",
        }
    }
}
