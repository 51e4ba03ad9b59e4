//! Matches: turns, racks, statistics, undo, replays, and what becomes of them on disk.

mod beside;
mod damage;
mod played;
mod random;
mod saving;

pub(crate) use damage::headed;

use glam::DVec2;
use masse::game::matches::{Breaks, Match, Mind, Phase, Player, Setup};
use masse::game::rules::{Call, CallNeeded, Game, Verdict};
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

pub(crate) fn player(name: &str) -> Player {
    Player {
        name: name.to_owned(),
        mind: Mind::Person,
    }
}

/// A match of this game between as many players as it needs at least, but two if it can be.
pub(crate) fn setup(game: &Game, race: u32, seed: u64) -> Setup {
    let range = game.rules().players();
    let players = 2.clamp(*range.start(), *range.end());
    Setup {
        game: game.clone(),
        players: (0..players)
            .map(|i| player(&format!("Player {i}")))
            .collect(),
        race,
        breaks: Breaks::Alternate,
        first: 0,
        seed,
        undo: false,
    }
}

/// The table that a game is played on.
pub(crate) fn like(game: &Game) -> Scene {
    let table = match game.rules().code().equipment {
        "snooker" => Preset::Snooker,
        "heated_carom" => Preset::Carom,
        _ => Preset::NineFoot,
    };
    Scene::new(table.table(), Laws::default())
}

pub(crate) fn begin(game: &Game, race: u32, seed: u64) -> Match {
    Match::new(setup(game, race, seed), &like(game)).expect("the match fits")
}

/// Somebody who aims at something and hits about what was aimed at.
pub(crate) struct Hand {
    random: ChaCha8Rng,
}

fn plan(scene: &Scene, ball: usize) -> DVec2 {
    let position = scene.balls[ball].state.position;
    DVec2::new(position.x, position.z)
}

impl Hand {
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            random: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    /// Places, calls, chooses and aims, until a stroke is played.
    pub(crate) fn play(&mut self, game: &mut Match) -> Verdict {
        while game.phase() == Phase::Choose {
            let choices = game.targets().choices;
            let choice = choices
                .choose(&mut self.random)
                .expect("something to choose");
            game.choose(*choice).expect("it was offered");
        }
        self.place(game);
        let (heading, call) = self.aim(game);
        game.call(call).expect("it may be called");
        let shot = Shot {
            heading,
            speed: self.speed(game),
            side: self.random.random_range(-0.2..0.2),
            height: self.random.random_range(-0.3..0.3),
            ..Shot::default()
        };
        let scene = game.scene_with(shot);
        let record = solve(&scene, Limits::default()).expect("the shot is played");
        let thought = self.random.random_range(0.0..3.0);
        game.played(shot, &record, thought)
            .expect("the stroke is due")
    }

    fn speed(&mut self, game: &Match) -> f64 {
        if game.targets().is_break {
            return 9.0;
        }
        self.random.random_range(0.5..6.0)
    }

    fn place(&mut self, game: &mut Match) {
        let on = game.targets();
        let Some(area) = on.in_hand else { return };
        let (least, most) = area.bounds();
        let share = DVec2::new(self.random.random(), self.random.random());
        let table = game.table();
        if let Some(spot) = area.place(&table, on.cue, least + share * (most - least)) {
            game.place(spot).expect("the place is legal");
        }
    }

    /// Mostly the straightest pot with a clear way, sometimes anywhere.
    fn aim(&mut self, game: &Match) -> (f64, Call) {
        let (on, table) = (game.targets(), game.table());
        let from = plan(&table, on.cue);
        let any = *on.first.choose(&mut self.random).expect("something is on");
        let wild = self.random.random_range(0..6) == 0;
        let pots = on.first.iter().flat_map(|&ball| pots(&table, on.cue, ball));
        let best = pots.max_by(|a, b| a.straight.total_cmp(&b.straight));
        let (ball, at) = match &best {
            Some(pot) if !wild => (pot.ball, pot.ghost),
            _ => {
                let aside = DVec2::new(0.0, self.random.random_range(-0.04..0.04));
                (any, plan(&table, any) + aside)
            }
        };
        let way = at - from;
        let noise = self.random.random_range(-0.004..0.004);
        let heading = libm::atan2(-way.y, way.x) + noise;
        let call = match (on.call_needed, best) {
            (CallNeeded::Ball, _) => Call::Nominate { ball },
            (CallNeeded::BallAndPocket, Some(pot)) => Call::Pot {
                ball: pot.ball,
                pocket: pot.pocket,
            },
            _ if on.may_push_out && self.random.random_range(0..4) == 0 => Call::PushOut,
            _ => Call::Nothing,
        };
        let safety = on.may_call_safety && self.random.random_range(0..10) == 0;
        (heading, if safety { Call::Safety } else { call })
    }
}

/// A pot that can be tried.
struct Pot {
    ball: usize,
    pocket: usize,
    /// Where the cue ball has to be at the contact.
    ghost: DVec2,
    /// Cosine of the cut; less for a way that is not clear.
    straight: f64,
}

/// The ways of a ball into every pocket.
fn pots(table: &Scene, cue: usize, ball: usize) -> impl Iterator<Item = Pot> {
    let (from, target) = (plan(table, cue), plan(table, ball));
    let reach = table.balls[cue].ball.radius + table.balls[ball].ball.radius;
    let pockets = table.table.pockets.iter().enumerate();
    pockets.map(move |(pocket, hole)| {
        let way = (hole.center - target).normalize();
        let ghost = target - reach * way;
        let cosine = way.dot((ghost - from).normalize_or_zero());
        let clear = |start: DVec2, end: DVec2| {
            (0..table.balls.len())
                .filter(|&other| other != cue && other != ball)
                .filter(|&other| table.balls[other].state.motion.in_play())
                .all(|other| {
                    let center = plan(table, other);
                    let along = (center - start).dot(end - start) / (end - start).length_squared();
                    (start + along.clamp(0.0, 1.0) * (end - start)).distance(center) >= reach
                })
        };
        let open = clear(from, ghost) && clear(target, hole.center);
        Pot {
            ball,
            pocket,
            ghost,
            straight: if open { cosine } else { cosine - 3.0 },
        }
    })
}
