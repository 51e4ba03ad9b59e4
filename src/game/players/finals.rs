//! The finals: the best plans rehearsed with the errors of the own hand, and with the shot after them.

use crate::game::players::aiming;
use crate::game::players::idea::{Kind, Line};
use crate::game::players::ideas::View;
use crate::game::players::screen::rehearse;
use crate::game::players::sight::Sight;
use crate::game::players::thinking::Thinking;
use crate::game::players::worth::{to_go, worth};
use crate::game::rules::GameState;
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;

/// Pots that are tried on a table ahead, their speeds in m/s and heights in R.
const AHEAD_POTS: usize = 2;
const AHEAD_SPEEDS: [f64; 2] = [1.0, 1.9];
const AHEAD_HEIGHTS: [f64; 3] = [0.0, 0.3, -0.3];

impl Thinking {
    /// Rehearses a finalist with the errors of the own hand: its value is the mean.
    pub(super) fn sample(&mut self, index: usize) {
        let samples = self.level.skills.samples;
        let (value, chance) = self.mean(index, samples, false);
        let plan = &mut self.plans[index];
        plan.value = value;
        plan.chance = chance;
    }

    /// The same, with the shot after it planned too.
    pub(super) fn look_ahead(&mut self, index: usize) {
        let (value, _) = self.mean(index, self.level.skills.ahead, true);
        self.plans[index].value = value;
    }

    fn mean(&mut self, index: usize, samples: usize, ahead: bool) -> (f64, f64) {
        let plan = self.plans[index];
        let radius = self.lies.balls[self.on.cue].ball.radius;
        let hand = self.level.hand();
        let (mut value, mut worked, mut count) = (0.0, 0, 0);
        for i in 0..samples {
            self.lay(plan.spot);
            let off = hand.apply(&self.deviations[i], &plan.shot, radius);
            let Some(outcome) = self.rehearse(&plan.call, &off, ahead) else {
                continue;
            };
            count += 1;
            let safe = matches!(
                plan.kind,
                Kind::Safety | Kind::Kick | Kind::Jump | Kind::Masse | Kind::PushOut
            );
            worked += i32::from(if safe { outcome.clean } else { outcome.good });
            value += match &outcome.next {
                Some((state, scene)) if outcome.good => {
                    self.best_next(state, scene).max(outcome.value)
                }
                _ => outcome.value,
            };
        }
        if count == 0 {
            return (0.0, 0.0);
        }
        let count = f64::from(count);
        (value / count, f64::from(worked) / count)
    }

    /// The worth of a table on which the turn goes on, with the next pot rehearsed.
    fn best_next(&mut self, state: &GameState, scene: &Scene) -> f64 {
        let on = state.targets(scene);
        let sight = Sight::of(scene);
        let Some(cue) = sight.ball(on.cue).copied().filter(|_| on.in_hand.is_none()) else {
            return 0.0;
        };
        let view = View {
            sight: &sight,
            eye: &self.eye,
            on: &on,
            cue,
            spot: None,
            skills: &self.level.skills,
        };
        let pots = view.pots();
        let passed = self.race.after(to_go(&self.race, state, scene, &on)).1;
        self.rehearsal.lay(scene);
        let mut best = 0.0_f64;
        for idea in pots.iter().take(AHEAD_POTS) {
            let Line::Send(lane) = idea.line else {
                continue;
            };
            let ghost = aiming::ghost_heading(scene, on.cue, &lane);
            for height in AHEAD_HEIGHTS {
                for speed in AHEAD_SPEEDS {
                    let mut shot = aiming::raised(
                        scene,
                        on.cue,
                        &Shot {
                            heading: ghost,
                            elevation: 0.0,
                            side: 0.0,
                            height,
                            speed,
                        },
                    );
                    let Some(heading) = aiming::heading(&mut self.rehearsal, on.cue, &lane, &shot)
                    else {
                        continue;
                    };
                    shot.heading = heading;
                    let played = rehearse(
                        self.player,
                        &mut self.rehearsal,
                        state,
                        on.cue,
                        &idea.call,
                        &shot,
                    );
                    let Some((verdict, table)) = played else {
                        continue;
                    };
                    let then = worth(&self.race, &self.eye, &verdict.next, &table, self.player);
                    best = best.max(idea.chance * then + (1.0 - idea.chance) * passed);
                }
            }
        }
        best
    }
}
