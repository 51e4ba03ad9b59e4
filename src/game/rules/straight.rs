//! Straight pool, 14.1 continuous (WPA rules of play, edition of 23 June 2025).

use std::ops::RangeInclusive;

use glam::DVec2;
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::foul::Foul;
use crate::game::rules::pool;
use crate::game::rules::ruling::Ruling;
use crate::game::rules::spot::Spotter;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{CallNeeded, On, in_play, numbered};
use crate::game::rules::verdict::{Choice, Note, Reason, TableChange};
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{Rack, Scene};

/// Points that three fouls in a row cost besides their own.
const THREE_FOULS: i32 = 15;

/// Object balls that an opening break without a call must drive to cushions, beside the cue ball.
const OPENING: usize = 2;

/// The rules of straight pool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct StraightPool {
    /// Points that win.
    pub to: i32,
    /// Whether the next stroke is an opening break.
    pub opening: bool,
}

impl Default for StraightPool {
    fn default() -> Self {
        Self {
            to: 100,
            opening: true,
        }
    }
}

impl StraightPool {
    fn opening_break(&mut self, standing: &mut Standing, facts: &Facts, ruling: &mut Ruling) {
        let string = Area::behind_head_string(&facts.scene.table);
        let driven = facts.driven_to_cushions();
        let cue_driven = facts.first_time.is_some_and(|first| {
            let reached = facts.cushions_of(facts.cue);
            reached.iter().any(|reached| reached.time >= first)
        });
        if driven < OPENING || !cue_driven {
            // Breaking badly costs two points whatever else happened, and does not count among fouls in a row.
            ruling.fouls.insert(
                0,
                Foul::WeakBreak {
                    driven: driven + usize::from(cue_driven),
                    needed: OPENING + 1,
                },
            );
            standing.scores[standing.turn] -= 2;
            let choice = if Self::is_cue_gone(facts) {
                Choice::InHand
            } else {
                Choice::Accept
            };
            standing.pass();
            standing.choices = vec![choice, Choice::TheyBreak];
            return;
        }
        self.opening = false;
        if ruling.fouls.is_empty() {
            standing.count_foul(false);
            standing.pass();
        } else {
            self.after_foul(standing, facts, string, ruling);
        }
    }

    fn is_cue_gone(facts: &Facts) -> bool {
        facts.scratch().is_some() || facts.off.contains(&facts.cue)
    }

    fn after_foul(
        &mut self,
        standing: &mut Standing,
        facts: &Facts,
        string: Area,
        ruling: &mut Ruling,
    ) {
        let player = standing.turn;
        standing.scores[player] -= 1;
        match standing.count_foul(true) {
            3 => {
                standing.scores[player] -= THREE_FOULS;
                let points = THREE_FOULS;
                ruling.notes.push(Note::ThreeFoulPenalty { player, points });
                self.rerack(standing, player, ruling);
            }
            fouls => {
                if fouls == 2 {
                    ruling.notes.push(Note::TwoFouls { player });
                }
                standing.pass();
                if Self::is_cue_gone(facts) {
                    standing.in_hand = Some(string);
                }
            }
        }
    }

    fn rerack(&mut self, standing: &mut Standing, breaker: usize, ruling: &mut Ruling) {
        self.opening = true;
        standing.rerack(breaker);
        standing.in_hand = Some(Area::behind_head_string(&ruling.spotter.scene().table));
        ruling.table = TableChange::Rerack;
    }

    /// With one object ball left, or none, the others are racked again and the run goes on.
    fn next_rack(standing: &mut Standing, facts: &Facts, ruling: &mut Ruling) {
        let cue = facts.cue;
        let scene = ruling.spotter.scene();
        let left: Vec<usize> = in_play(scene).filter(|&ball| ball != cue).collect();
        if left.len() > 1 {
            return;
        }
        ruling.notes.push(Note::Rerack);
        standing.seed = standing.seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let places = Rack::Straight.places(&scene.table, scene.balls[cue].ball.radius);
        let lie = Lie::of(scene, &places, cue, left.first().copied());
        let mut down: Vec<usize> = (0..scene.balls.len())
            .filter(|ball| *ball != cue && !left.contains(ball))
            .collect();
        down.shuffle(&mut ChaCha8Rng::seed_from_u64(standing.seed));
        lie.settle(standing, &mut ruling.spotter, &places, down);
    }
}

/// Where a ball lies, as far as a new rack of fourteen is concerned.
#[derive(Clone, Copy, PartialEq)]
enum Where {
    /// In the way of the rack.
    Rack,
    /// In the way of the head spot.
    HeadSpot,
    /// Behind the head string.
    Kitchen,
    /// Anywhere else.
    Elsewhere,
}

