//! Screening: every idea is rehearsed in its variants.

use crate::game::players::aiming;
use crate::game::players::chance::Lane;
use crate::game::players::idea::{Idea, Kind, Line};
use crate::game::players::plan::Plan;
use crate::game::players::rehearsal::Rehearsal;
use crate::game::players::thinking::Thinking;
use crate::game::players::worth::worth;
use crate::game::rules::{Call, GameState, Verdict};
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;

/// Speeds of the cue in m/s of shots that are to go in after a search.
const SEARCH_SPEEDS: [f64; 3] = [2.2, 1.4, 3.4];

/// Directions tried in a search.
const SEARCHED: u32 = 25;

/// Speeds of the cue in m/s of safeties.
const SAFE_SPEEDS: [f64; 5] = [0.7, 1.2, 0.45, 2.0, 3.2];

/// Contacts of safeties, height in R.
const SAFE_HEIGHTS: [f64; 3] = [0.0, -0.3, 0.3];

/// Speeds of the cue in m/s of push outs.
const PUSH_SPEEDS: [f64; 2] = [0.6, 1.3];

/// Speeds of the cue in m/s of breaks.
const BREAK_SPEEDS: [f64; 2] = [7.5, 9.0];

/// Contacts of breaks, height in R.
const BREAK_HEIGHTS: [f64; 2] = [0.0, -0.15];

/// Speeds of the cue in m/s of caroms.
const CAROM_SPEEDS: [f64; 4] = [2.6, 3.6, 1.9, 4.8];

/// Contacts of caroms, side and height in R.
const CAROM_TIPS: [(f64, f64); 7] = [
    (0.0, 0.2),
    (0.35, 0.15),
    (-0.35, 0.15),
    (0.0, -0.25),
    (0.3, -0.2),
    (-0.3, -0.2),
    (0.0, 0.0),
];

/// Speed of a plain stroke in m/s.
const PLAIN: f64 = 1.8;

/// A plain stroke along this angle in plan, rad, with a level cue.
pub(super) fn level(angle: f64) -> Shot {
    Shot {
        heading: -angle,
        elevation: 0.0,
        side: 0.0,
        height: 0.0,
        speed: PLAIN,
    }
}

/// What a rehearsal led to.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    /// Against no rule.
    pub(super) clean: bool,
    /// The turn is kept, or the rack is won.
    pub(super) good: bool,
    /// Probability of winning afterwards.
    pub(super) value: f64,
    /// The game and the table afterwards; absent if it is over or nobody wants to know.
    pub(super) next: Option<(GameState, Scene)>,
}

impl Thinking {
    /// Plays a shot on the table in the mind and has the rules judge it.
    pub(super) fn rehearse(&mut self, call: &Call, shot: &Shot, keep: bool) -> Option<Outcome> {
        let state = &self.state;
        rehearse(
            self.player,
            &mut self.rehearsal,
            state,
            self.on.cue,
            call,
            shot,
        )
        .map(|(verdict, table)| {
            let next = &verdict.next;
            let value = worth(&self.race, &self.eye, next, &table, self.player);
            let over = next.standing.over;
            let mine = match over {
                Some(over) => over.winner == Some(self.player),
                None => next.standing.turn == self.player && next.standing.choices.is_empty(),
            };
            let clean = !verdict.is_foul();
            Outcome {
                clean,
                good: clean && mine,
                value,
                next: (keep && over.is_none()).then_some((verdict.next, table)),
            }
        })
    }

    /// Lays the table for an idea or a plan.
    pub(super) fn lay(&mut self, spot: Option<glam::DVec2>) {
        self.rehearsal.lay(&self.lies);
        if let Some(spot) = spot {
            self.rehearsal.put(self.on.cue, spot);
        }
    }

    /// Rehearses an idea in its variants and notes the plans that come of it.
    pub(super) fn screen(&mut self, idea: &Idea) {
        self.lay(idea.spot);
        match (idea.kind, idea.line) {
            (Kind::Pot, Line::Send(lane)) => self.screen_pot(idea, &lane),
            (Kind::Break, Line::Along(angle)) => self.screen_break(idea, angle),
            (Kind::PushOut, Line::Along(angle)) => self.screen_push_out(idea, angle),
            (Kind::Carom, Line::Along(angle)) => self.screen_carom(idea, angle),
            (Kind::Jump, Line::Along(angle)) => self.screen_jump(idea, angle, None),
            (Kind::Jump, Line::Send(lane)) => {
                let heading = aiming::ghost_heading(self.rehearsal.scene(), self.on.cue, &lane);
                self.screen_jump(idea, -heading, Some(&lane));
            }
            (_, Line::Past { angle, side }) => self.screen_masse(idea, angle, side),
            (_, Line::Search { angle, spread }) => self.search(idea, angle, spread),
            (_, Line::Along(angle)) => self.screen_safety(idea, angle),
            (_, Line::Send(_)) => {}
        }
    }

