//! Three-cushion, and its sisters with fewer cushions (UMB, world rules of carom billiard, 1 January 1989).

use std::ops::RangeInclusive;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::game::rules::call::Call;
use crate::game::rules::facts::{FROZEN, Facts, TIE};
use crate::game::rules::foul::Foul;
use crate::game::rules::pool;
use crate::game::rules::ruling::Ruling;
use crate::game::rules::spot::APART;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{On, in_play};
use crate::game::rules::verdict::{Choice, Note, Reason, TableChange};
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{Rack, Scene};
use crate::physics::table::Table;

/// What happens when the cue ball of the next player is frozen to another ball. Codes differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Frozen {
    /// The balls that touch go to their spots (UMB).
    #[default]
    Respot,
    /// The player chooses: spots, or play away from it (USBA).
    Choice,
}

/// The rules of three-cushion, and where the game stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ThreeCushion {
    /// Points that win.
    pub to: i32,
    /// Innings after which the game ends; `None` for no limit.
    pub innings: Option<u32>,
    /// Cushions that must be met before the second ball: 3, 1, or 0 for the free game.
    pub cushions: usize,
    /// Whether the second player has a last inning after the first has reached the points.
    pub equalising_inning: bool,
    /// What happens when the cue ball is frozen to another ball.
    pub frozen: Frozen,
    /// Whether the next stroke is from the opening position.
    pub opening: bool,
    /// Innings that both players have finished.
    pub played: u32,
    /// Whether this is the last inning of the second player.
    pub equalising: bool,
}

impl Default for ThreeCushion {
    fn default() -> Self {
        Self {
            to: 40,
            innings: None,
            cushions: 3,
            equalising_inning: true,
            frozen: Frozen::Respot,
            opening: true,
            played: 0,
            equalising: false,
        }
    }
}

/// The name of the ball that a player strikes: who begins has the white one.
fn cue_name(standing: &Standing, player: usize) -> &'static str {
    if player == standing.breaker {
        "white"
    } else {
        "yellow"
    }
}

fn plan(scene: &Scene, ball: usize) -> DVec2 {
    let position = scene.balls[ball].state.position;
    DVec2::new(position.x, position.z)
}

impl ThreeCushion {
    /// How many cushions the cue ball met before it met the second of the other two balls; `None` if it never did.
    #[must_use]
    pub fn cushions_before_second(facts: &Facts) -> Option<usize> {
        let first = facts.met_by(facts.cue).next()?.1;
        let mut met = facts.met_by(facts.cue);
        let (time, _) = met.find(|(_, other)| *other != first)?;
        let reached = facts.cushions_of(facts.cue);
        Some(reached.iter().filter(|cushion| cushion.time < time).count())
    }

    fn fouls(&self, facts: &Facts) -> Vec<Foul> {
        let mut fouls = pool::general(facts);
        let frozen = facts
            .met_by(facts.cue)
            .find(|&(time, ball)| time <= TIE && facts.are_frozen(facts.cue, ball));
        if let Some((_, ball)) = frozen {
            fouls.push(Foul::IntoFrozen { ball });
        }
        let red = facts.scene.ball_named("red");
        if let (true, Some(red), Some(&hit)) = (self.opening, red, facts.first.first())
            && !facts.first.contains(&red)
        {
            let on = vec![red];
            fouls.push(Foul::WrongBall { hit, on });
        }
        fouls
    }

    /// The inning of the player at the table ends.
    fn pass(&mut self, standing: &mut Standing, ruling: &mut Ruling) {
        let second = standing.turn != standing.breaker || standing.players == 1;
        self.played += u32::from(second);
        let reached = standing.scores.iter().any(|score| *score >= self.to);
        let over_by_innings = second && self.innings.is_some_and(|most| self.played >= most);
        if reached && !second && self.equalising_inning {
            // The second player begins the last inning from the opening position.
            standing.pass();
            self.equalising = true;
            self.opening = true;
            let player = standing.turn;
            ruling.notes.push(Note::EqualisingInning { player });
            let table = ruling.spotter.scene().table.clone();
            for (ball, spot) in opening(ruling.spotter.scene(), &table, cue_name(standing, player))
            {
                ruling.spotter.put(ball, spot);
            }
        } else if reached {
            let needed = self.to;
            standing.end(leader(standing), Reason::Points { needed });
        } else if over_by_innings {
            let played = self.played;
            standing.end(leader(standing), Reason::Innings { played });
        } else {
            standing.pass();
        }
    }

    /// Balls that left the table, and those frozen to the cue ball of the next player, go to their spots.
    fn settle(&self, standing: &mut Standing, cue: usize, ruling: &mut Ruling) {
        let scene = ruling.spotter.scene();
        let gone: Vec<usize> = (0..scene.balls.len())
            .filter(|&ball| !scene.balls[ball].state.motion.in_play())
            .collect();
        to_spots(cue, gone, ruling);
        let frozen = frozen_to(ruling.spotter.scene(), cue);
        if frozen.len() < 2 {
            return;
        }
        match self.frozen {
            Frozen::Respot => to_spots(cue, frozen, ruling),
            Frozen::Choice => standing.choices = vec![Choice::Accept, Choice::Spot],
        }
    }
}

