//! A whole rack, computer against computer, without a window: what a tournament is made of.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::Serialize;
use thiserror::Error;

use crate::game::players::aiming;
use crate::game::players::choosing::choose;
use crate::game::players::level::Level;
use crate::game::players::noise::Deviation;
use crate::game::players::thinking::Thinking;
use crate::game::rules::{Game, GameState};
use crate::physics::cue::Shot;
use crate::physics::exact::{Limits, SolveError, solve};
use crate::physics::scene::{PlannedShot, Scene};

/// Strokes after which a rack that does not end is given up.
pub const MOST_SHOTS: u32 = 1000;

/// Choices in a row after which a rack that does not go on is given up.
const MOST_CHOICES: u32 = 20;

/// Why a rack could not be played to its end.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ContestError {
    /// The solver gave up.
    #[error("stroke {shot}: {source}")]
    Solver {
        /// Which stroke of the rack.
        shot: u32,
        /// What it says.
        source: SolveError,
    },
    /// It does not end.
    #[error("no end after {shots} strokes")]
    Endless {
        /// Strokes played.
        shots: u32,
    },
}

/// What one player did in a rack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// Strokes.
    pub shots: u32,
    /// Balls potted as the rules ask.
    pub pots: u32,
    /// Points made at the table, in games that count them.
    pub points: u32,
    /// Strokes against a rule.
    pub fouls: u32,
    /// Shots rehearsed.
    pub trials: u64,
    /// Most shots rehearsed for one stroke.
    pub most_trials: u32,
}

impl Tally {
    /// Counts those of another rack too.
    pub(super) fn add(&mut self, other: &Self) {
        self.shots += other.shots;
        self.pots += other.pots;
        self.points += other.points;
        self.fouls += other.fouls;
        self.trials += other.trials;
        self.most_trials = self.most_trials.max(other.most_trials);
    }
}

/// How a rack went.
#[derive(Clone, Debug, PartialEq)]
pub struct Rack {
    /// Who won; nobody if it is drawn.
    pub winner: Option<usize>,
    /// What the players did.
    pub tallies: [Tally; 2],
}

/// Plays a rack between two levels on a table like that of a scene. The seed decides the order of the balls and every
/// error of the hands.
///
/// # Errors
/// [`ContestError`] if the rack does not come to an end.
pub fn play_rack(
    game: &Game,
    levels: [&Level; 2],
    breaker: usize,
    like: &Scene,
    seed: u64,
) -> Result<Rack, ContestError> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut state, mut scene) = GameState::start(game.clone(), 2, breaker, like, rng.random());
    let mut before = scene.clone();
    let mut tallies = [Tally::default(); 2];
    let mut choices = 0;
    while state.standing.over.is_none() {
        let shot = state.standing.shots;
        let player = state.standing.turn;
        if shot >= MOST_SHOTS || choices >= MOST_CHOICES {
            return Err(ContestError::Endless { shots: shot });
        }
        if let Some(choice) = choose(&state, &scene, &before, levels[player])
            && let Some(verdict) = state.choose(&scene, choice)
        {
            scene = verdict.table_chosen(&scene, &before);
            state = verdict.next;
            choices += 1;
            continue;
        }
        choices = 0;
        let failed = |source| ContestError::Solver { shot, source };
        let thinking =
            Thinking::new(&state, &scene, levels[player], rng.random()).map_err(failed)?;
        let (plan, trials) = thinking.finish();
        let cue = state.cue_ball(&scene);
        if let Some(spot) = plan.spot {
            put(&mut scene, cue, spot);
        }
        let stroke = execute(&scene, cue, levels[player], &plan.shot, &mut rng);
        scene.shot = Some(PlannedShot {
            ball: cue,
            shot: stroke,
        });
        let record = solve(&scene, Limits::default()).map_err(failed)?;
        let verdict = state.judge(&scene, &record, &plan.call);
        let tally = &mut tallies[player];
        tally.shots += 1;
        tally.pots += u32::try_from(verdict.made.len()).unwrap_or(u32::MAX);
        let points = verdict.points.get(player).copied().unwrap_or(0);
        tally.points += u32::try_from(points).unwrap_or(0);
        tally.fouls += u32::from(verdict.is_foul());
        tally.trials += u64::from(trials);
        tally.most_trials = tally.most_trials.max(trials);
        let after = verdict.table_after(&scene, &record);
        before = std::mem::replace(&mut scene, after);
        before.shot = None;
        scene.shot = None;
        state = verdict.next;
    }
    Ok(Rack {
        winner: state.standing.over.and_then(|over| over.winner),
        tallies,
    })
}

/// Puts the cue ball down.
pub fn put(scene: &mut Scene, cue: usize, spot: glam::DVec2) {
    let placed = &mut scene.balls[cue];
    placed.state =
        crate::physics::ball::State::at_rest(glam::DVec3::new(spot.x, placed.ball.radius, spot.y));
}

/// The stroke that a level plays when it means this one: with the errors of its hand, and the cue held over what is in its
/// way.
#[must_use]
pub fn execute(
    scene: &Scene,
    cue: usize,
    level: &Level,
    meant: &Shot,
    rng: &mut ChaCha8Rng,
) -> Shot {
    let deviation = Deviation::draw(rng);
    let radius = scene.balls[cue].ball.radius;
    aiming::raised(scene, cue, &level.hand().apply(&deviation, meant, radius))
}