    pub(super) fn note(&mut self, idea: &Idea, shot: Shot, value: f64, chance: f64) {
        self.plans.push(Plan {
            kind: idea.kind,
            spot: idea.spot,
            call: idea.call,
            shot,
            value,
            chance,
        });
    }

    pub(super) fn raised(&self, shot: &Shot) -> Shot {
        aiming::raised(self.rehearsal.scene(), self.on.cue, shot)
    }

    fn screen_pot(&mut self, idea: &Idea, lane: &Lane) {
        let skills = self.level.skills;
        let cue = self.on.cue;
        let ghost = aiming::ghost_heading(self.rehearsal.scene(), cue, lane);
        for &(side, height) in skills.tips {
            let raised = self.raised(&Shot {
                heading: ghost,
                elevation: 0.0,
                side,
                height,
                speed: 1.0,
            });
            for &speed in skills.speeds {
                let mut shot = Shot { speed, ..raised };
                if skills.feels_throw {
                    let Some(heading) = aiming::heading(&mut self.rehearsal, cue, lane, &shot)
                    else {
                        continue;
                    };
                    shot.heading = heading;
                }
                let Some(outcome) = self.rehearse(&idea.call, &shot, false) else {
                    continue;
                };
                let value = if !skills.position {
                    idea.chance
                } else if outcome.good {
                    idea.chance * outcome.value + (1.0 - idea.chance) * self.failed.0
                } else {
                    continue;
                };
                self.note(idea, shot, value, idea.chance);
            }
        }
    }

    fn screen_safety(&mut self, idea: &Idea, angle: f64) {
        let thinks = self.level.skills.safeties > 0;
        let raised = self.raised(&level(angle));
        if !thinks {
            if let Some(outcome) = self
                .rehearse(&idea.call, &raised, false)
                .filter(|outcome| outcome.clean)
            {
                let value = if self.level.skills.position {
                    outcome.value
                } else {
                    0.05
                };
                self.note(idea, raised, 0.9 * value, 0.5);
            }
            return;
        }
        let variants = 1 + self.level.skills.safeties.min(2);
        for speed in SAFE_SPEEDS.into_iter().take(2 + variants) {
            for height in SAFE_HEIGHTS.into_iter().take(variants) {
                let shot = Shot {
                    height,
                    speed,
                    ..raised
                };
                let Some(outcome) = self.rehearse(&idea.call, &shot, false) else {
                    continue;
                };
                if outcome.clean {
                    // How sure it is shows when it is rehearsed with errors.
                    self.note(idea, shot, 0.9 * outcome.value + 0.1 * self.failed.1, 0.9);
                }
            }
        }
    }

    /// What a push out is worth is what it leaves to the one who may choose.
    fn screen_push_out(&mut self, idea: &Idea, angle: f64) {
        let raised = self.raised(&level(angle));
        for speed in PUSH_SPEEDS {
            let shot = Shot { speed, ..raised };
            let outcome = self.rehearse(&idea.call, &shot, false);
            if let Some(outcome) = outcome.filter(|outcome| outcome.clean) {
                self.note(idea, shot, outcome.value, 0.9);
            }
        }
    }

    fn screen_break(&mut self, idea: &Idea, angle: f64) {
        let samples = self.level.skills.samples.min(4);
        let (speeds, heights) = if samples > 0 { (2, 2) } else { (1, 1) };
        let radius = self.lies.balls[self.on.cue].ball.radius;
        for speed in BREAK_SPEEDS.into_iter().take(speeds) {
            for height in BREAK_HEIGHTS.into_iter().take(heights) {
                let shot = self.raised(&Shot {
                    heading: -angle,
                    elevation: 0.0,
                    side: 0.0,
                    height,
                    speed,
                });
                if samples == 0 {
                    self.note(idea, shot, 0.5, 0.5);
                    continue;
                }
                let hand = self.level.hand();
                let mut values = (0.0, 0);
                for i in 0..samples {
                    let off = hand.apply(&self.deviations[i], &shot, radius);
                    if let Some(outcome) = self.rehearse(&idea.call, &off, false) {
                        values = (values.0 + outcome.value, values.1 + 1);
                    }
                }
                if values.1 > 0 {
                    self.note(idea, shot, values.0 / f64::from(values.1), 0.5);
                }
            }
        }
    }