/// The opening position with this ball to strike.
fn opening(scene: &Scene, table: &Table, cue: &str) -> Vec<(usize, DVec2)> {
    let mut racked = Scene {
        table: table.clone(),
        balls: Vec::new(),
        ..scene.clone()
    };
    Rack::ThreeCushion.place(&mut racked, scene.balls[0].ball, 0.0, 0);
    // Seen by the player of the yellow ball the two cue balls change places.
    let name = |racked: &str| match (cue, racked) {
        ("yellow", "white") => "yellow".to_owned(),
        ("yellow", "yellow") => "white".to_owned(),
        _ => racked.to_owned(),
    };
    (0..racked.balls.len())
        .filter_map(|ball| {
            let index = scene.ball_named(&name(&racked.balls[ball].name))?;
            Some((index, plan(&racked, ball)))
        })
        .collect()
}

/// Who has more points; nobody if nobody has.
fn leader(standing: &Standing) -> Option<usize> {
    let most = standing.scores.iter().max()?;
    let mut leaders = (0..standing.players).filter(|&player| standing.scores[player] == *most);
    let leader = leaders.next();
    leader.filter(|_| leaders.next().is_none())
}

/// The cue ball and the balls frozen to it, if any is.
fn frozen_to(scene: &Scene, cue: usize) -> Vec<usize> {
    let near = |ball: &usize| {
        let reach = scene.balls[cue].ball.radius + scene.balls[*ball].ball.radius;
        plan(scene, cue).distance(plan(scene, *ball)) <= reach + FROZEN
    };
    in_play(scene).filter(near).collect()
}

/// Puts balls on their spots: red on the foot spot, the ball to strike on the head spot, the third in the middle. A spot
/// that is taken by a ball that stays gives that ball's own spot instead.
fn to_spots(cue: usize, balls: Vec<usize>, ruling: &mut Ruling) {
    let table = ruling.spotter.scene().table.clone();
    let own = |scene: &Scene, ball: usize| {
        if scene.balls[ball].name == "red" {
            table.foot_spot()
        } else if ball == cue {
            table.head_spot()
        } else {
            DVec2::ZERO
        }
    };
    for &ball in &balls {
        ruling.spotter.lift(ball);
    }
    for ball in balls {
        let mut spot = own(ruling.spotter.scene(), ball);
        for _ in 0..3 {
            let scene = ruling.spotter.scene();
            let bars = in_play(scene).find(|&other| {
                let reach = scene.balls[ball].ball.radius + scene.balls[other].ball.radius;
                plan(scene, other).distance(spot) < reach + APART
            });
            match bars {
                Some(other) => spot = own(scene, other),
                None => break,
            }
        }
        ruling.spotter.put(ball, spot);
    }
}

impl RuleSet for ThreeCushion {
    fn code(&self) -> Code {
        Code {
            name: "three-cushion",
            title: "Three-cushion",
            edition: "UMB world rules of carom billiard, 1 January 1989",
            equipment: "heated_carom",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![
            setting("to", self.to, "points that win, such as 40 or 50"),
            setting(
                "innings",
                self.innings,
                "innings after which the game ends, or None",
            ),
            setting(
                "cushions",
                self.cushions,
                "cushions before the second ball: 3, 1, or 0 for the free game",
            ),
            setting(
                "equalising_inning",
                self.equalising_inning,
                "the second player has a last inning",
            ),
            setting(
                "frozen",
                self.frozen,
                "Respot (UMB) or Choice (USBA): a cue ball frozen to another ball",
            ),
        ]
    }

    fn players(&self) -> RangeInclusive<usize> {
        1..=2
    }

    fn has_pockets(&self) -> bool {
        false
    }

    fn counts_points(&self) -> bool {
        true
    }

    fn rack(&self) -> Rack {
        Rack::ThreeCushion
    }

    fn begin(&mut self, _standing: &mut Standing, _scene: &Scene) {
        (self.opening, self.equalising, self.played) = (true, false, 0);
    }

    fn cue_ball(&self, standing: &Standing, scene: &Scene) -> usize {
        scene
            .ball_named(cue_name(standing, standing.turn))
            .unwrap_or(0)
    }

    fn targets(&self, standing: &Standing, scene: &Scene, on: &mut On) {
        let cue = self.cue_ball(standing, scene);
        let others = in_play(scene).filter(|&ball| ball != cue);
        on.first = others
            .filter(|&ball| !self.opening || scene.balls[ball].name == "red")
            .collect();
        on.is_break = self.opening;
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, _call: &Call, ruling: &mut Ruling) {
        ruling.fouls = self.fouls(facts);
        let scored = Self::cushions_before_second(facts)
            .is_some_and(|cushions| cushions >= self.cushions)
            && ruling.fouls.is_empty();
        self.opening = false;
        if scored {
            standing.scores[standing.turn] += 1;
            standing.barren = 0;
            let score = standing.scores[standing.turn];
            let second = standing.turn != standing.breaker || standing.players == 1;
            // Who has drawn level in the last inning stops there.
            let level = self.equalising && score >= self.to;
            if level || (score >= self.to && (second || !self.equalising_inning)) {
                self.played += u32::from(second);
                let needed = self.to;
                standing.end(leader(standing), Reason::Points { needed });
            } else if score >= self.to {
                self.pass(standing, ruling);
                return;
            }
        } else {
            self.pass(standing, ruling);
        }
        if standing.over.is_none() && !self.opening {
            let cue = self.cue_ball(standing, facts.scene);
            self.settle(standing, cue, ruling);
        }
    }

    fn choose(
        &mut self,
        standing: &mut Standing,
        scene: &Scene,
        choice: Choice,
        ruling: &mut Ruling,
    ) {
        if choice == Choice::Spot {
            let cue = self.cue_ball(standing, scene);
            to_spots(cue, frozen_to(scene, cue), ruling);
            ruling.table = TableChange::Keep;
        }
    }
}
