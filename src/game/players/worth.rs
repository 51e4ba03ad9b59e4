//! What a position is worth: the probability of winning the rack for the player at the table.
//!
//! A rack is a race. Let f(n, m) be the probability that the player at the table wins who has n balls to go against m,
//! if either pots with probability r: f(n, m) = r f(n − 1, m) + (1 − r) (1 − f(m, n)), f(0, m) = 1. A position with a best
//! pot of probability q is worth q f(n − 1, m) + (1 − q) (1 − f(m, n)), or a safety if that is more.
//!
//! Where points are counted the race is the lead: a player at the table who leads by d, and can expect h more from this
//! turn, wins with probability 1 / (1 + exp(−(d + h) / s)), where s grows with the root of the points still to be made.

use crate::game::players::chance::Eye;
use crate::game::players::sight::Sight;
use crate::game::rules::eight_ball::Phase;
use crate::game::rules::{Game, GameState, On, snooker};
use crate::physics::scene::Scene;

/// Balls to go beyond which more make no difference.
const FAR: usize = 24;

/// How much of the difference between having and not having the turn a safety is worth.
const SAFETY: f64 = 0.25;

/// The same where nothing that is on can be seen.
const SNOOKERED: f64 = -0.1;

/// How much rarer a carom off three cushions is than a pot.
const CAROM: f64 = 0.35;

/// Balls to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToGo {
    /// Each player has balls of their own.
    Own {
        /// Of the player at the table.
        mine: usize,
        /// Of the other.
        theirs: usize,
    },
    /// Both play at the same balls.
    Shared(usize),
    /// Points are counted.
    Points {
        /// Of the player at the table over the other.
        lead: f64,
        /// What one good shot brings.
        shot: f64,
        /// What a turn at the table can be expected to bring.
        turn: f64,
        /// The lead that makes a winner, s.
        scale: f64,
    },
}

/// Probability of winning by the lead that can be expected.
fn by_lead(lead: f64, scale: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-lead / scale))
}

/// The race of two players who pot this well.
#[derive(Clone, Debug)]
pub struct Race {
    pot_rate: f64,
    own: Vec<f64>,
    shared: Vec<f64>,
}

impl Race {
    /// For players who pot with this probability.
    #[must_use]
    pub fn new(pot_rate: f64) -> Self {
        let (r, s) = (pot_rate, 1.0 - pot_rate);
        let side = FAR + 1;
        let mut own = vec![0.0; side * side];
        let mut shared = vec![1.0; side];
        for n in 1..side {
            shared[n] = (r * shared[n - 1] + s) / (1.0 + s);
        }
        own[..side].fill(1.0);
        for n in 1..side {
            for m in 1..=n {
                let after = |n: usize, m: usize| r * own[(n - 1) * side + m];
                let (a, b) = (after(n, m), after(m, n));
                let solved = |a: f64, b: f64| (a + s - s * b - s * s) / (1.0 - s * s).max(1e-9);
                let (f, g) = (solved(a, b), solved(b, a));
                own[n * side + m] = f;
                own[m * side + n] = g;
            }
        }
        Self {
            pot_rate,
            own,
            shared,
        }
    }

    fn own(&self, n: usize, m: usize) -> f64 {
        if m == 0 && n > 0 {
            return 0.0;
        }
        self.own[n.min(FAR) * (FAR + 1) + m.min(FAR)]
    }

    /// Probability of winning for the player at the table, after a pot, and after the turn has passed.
    #[must_use]
    pub fn after(&self, to_go: ToGo) -> (f64, f64) {
        match to_go {
            ToGo::Own { mine, theirs } => (
                self.own(mine.saturating_sub(1), theirs),
                1.0 - self.own(theirs, mine),
            ),
            ToGo::Shared(n) => {
                let n = n.min(FAR);
                (self.shared[n.saturating_sub(1)], 1.0 - self.shared[n])
            }
            ToGo::Points {
                lead,
                shot,
                turn,
                scale,
            } => (
                by_lead(lead + shot + turn, scale),
                by_lead(lead - turn, scale),
            ),
        }
    }

    /// Probability of winning with a best pot of this probability; `sees` says whether anything on can be hit directly.
    #[must_use]
    pub fn at_table(&self, to_go: ToGo, chance: f64, sees: bool) -> f64 {
        let (pot, passed) = self.after(to_go);
        let turn = match to_go {
            ToGo::Own { mine, theirs } => self.own(mine, theirs),
            ToGo::Shared(n) => self.shared[n.min(FAR)],
            ToGo::Points {
                lead, turn, scale, ..
            } => by_lead(lead + turn, scale),
        };
        let safety = if sees { SAFETY } else { SNOOKERED };
        let shoot = chance * pot + (1.0 - chance) * passed;
        shoot.max(passed + safety * (turn - passed))
    }
}