    /// Tries speeds and english; where the shot scores, looks for the middle of the range in which it does.
    fn screen_carom(&mut self, idea: &Idea, angle: f64) {
        for &(side, height) in CAROM_TIPS.iter().take(2 * self.level.skills.tips.len()) {
            let raised = self.raised(&Shot {
                heading: -angle,
                elevation: 0.0,
                side,
                height,
                speed: PLAIN,
            });
            for speed in CAROM_SPEEDS {
                let shot = Shot { speed, ..raised };
                let Some(outcome) = self.rehearse(&idea.call, &shot, false) else {
                    return;
                };
                if outcome.good {
                    self.center(idea, &shot, outcome.value);
                } else if outcome.clean && idea.chance > 0.0 && speed == CAROM_SPEEDS[0] {
                    self.note(idea, shot, 0.9 * outcome.value, 0.0);
                }
            }
        }
    }

    /// Moves a shot that works to the middle of the range of headings in which it does, and notes it.
    fn center(&mut self, idea: &Idea, shot: &Shot, value: f64) {
        let step = 0.5 * self.eye.direction;
        let mut reach = [0.0; 2];
        for (reach, sign) in reach.iter_mut().zip([1.0, -1.0]) {
            for i in 1..=3 {
                let off = Shot {
                    heading: shot.heading + sign * step * f64::from(i),
                    ..*shot
                };
                if !self
                    .rehearse(&idea.call, &off, false)
                    .is_some_and(|outcome| outcome.good)
                {
                    break;
                }
                *reach = step * f64::from(i);
            }
        }
        let half = 0.5 * (reach[0] + reach[1] + step);
        let chance = libm::erf(half / (self.eye.direction.max(1e-9) * std::f64::consts::SQRT_2));
        let middle = Shot {
            heading: shot.heading + 0.5 * (reach[0] - reach[1]),
            ..*shot
        };
        self.note(
            idea,
            middle,
            chance * value + (1.0 - chance) * self.failed.0,
            chance,
        );
    }

    /// Tries directions around the idea and takes the middle of the widest range in which it works.
    fn search(&mut self, idea: &Idea, angle: f64, spread: f64) {
        let raised = self.raised(&Shot {
            speed: 1.0,
            ..level(angle)
        });
        let kick = matches!(idea.kind, Kind::Kick);
        let speeds = if self.level.skills.samples > 0 { 3 } else { 1 };
        let step = 2.0 * spread / f64::from(SEARCHED - 1);
        for speed in SEARCH_SPEEDS.into_iter().take(speeds) {
            let at = |i: u32| Shot {
                heading: raised.heading - spread + step * f64::from(i),
                speed,
                ..raised
            };
            let (mut widest, mut run): ((u32, f64, u32), (u32, f64)) = ((0, 0.0, 0), (0, 0.0));
            for i in 0..SEARCHED {
                let outcome = self.rehearse(&idea.call, &at(i), false);
                let works =
                    outcome.filter(|outcome| if kick { outcome.clean } else { outcome.good });
                run = works.map_or((0, 0.0), |outcome| (run.0 + 1, run.1 + outcome.value));
                if run.0 > widest.0 {
                    widest = (run.0, run.1, i);
                }
            }
            let (length, sum, last) = widest;
            if length == 0 {
                continue;
            }
            let half = 0.5 * step * f64::from(length);
            let chance =
                libm::erf(half / (self.eye.direction.max(1e-9) * std::f64::consts::SQRT_2));
            let middle =
                raised.heading - spread + step * (f64::from(last) - 0.5 * f64::from(length - 1));
            let failed = if kick { self.failed.1 } else { self.failed.0 };
            let value = chance * sum / f64::from(length) + (1.0 - chance) * failed;
            let value = if self.level.skills.position {
                value
            } else {
                0.5 * chance
            };
            let shot = Shot {
                heading: middle,
                speed,
                ..raised
            };
            self.note(idea, shot, value, chance);
        }
    }
}

/// Plays a shot on a table in the mind; gives the verdict and the table afterwards.
pub(super) fn rehearse(
    player: usize,
    rehearsal: &mut Rehearsal,
    state: &GameState,
    cue: usize,
    call: &Call,
    shot: &Shot,
) -> Option<(Verdict, Scene)> {
    debug_assert_eq!(state.standing.turn, player);
    let (before, record) = rehearsal.play(cue, shot)?;
    let verdict = state.judge(before, record, call);
    let table = verdict.table_after(before, record);
    Some((verdict, table))
}
