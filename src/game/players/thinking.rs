//! A thought: from a table and the state of the game to a plan, in steps.
//!
//! Ideas come from geometry. Each is rehearsed on the solver that plays the real shots, and the rules themselves judge the
//! rehearsals, so that a law or a game that is new needs nothing here. The best are rehearsed again with the errors of the
//! player's own hand, and the best of those with the next shot planned too.
//!
//! A step is some dozens of rehearsals: a window runs them in a task, shows the [`Progress`] and may stop at any time with
//! the best plan so far. The budget counts rehearsals, not time, so the plan is the same on every machine.

use std::collections::VecDeque;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::game::placing;
use crate::game::players::chance::Eye;
use crate::game::players::idea::{Idea, Kind};
use crate::game::players::ideas::View;
use crate::game::players::level::Level;
use crate::game::players::noise::Deviation;
use crate::game::players::opening;
use crate::game::players::plan::{Plan, Progress};
use crate::game::players::rehearsal::Rehearsal;
use crate::game::players::sight::{Sight, plan};
use crate::game::players::worth::{Race, to_go};
use crate::game::rules::{GameState, On};
use crate::physics::exact::SolveError;
use crate::physics::scene::Scene;

/// Share of the budget after which no more ideas are screened.
const SCREENED: f64 = 0.55;

/// Share of the budget after which no more is rehearsed with errors.
const SAMPLED: f64 = 0.85;

/// A pot that looks this likely makes a safety not worth thinking about.
const SURE: f64 = 0.9;

/// A pot that looks less likely than this makes a push out worth thinking about.
const PUSH_OUT: f64 = 0.6;

/// What is done next.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    Screen,
    /// Rehearse this finalist with errors.
    Sample(usize),
    /// Plan the shot after this finalist.
    Ahead(usize),
    Done,
}

/// A thought in progress.
#[derive(Clone, Debug)]
pub struct Thinking {
    pub(super) level: Level,
    pub(super) state: GameState,
    pub(super) on: On,
    pub(super) player: usize,
    pub(super) eye: Eye,
    pub(super) race: Race,
    pub(super) rehearsal: Rehearsal,
    /// The table as it lies; what is rehearsed may lie otherwise.
    pub(super) lies: Scene,
    pub(super) deviations: Vec<Deviation>,
    /// Worth of the table when the shot has failed: without a foul, and with one.
    pub(super) failed: (f64, f64),
    pub(super) plans: Vec<Plan>,
    ideas: VecDeque<Idea>,
    planned: usize,
    stage: Stage,
    fallen_back: bool,
    /// Share of the time that is used up, where time counts.
    hurry: f64,
}

impl Thinking {
    /// Begins to think for the player at the table. The seed decides what errors are rehearsed.
    ///
    /// # Errors
    /// [`SolveError`] if the scene cannot be played by the exact solver.
    pub fn new(
        state: &GameState,
        scene: &Scene,
        level: &Level,
        seed: u64,
    ) -> Result<Self, SolveError> {
        let on = state.targets(scene);
        let race = Race::new(level.skills.pot_rate);
        let passed = race.after(to_go(&race, state, scene, &on)).1;
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let count = level.skills.samples.max(level.skills.ahead).max(4);
        let mut thinking = Self {
            level: *level,
            player: state.standing.turn,
            eye: Eye::new(scene, on.cue, level.noise),
            race,
            rehearsal: Rehearsal::new(scene, level.skills.budget)?,
            lies: scene.clone(),
            deviations: (0..count).map(|_| Deviation::draw(&mut rng)).collect(),
            failed: (passed, 0.8 * passed),
            plans: Vec::new(),
            ideas: VecDeque::new(),
            planned: 0,
            stage: Stage::Screen,
            fallen_back: false,
            hurry: 0.0,
            state: state.clone(),
            on,
        };
        thinking.have_ideas();
        thinking.planned = thinking.ideas.len();
        Ok(thinking)
    }

    /// Thinks to the end.
    #[must_use]
    pub fn finish(mut self) -> (Plan, u32) {
        while self.step() {}
        (self.plan(), self.rehearsal.trials)
    }