impl Where {
    fn of(scene: &Scene, places: &[DVec2], ball: usize) -> Self {
        let position = scene.balls[ball].state.position;
        let here = DVec2::new(position.x, position.z);
        let diameter = 2.0 * scene.balls[ball].ball.radius;
        let head = scene.table.head_spot();
        if places.iter().any(|place| place.distance(here) < diameter) {
            Self::Rack
        } else if here.distance(head) < diameter {
            Self::HeadSpot
        } else if here.x < head.x {
            Self::Kitchen
        } else {
            Self::Elsewhere
        }
    }
}

/// Where the cue ball and the last ball lie when fourteen balls are racked again.
struct Lie {
    cue: (usize, Where),
    last: Option<(usize, Where)>,
}

impl Lie {
    fn of(scene: &Scene, places: &[DVec2], cue: usize, last: Option<usize>) -> Self {
        let lies = |ball: usize| (ball, Where::of(scene, places, ball));
        Self {
            cue: lies(cue),
            last: last.map(lies),
        }
    }

    /// The table of the rule book: who goes where when the rack is in the way.
    fn settle(
        &self,
        standing: &mut Standing,
        spotter: &mut Spotter,
        places: &[DVec2],
        mut down: Vec<usize>,
    ) {
        let table = spotter.scene().table.clone();
        let (head, center) = (table.head_spot(), DVec2::ZERO);
        let (cue, cue_lies) = self.cue;
        let mut whole = self.last.is_none();
        if let Some((last, Where::Rack)) = self.last {
            match cue_lies {
                Where::Rack => {
                    down.push(last);
                    whole = true;
                }
                Where::HeadSpot => spotter.put(last, center),
                _ => spotter.put(last, head),
            }
        }
        if cue_lies == Where::Rack {
            match self.last {
                Some((_, Where::HeadSpot)) => spotter.put(cue, center),
                Some((_, Where::Kitchen)) => spotter.put(cue, head),
                _ => standing.in_hand = Some(Area::behind_head_string(&table)),
            }
        }
        let from = usize::from(!whole);
        for (ball, place) in down.into_iter().zip(&places[from..]) {
            spotter.put(ball, *place);
        }
    }
}

impl RuleSet for StraightPool {
    fn code(&self) -> Code {
        Code {
            name: "14.1",
            title: "Straight pool (14.1 continuous)",
            edition: "WPA rules of play, 23 June 2025",
            equipment: "pool",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![setting(
            "to",
            self.to,
            "points that win, such as 100 or 150",
        )]
    }

    fn players(&self) -> RangeInclusive<usize> {
        2..=8
    }

    fn counts_points(&self) -> bool {
        true
    }

    fn rack(&self) -> Rack {
        Rack::Straight
    }

    fn begin(&mut self, standing: &mut Standing, scene: &Scene) {
        self.opening = true;
        standing.in_hand = Some(Area::behind_head_string(&scene.table));
    }

    fn targets(&self, _standing: &Standing, scene: &Scene, on: &mut On) {
        on.pot = numbered(scene, |_| true);
        on.first = on.pot.clone();
        on.is_break = self.opening;
        on.call_needed = CallNeeded::BallAndPocket;
        on.may_call_safety = true;
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, call: &Call, ruling: &mut Ruling) {
        let string = Area::behind_head_string(&facts.scene.table);
        let all = numbered(facts.scene, |_| true);
        ruling.fouls = pool::general(facts);
        let contact = pool::contact(facts, &all, ruling.in_hand);
        ruling.fouls.extend(contact);
        let fell: Vec<usize> = facts.object_potted().map(|potted| potted.ball).collect();
        let called = facts
            .object_potted()
            .any(|potted| pool::is_called(facts, potted, call));
        if ruling.fouls.is_empty() && called {
            self.opening = false;
            standing.count_foul(false);
            standing.scores[standing.turn] += fell.len() as i32;
            standing.barren = 0;
            ruling.made = fell;
            if standing.scores[standing.turn] >= self.to {
                let needed = self.to;
                standing.end(Some(standing.turn), Reason::Points { needed });
            } else {
                Self::next_rack(standing, facts, ruling);
            }
            return;
        }
        let back = fell.iter().copied().chain(facts.object_off());
        pool::spot(&mut ruling.spotter, back);
        if self.opening {
            self.opening_break(standing, facts, ruling);
        } else if ruling.fouls.is_empty() {
            standing.count_foul(false);
            if *call == Call::Safety {
                ruling.notes.push(Note::Safety);
            } else if !fell.is_empty() {
                ruling.notes.push(Note::NotCalled { balls: fell });
            }
            standing.pass();
        } else {
            self.after_foul(standing, facts, string, ruling);
        }
    }

    fn choose(
        &mut self,
        standing: &mut Standing,
        scene: &Scene,
        choice: Choice,
        ruling: &mut Ruling,
    ) {
        match choice {
            Choice::TheyBreak => self.rerack(standing, standing.last_player(), ruling),
            Choice::InHand => {
                self.opening = false;
                standing.in_hand = Some(Area::behind_head_string(&scene.table));
            }
            _ => self.opening = false,
        }
    }
}
