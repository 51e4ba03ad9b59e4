//! The turn at snooker: points, what is on next, the free ball, the miss, the end of a frame.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::foul::Foul;
use crate::game::rules::ruling::Ruling;
use crate::game::rules::snooker::fouls::{Aim, Wrong};
use crate::game::rules::snooker::{BallOn, Before, MissRule, Snooker, respot, value, valued};
use crate::game::rules::snookered::{is_full_ball_open, is_snookered, is_snookered_by};
use crate::game::rules::standing::Standing;
use crate::game::rules::verdict::{Choice, Note, Reason, TableChange};
use crate::physics::scene::Scene;

impl Snooker {
    pub(super) fn judge_stroke(
        &mut self,
        standing: &mut Standing,
        facts: &Facts,
        call: &Call,
        ruling: &mut Ruling,
    ) {
        self.before = None;
        let aim = self.aim(facts, call);
        let mut wrong = Self::wrong(facts, &aim);
        let gone: Vec<usize> = facts
            .object_potted()
            .map(|potted| potted.ball)
            .chain(facts.object_off())
            .filter(|&ball| value(facts.scene, ball) > 1)
            .collect();
        let potted: Vec<usize> = facts.object_potted().map(|potted| potted.ball).collect();
        if wrong.fouls.is_empty() {
            let stays_down = |ball: &usize| {
                matches!(self.on, BallOn::Sequence { .. }) && Some(*ball) != aim.free
            };
            let back = gone.iter().copied().filter(|ball| !stays_down(ball));
            respot(&mut ruling.spotter, back.collect());
            if potted.is_empty() {
                Self::look_behind_free_ball(facts, &aim, ruling, &mut wrong);
            }
        } else {
            respot(&mut ruling.spotter, gone);
        }
        if wrong.fouls.is_empty() {
            self.after_good(standing, &aim, potted, ruling);
        } else {
            self.after_foul(standing, facts, &aim, wrong, ruling);
        }
    }

    /// It is a foul to leave the opponent snookered behind the free ball, but with only pink and black left.
    fn look_behind_free_ball(facts: &Facts, aim: &Aim, ruling: &Ruling, wrong: &mut Wrong) {
        let after = ruling.spotter.scene();
        let (Some(free), Some(next)) = (aim.free, BallOn::fresh(after)) else {
            return;
        };
        let on = next.balls(after);
        let only_last_two = valued(after, |value| value < 6).is_empty();
        if !only_last_two
            && !on.contains(&free)
            && is_snookered_by(after, facts.cue, None, &on, &[free])
        {
            wrong
                .fouls
                .push(Foul::SnookeredBehindFreeBall { ball: free });
        }
    }

    fn after_good(
        &mut self,
        standing: &mut Standing,
        aim: &Aim,
        potted: Vec<usize>,
        ruling: &mut Ruling,
    ) {
        (self.free_ball, self.misses) = (false, 0);
        let after = ruling.spotter.scene();
        let fresh = BallOn::fresh(after);
        if potted.is_empty() {
            standing.pass();
            self.on = fresh.unwrap_or_default();
            return;
        }
        standing.barren = 0;
        standing.scores[standing.turn] += match self.on {
            // Every red counts, and a free ball as one of them.
            BallOn::Red => potted.len() as i32,
            // The free ball and the ball on together count once.
            _ => aim.worth,
        };
        ruling.made = potted;
        match (self.on, fresh) {
            (BallOn::Red, _) => self.on = BallOn::Colour,
            (_, Some(next)) => self.on = next,
            (_, None) => self.end_frame(standing, ruling),
        }
    }