    /// The best plan so far, and before there is any a plain stroke at the nearest ball: what a player does who is not
    /// given the time to think.
    #[must_use]
    pub fn plan(&self) -> Plan {
        self.best().unwrap_or_else(|| {
            let spot = self.spots().first().copied().flatten();
            let placed = &self.lies.balls[self.on.cue];
            let at = spot.unwrap_or_else(|| plan(placed.state.position));
            opening::plain(&self.lies, &self.on, at, spot)
        })
    }

    /// Tells that this share of the time is used up, for whoever has not got all the time in the world: every stage then
    /// ends at the latest when its share of the time is over, as it does when its share of the budget is. The plan depends
    /// on the machine from then on.
    pub fn press(&mut self, share: f64) {
        self.hurry = share;
    }

    /// Goes one step further. False when there is nothing more to think about.
    pub fn step(&mut self) -> bool {
        match self.stage {
            Stage::Screen => match self.ideas.pop_front() {
                Some(idea)
                    if self.has_budget(SCREENED) || (self.plans.is_empty() && self.hurry < 1.0) =>
                {
                    self.screen(&idea);
                }
                _ => self.end_screening(),
            },
            Stage::Sample(index) => {
                self.sample(index);
                let last = index + 1 >= self.plans.len() || !self.has_budget(SAMPLED);
                self.stage = if last {
                    self.end_sampling(index)
                } else {
                    Stage::Sample(index + 1)
                };
            }
            Stage::Ahead(index) => {
                self.look_ahead(index);
                let last = index + 1 >= self.plans.len() || !self.has_budget(1.0);
                if last {
                    self.plans.truncate(index + 1);
                    self.sort();
                    self.stage = Stage::Done;
                } else {
                    self.stage = Stage::Ahead(index + 1);
                }
            }
            Stage::Done => {}
        }
        self.stage != Stage::Done
    }

    /// The best plan so far.
    #[must_use]
    pub fn best(&self) -> Option<Plan> {
        self.plans
            .iter()
            .copied()
            .reduce(|best, plan| if plan.value > best.value { plan } else { best })
    }

    /// How far the thought has come.
    #[must_use]
    pub fn progress(&self) -> Progress {
        let part = |done: usize, all: usize| done as f64 / all.max(1) as f64;
        let share = match self.stage {
            Stage::Screen => SCREENED * (1.0 - part(self.ideas.len(), self.planned)),
            Stage::Sample(i) => SCREENED + (SAMPLED - SCREENED) * part(i, self.plans.len()),
            Stage::Ahead(i) => SAMPLED + (1.0 - SAMPLED) * part(i, self.plans.len()),
            Stage::Done => 1.0,
        };
        Progress {
            share,
            trials: self.rehearsal.trials,
            best: self.best(),
        }
    }

    /// Whether less than this share of the budget is used up.
    pub(super) fn has_budget(&self, share: f64) -> bool {
        let rehearsed = f64::from(self.rehearsal.trials);
        rehearsed < share * f64::from(self.level.skills.budget) && self.hurry < share
    }

    fn sort(&mut self) {
        self.plans.sort_by(|a, b| b.value.total_cmp(&a.value));
    }

    fn end_screening(&mut self) {
        if self.plans.is_empty() && !self.fallen_back {
            self.fallen_back = true;
            self.ideas = self.fall_back().into();
            self.planned = self.ideas.len();
            return;
        }
        self.sort();
        self.ideas.clear();
        self.plans.truncate(self.level.skills.finalists.max(1));
        let samples = self.level.skills.samples > 0 && self.plans.len() > 1;
        self.stage = if samples {
            Stage::Sample(0)
        } else {
            Stage::Done
        };
    }

    fn end_sampling(&mut self, last: usize) -> Stage {
        self.plans.truncate(last + 1);
        self.sort();
        let ahead =
            self.level.skills.ahead > 0 && self.plans.first().is_some_and(|best| best.value < 1.0);
        if !ahead || self.on.is_break {
            return Stage::Done;
        }
        self.plans.truncate(3);
        Stage::Ahead(0)
    }