/// What is still to go for the player at the table and the other.
#[must_use]
pub fn to_go(race: &Race, state: &GameState, scene: &Scene, on: &On) -> ToGo {
    match &state.game {
        Game::EightBall(rules) => {
            if !matches!(rules.phase, Phase::Closed { .. }) {
                return ToGo::Own { mine: 8, theirs: 8 };
            }
            let eight = scene.ball_named("8");
            let left = |pot: &[usize]| match pot {
                [ball] if Some(*ball) == eight => 1,
                balls => balls.len() + 1,
            };
            let mut other = state.clone();
            other.standing.turn = state.standing.next_player();
            ToGo::Own {
                mine: left(&on.pot),
                theirs: left(&other.targets(scene).pot),
            }
        }
        Game::NineBall(_) | Game::TenBall(_) => ToGo::Shared(on.pot.len().max(1)),
        Game::StraightPool(rules) => {
            points(race.pot_rate, state, 1.0, 2.0, missing(state, rules.to))
        }
        Game::Snooker(_) => {
            let left: i32 = (0..scene.balls.len())
                .filter(|&ball| scene.balls[ball].state.motion.in_play())
                .map(|ball| snooker::value(scene, ball))
                .map(|value| if value == 1 { 8 } else { value })
                .sum();
            points(race.pot_rate, state, 3.5, 2.0, left)
        }
        Game::ThreeCushion(rules) => points(
            CAROM * race.pot_rate,
            state,
            1.0,
            0.8,
            missing(state, rules.to),
        ),
        Game::FreePractice(_) => points(race.pot_rate, state, 1.0, 2.0, on.pot.len() as i32),
    }
}

/// Points that the leader has to make.
fn missing(state: &GameState, to: i32) -> i32 {
    to - state.standing.scores.iter().copied().max().unwrap_or(0)
}

/// The race of players who score with this probability, where a good shot brings so much and `left` points are still to be
/// had; `unit` is how much a game swings.
fn points(rate: f64, state: &GameState, shot: f64, unit: f64, left: i32) -> ToGo {
    let standing = &state.standing;
    let score = |player: usize| standing.scores.get(player).copied().unwrap_or(0);
    let left = f64::from(left.max(1));
    ToGo::Points {
        lead: f64::from(score(standing.turn) - score(standing.next_player())),
        shot,
        turn: (shot * rate / (1.0 - rate).max(0.05)).min(0.5 * left),
        scale: 1.0 + unit * left.sqrt(),
    }
}

/// The probability that this player wins from here, seen with this eye.
#[must_use]
pub fn worth(race: &Race, eye: &Eye, state: &GameState, scene: &Scene, player: usize) -> f64 {
    if let Some(over) = state.standing.over {
        return match over.winner {
            Some(winner) => f64::from(u8::from(winner == player)),
            None => 0.5,
        };
    }
    let on = state.targets(scene);
    let value = if on.choices.is_empty() {
        at_table(race, eye, state, scene, &on)
    } else {
        chosen(race, eye, state, scene)
    };
    if state.standing.turn == player {
        value
    } else {
        1.0 - value
    }
}

fn at_table(race: &Race, eye: &Eye, state: &GameState, scene: &Scene, on: &On) -> f64 {
    let to_go = to_go(race, state, scene, on);
    if on.is_break {
        return race.at_table(to_go, 0.5, true);
    }
    if let Some(area) = &on.in_hand {
        let best = eye.best_in_hand(scene, on, area);
        // Which way the next one lies can be chosen too.
        return race.at_table(to_go, best + 0.5 * best * (1.0 - best), true);
    }
    let sight = Sight::of(scene);
    let Some(cue) = sight.ball(on.cue).copied() else {
        return race.at_table(to_go, 0.0, true);
    };
    let sees = on.first.iter().any(|&ball| {
        sight
            .ball(ball)
            .is_some_and(|seen| sight.is_free(cue.at, seen.at, 0.5 * cue.radius, [cue.ball, ball]))
    });
    race.at_table(to_go, eye.best(&sight, on, &cue), sees)
}

/// What the best of the choices on offer is worth to the player who chooses.
fn chosen(race: &Race, eye: &Eye, state: &GameState, scene: &Scene) -> f64 {
    let chooser = state.standing.turn;
    let outcomes = state.standing.choices.iter().filter_map(|choice| {
        let verdict = state.choose(scene, *choice)?;
        let table = verdict.table_chosen(scene, scene);
        let next = &verdict.next;
        // A choice never leads to another one that matters.
        let on = next.targets(&table);
        let value = match next.standing.over {
            Some(over) => f64::from(u8::from(over.winner == Some(next.standing.turn))),
            None => at_table(race, eye, next, &table, &on),
        };
        Some(if next.standing.turn == chooser {
            value
        } else {
            1.0 - value
        })
    });
    outcomes.fold(0.0, f64::max)
}
