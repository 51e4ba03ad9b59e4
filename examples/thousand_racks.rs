//! Computer against computer, rack after rack: `cargo run --release --no-default-features --example thousand_racks`.
//!
//! Every rack must end with a winner, without a stuck state and without a panic, and the memory must stay what it was.
//! Other runs: `thousand_racks 9-ball:Bea:Pip:200 snooker:Lou:Bea:10`. The exit code is 1 if anything is amiss.

use std::error::Error;
use std::panic::catch_unwind;
use std::process::ExitCode;
use std::time::Instant;

use masse::game::players::Level;
use masse::game::players::contest::{Rack, play_rack};
use masse::game::rules::Game;
use masse::physics::scene::Scene;
use masse::scenarios::preset;
use rayon::prelude::*;

/// Racks after which the memory is told.
const TOLD: u64 = 100;

/// What is played when nothing is said.
const RUN: &str = "8-ball:Bea:Pip:1000";

/// Racks of one game between two levels.
struct Run {
    game: Game,
    levels: [Level; 2],
    racks: u64,
    like: Scene,
}

impl Run {
    fn read(text: &str) -> Result<Self, Box<dyn Error>> {
        let parts: Vec<&str> = text.split(':').collect();
        let [game, one, other, racks] = parts.as_slice() else {
            return Err(format!("`{text}` is not GAME:LEVEL:LEVEL:RACKS").into());
        };
        let game = Game::named(game).ok_or_else(|| format!("there is no game `{game}`"))?;
        let level = |name: &str| Level::named(name).ok_or(format!("there is no level `{name}`"));
        Ok(Self {
            levels: [level(one)?, level(other)?],
            racks: racks.parse()?,
            like: preset::open(game.rules().code().equipment)?
                .equipment
                .scene(),
            game,
        })
    }

    /// One rack; the breaks go in turn.
    fn rack(&self, number: u64) -> Result<Rack, String> {
        let breaker = usize::from(number % 2 == 1);
        let [one, other] = &self.levels;
        let played = catch_unwind(|| {
            play_rack(
                &self.game,
                [one, other],
                breaker,
                &self.like,
                0x5EED + number,
            )
        });
        match played {
            Ok(rack) => rack.map_err(|error| error.to_string()),
            Err(_) => Err("a panic".to_owned()),
        }
    }
}

/// What has come of the racks so far.
#[derive(Default)]
struct Count {
    won: [u64; 2],
    drawn: u64,
    shots: u64,
    fouls: u64,
    rehearsed: u64,
    amiss: u64,
}

impl Count {
    fn add(&mut self, rack: &Rack) {
        match rack.winner {
            Some(winner) => self.won[winner] += 1,
            None => self.drawn += 1,
        }
        for tally in &rack.tallies {
            self.shots += u64::from(tally.shots);
            self.fouls += u64::from(tally.fouls);
            self.rehearsed += tally.trials;
        }
    }
}

/// A line of `/proc/self/status` in KiB, where the system tells.
fn status(key: &str) -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(key));
    let number = line.and_then(|line| line.trim().split(' ').next()?.parse().ok());
    number.unwrap_or(0)
}

fn play(run: &Run) -> Count {
    let [one, other] = run.levels.map(|level| level.name);
    let name = run.game.rules().code().name;
    println!("{name}, {one} against {other}, {} racks", run.racks);
    let (mut count, begun) = (Count::default(), Instant::now());
    let mut settled = None;
    let mut done = 0;
    while done < run.racks {
        let until = (done + TOLD).min(run.racks);
        let racks: Vec<(u64, Result<Rack, String>)> = (done..until)
            .into_par_iter()
            .map(|number| (number, run.rack(number)))
            .collect();
        for (number, rack) in racks {
            match rack {
                Ok(rack) => count.add(&rack),
                Err(why) => {
                    count.amiss += 1;
                    println!("rack {number}: {why}");
                }
            }
        }
        done = until;
        let memory = status("VmRSS:");
        let first = *settled.get_or_insert(memory);
        println!(
            "{done:5} racks, {:6} shots, {:9} rehearsed, {:6.0} s, memory {memory} KiB, {:+} since the first {TOLD}",
            count.shots,
            count.rehearsed,
            begun.elapsed().as_secs_f64(),
            memory as i64 - first as i64,
        );
    }
    println!(
        "{one} won {}, {other} {}, nobody {}; {:.1} shots a rack, {:.1} % fouls, {} amiss; most memory {} KiB\n",
        count.won[0],
        count.won[1],
        count.drawn,
        count.shots as f64 / run.racks.max(1) as f64,
        100.0 * count.fouls as f64 / count.shots.max(1) as f64,
        count.amiss,
        status("VmHWM:"),
    );
    count
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut asked: Vec<String> = std::env::args().skip(1).collect();
    if asked.is_empty() {
        asked.push(RUN.to_owned());
    }
    let runs = asked.iter().map(|text| Run::read(text));
    let runs = runs.collect::<Result<Vec<_>, _>>()?;
    let counts: Vec<Count> = runs.iter().map(play).collect();
    let shots: u64 = counts.iter().map(|count| count.shots).sum();
    let amiss: u64 = counts.iter().map(|count| count.amiss).sum();
    println!("{shots} shots in all, {amiss} racks amiss");
    Ok(ExitCode::from(u8::from(amiss > 0)))
}