    /// Ideas for the table as it lies, or for every place of the cue ball in hand that is considered.
    fn have_ideas(&mut self) {
        let sight = self.sight();
        if self.on.is_break && opening::is_open(&self.state.game) {
            self.ideas = opening::ideas(&self.lies, &self.on, &self.level.skills).into();
            return;
        }
        let spots = self.spots();
        let mut ideas = Vec::new();
        let each = (self.level.skills.pots / spots.len().max(1)).max(2);
        for spot in &spots {
            let Some(view) = self.view(&sight, *spot) else {
                continue;
            };
            let mut pots = view.pots();
            if spot.is_some() {
                pots.truncate(each);
            }
            ideas.extend(pots);
        }
        let best = ideas
            .iter()
            .map(|idea: &Idea| idea.chance)
            .fold(0.0, f64::max);
        if let Some(view) = self
            .view(&sight, spots.first().copied().flatten())
            .filter(|_| best < SURE)
        {
            let skills = &self.level.skills;
            if self.on.pockets.is_empty() {
                ideas.extend(view.caroms());
            }
            if self.on.may_push_out && skills.position && best < PUSH_OUT {
                ideas.extend(opening::push_outs());
            }
            ideas.extend(view.combinations());
            ideas.extend(view.banks());
            let hits = view.hits(skills.safeties.max(1), skills.safeties > 0);
            if hits.is_empty() && skills.raises {
                ideas.extend(view.raised());
            }
            ideas.extend(hits);
            if best < 0.3 {
                ideas.extend(view.kicks(if skills.kick_cushions > 1 { 8 } else { 4 }));
            }
        }
        let first = |idea: &Idea| matches!(idea.kind, Kind::Pot);
        ideas.sort_by(|a, b| {
            (first(b), b.chance.max(0.0))
                .partial_cmp(&(first(a), a.chance.max(0.0)))
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        self.ideas = ideas.into();
    }

    /// The table as it lies, without a cue ball that is in hand.
    fn sight(&self) -> Sight {
        let mut sight = Sight::of(&self.lies);
        if self.on.in_hand.is_some() {
            sight.balls.retain(|seen| seen.ball != self.on.cue);
        }
        sight
    }

    fn view<'a>(&'a self, sight: &'a Sight, spot: Option<glam::DVec2>) -> Option<View<'a>> {
        let placed = self.lies.balls.get(self.on.cue)?;
        let at = spot.unwrap_or_else(|| plan(placed.state.position));
        Some(View {
            sight,
            eye: &self.eye,
            on: &self.on,
            cue: crate::game::players::sight::Seen {
                ball: self.on.cue,
                at,
                radius: placed.ball.radius,
            },
            spot,
            skills: &self.level.skills,
        })
    }

    /// Places for the cue ball: one if it lies, several that lie apart if it is in hand.
    fn spots(&self) -> Vec<Option<glam::DVec2>> {
        let Some(area) = &self.on.in_hand else {
            return vec![None];
        };
        let most = self.level.skills.spots.max(1);
        let mut spots: Vec<Option<glam::DVec2>> = Vec::new();
        for (_, at) in self.eye.spots(&self.lies, &self.on, area, self.on.cue) {
            if spots.len() == most {
                break;
            }
            let apart = spots
                .iter()
                .flatten()
                .all(|other| other.distance(at) > 0.12);
            if apart && placing::is_free(&self.lies, self.on.cue, at) {
                spots.push(Some(at));
            }
        }
        if spots.is_empty() {
            spots.extend(
                opening::places(&self.lies, &self.on, 3)
                    .into_iter()
                    .map(Some),
            );
        }
        spots
    }

    /// Where nothing has come to mind: all around.
    fn fall_back(&self) -> Vec<Idea> {
        let sight = self.sight();
        let spot = self.spots().first().copied().flatten();
        let mut ideas = self
            .view(&sight, spot)
            .map_or_else(Vec::new, |view| view.kicks(12));
        ideas.extend(opening::all_around(spot, &self.on));
        ideas
    }
}
