//! What is wrong with a stroke at snooker, and what it costs.

use crate::game::rules::call::Call;
use crate::game::rules::facts::{Facts, TIE};
use crate::game::rules::foul::Foul;
use crate::game::rules::jump::jumped_over;
use crate::game::rules::pool;
use crate::game::rules::snooker::{BallOn, Snooker, value};

/// Least and greatest cost of a foul.
const LEAST: i32 = 4;
const MOST: i32 = 7;

/// What the striker plays at.
#[derive(Clone, Debug)]
pub(super) struct Aim {
    /// Balls that may be hit first and potted.
    pub(super) on: Vec<usize>,
    /// The ball nominated as a free ball, if it is none of those that are on anyway.
    pub(super) free: Option<usize>,
    /// What the ball on is worth.
    pub(super) worth: i32,
}

/// What was wrong, and what it costs.
#[derive(Clone, Debug)]
pub(super) struct Wrong {
    pub(super) fouls: Vec<Foul>,
    pub(super) cost: i32,
    /// Whether the ball on was not hit first: what can be a miss.
    pub(super) missed: bool,
}

impl Snooker {
    /// What the striker plays at: the ball nominated, or the first one hit where nothing was said.
    pub(super) fn aim(&self, facts: &Facts, call: &Call) -> Aim {
        let scene = facts.scene;
        let regular = self.on.balls(scene);
        // What is played at comes before what is touched anyway.
        let hit = first_hit(facts).into_iter().chain(touching(facts));
        let mut seen = hit.filter(|ball| value(scene, *ball) > 0);
        let named = call.ball().filter(|ball| value(scene, *ball) > 0);
        if self.free_ball {
            let nominated = named.or_else(|| seen.next());
            let free = nominated.filter(|ball| !regular.contains(ball));
            // Together with a free ball the ball on may be hit and potted too.
            let on = regular.iter().copied().chain(free).collect();
            let worth = self.on.worth();
            return Aim { on, free, worth };
        }
        if self.on != BallOn::Colour {
            let worth = self.on.worth();
            return Aim {
                on: regular,
                free: None,
                worth,
            };
        }
        let nominated = named
            .filter(|ball| regular.contains(ball))
            .or_else(|| seen.find(|ball| regular.contains(ball)));
        Aim {
            worth: nominated.map_or(LEAST, |ball| value(scene, ball)),
            on: nominated.into_iter().collect(),
            free: None,
        }
    }

    /// Everything that was wrong, and what the dearest of it costs.
    pub(super) fn wrong(facts: &Facts, aim: &Aim) -> Wrong {
        let scene = facts.scene;
        let mut wrong = Wrong {
            fouls: Vec::new(),
            cost: LEAST.max(aim.worth),
            missed: false,
        };
        let mut add = |foul: Foul, worth: i32| {
            wrong.fouls.push(foul);
            wrong.cost = wrong.cost.max(worth).min(MOST);
        };
        let touching = touching(facts);
        // A touching ball that is on counts as hit; it must be played away from.
        let hit_by_touch = touching.iter().any(|ball| aim.on.contains(ball));
        for &ball in &touching {
            let moved = facts
                .met_by(facts.cue)
                .any(|(time, other)| other == ball && time <= TIE);
            if moved {
                add(Foul::Push { ball }, value(scene, ball));
            }
        }
        let first = first_hit(facts);
        let mut missed = false;
        if !hit_by_touch {
            match first.as_slice() {
                [] => {
                    missed = true;
                    add(Foul::NoContact, 0);
                }
                [hit] if !aim.on.contains(hit) => {
                    missed = true;
                    let (hit, on) = (*hit, aim.on.clone());
                    add(Foul::WrongBall { hit, on }, value(scene, hit));
                }
                [one, other, ..] if !first.iter().all(|ball| aim.on.contains(ball)) => {
                    let (one, other) = (*one, *other);
                    let worth = value(scene, one).max(value(scene, other));
                    add(Foul::Together { one, other }, worth);
                }
                _ => {}
            }
        }
        if let Some(foul) = pool::wrong_cue_ball(facts) {
            add(foul, 0);
        }
        if let Some(over) = jumped_over(facts) {
            add(Foul::Jump { over }, value(scene, over));
        }
        if let Some(pocket) = facts.scratch() {
            add(Foul::Scratch { pocket }, 0);
        }
        if facts.off.contains(&facts.cue) {
            add(Foul::CueBallOff, 0);
        }
        for ball in facts.object_off() {
            add(Foul::BallOff { ball }, value(scene, ball));
        }
        for potted in facts.object_potted() {
            let ball = potted.ball;
            if !aim.on.contains(&ball) {
                add(Foul::PottedNotOn { ball }, value(scene, ball));
            }
        }
        wrong.missed = missed;
        wrong
    }
}

/// The balls that the cue ball touches before the stroke.
pub(super) fn touching(facts: &Facts) -> Vec<usize> {
    (0..facts.scene.balls.len())
        .filter(|&ball| ball != facts.cue && facts.are_frozen(facts.cue, ball))
        .collect()
}

/// The balls that the cue ball met first, apart from those that it touched before: several if they came together.
fn first_hit(facts: &Facts) -> Vec<usize> {
    let touching = touching(facts);
    let met: Vec<(f64, usize)> = facts
        .met_by(facts.cue)
        .filter(|(time, ball)| *time > TIE || !touching.contains(ball))
        .collect();
    let mut first = Vec::new();
    for &(time, ball) in &met {
        if time - met[0].0 <= TIE && !first.contains(&ball) {
            first.push(ball);
        }
    }
    first
}