    fn after_foul(
        &mut self,
        standing: &mut Standing,
        facts: &Facts,
        aim: &Aim,
        wrong: Wrong,
        ruling: &mut Ruling,
    ) {
        let (offender, other) = (standing.turn, standing.next_player());
        let on_before = self.on;
        let points = wrong.cost;
        let miss = self.is_miss(standing, facts, &wrong, ruling, points);
        ruling.fouls = wrong.fouls;
        ruling.notes.push(Note::PenaltyPoints { points });
        standing.scores[other] += points;
        standing.pass();

        let was_alone = valued(facts.scene, |_| true).len() == 1;
        let fresh = BallOn::fresh(ruling.spotter.scene());
        if was_alone || self.respotted || fresh.is_none() {
            self.end_frame(standing, ruling);
            return;
        }
        let full = is_full_ball_open(facts.scene, facts.cue, &aim.on_before(self, facts.scene));
        let misses = if miss && full { self.misses + 1 } else { 0 };
        if miss && self.misses_lose > 0 && misses >= self.misses_lose {
            ruling.notes.push(Note::Miss { in_a_row: misses });
            standing.end(Some(other), Reason::ThreeMisses);
            return;
        }
        let before = Before {
            on: on_before,
            free_ball: self.free_ball,
            misses,
        };
        self.on = fresh.unwrap_or_default();
        self.misses = 0;
        let gone = facts.scratch().is_some() || facts.off.contains(&facts.cue);
        standing.in_hand = gone.then(|| Area::in_d(&facts.scene.table));
        self.free_ball =
            Self::is_snookered(self.on, ruling.spotter.scene(), facts.cue, standing.in_hand);
        if self.free_ball {
            ruling.notes.push(Note::FreeBall);
        }
        standing.choices = vec![Choice::Accept, Choice::HandBack];
        if miss {
            ruling.notes.push(Note::Miss { in_a_row: misses });
            standing.choices.push(Choice::PutBack);
        }
        self.before = Some(before);
        debug_assert_ne!(offender, standing.turn);
    }

    /// Whether the foul is a miss too: the ball on was not hit, could have been, and neither side needs penalty points to
    /// win, before the foul or after it.
    fn is_miss(
        &self,
        standing: &Standing,
        facts: &Facts,
        wrong: &Wrong,
        ruling: &Ruling,
        points: i32,
    ) -> bool {
        let (offender, other) = (standing.turn, standing.next_player());
        let lead = standing.scores[other] - standing.scores[offender];
        let before = self.on.remaining(facts.scene);
        let scene = ruling.spotter.scene();
        let after = BallOn::fresh(scene).map_or(0, |on| on.remaining(scene));
        let needs_penalty = lead.abs() > before || (lead + points).abs() > after;
        let possible = match self.miss {
            MissRule::Always => true,
            MissRule::ClearWay => {
                !is_snookered(facts.scene, facts.cue, None, &self.hittable(facts.scene))
            }
            MissRule::Never => false,
        };
        wrong.missed && possible && !needs_penalty
    }

    /// No ball is left, or the last foul is made: the greater score wins; level scores bring the black back.
    fn end_frame(&mut self, standing: &mut Standing, ruling: &mut Ruling) {
        let [one, two] = [standing.scores[0], standing.scores[1]];
        if one != two {
            let winner = usize::from(two > one);
            standing.end(Some(winner), Reason::LastBall);
            return;
        }
        ruling.notes.push(Note::RespottedBlack);
        self.respotted = true;
        (self.on, self.free_ball) = (BallOn::Sequence { value: 7 }, false);
        let black = ruling.spotter.scene().ball_named("black");
        respot(&mut ruling.spotter, black.into_iter().collect());
        // The lot decides who chooses.
        let mut lot = ChaCha8Rng::seed_from_u64(standing.seed ^ u64::from(standing.shots));
        standing.turn = lot.random_range(0..standing.players);
        standing.in_hand = Some(Area::in_d(&ruling.spotter.scene().table));
        standing.choices = vec![Choice::GoFirst, Choice::GoSecond];
    }

    pub(super) fn carry_out(
        &mut self,
        standing: &mut Standing,
        _scene: &Scene,
        choice: Choice,
        ruling: &mut Ruling,
    ) {
        let before = self.before.take();
        match (choice, before) {
            (Choice::HandBack, _) => {
                standing.turn = standing.last_player();
                self.free_ball = false;
            }
            (Choice::PutBack, Some(before)) => {
                standing.turn = standing.last_player();
                standing.in_hand = None;
                (self.on, self.free_ball) = (before.on, before.free_ball);
                self.misses = before.misses;
                ruling.table = TableChange::PutBack;
            }
            (Choice::GoSecond, _) => standing.turn = standing.next_player(),
            _ => {}
        }
    }
}

impl Aim {
    /// The balls that were on before the stroke, whatever was nominated.
    fn on_before(&self, rules: &Snooker, scene: &Scene) -> Vec<usize> {
        if self.on.is_empty() {
            return rules.hittable(scene);
        }
        self.on.clone()
    }
}
