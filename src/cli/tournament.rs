//! `masse tournament`: computer against computer, without a window.

use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::cli::{CommandError, say, to_stdout};
use crate::game::players::Level;
use crate::game::players::contest::{ContestError, Rack, play_rack};
use crate::game::players::standings::{Pairing, Standings};
use crate::game::rules::Game;
use crate::physics::scene::Scene;
use crate::scenarios::preset;

/// Who plays what how often.
#[derive(Args, Debug)]
pub(super) struct TournamentOptions {
    /// The game
    #[arg(long, default_value = "8-ball")]
    game: String,
    /// Levels, the weakest first, separated by commas; each plays the next one
    #[arg(long, value_delimiter = ',', default_values_t = Level::ALL.map(|level| level.name.to_owned()))]
    levels: Vec<String>,
    /// Every level plays every other, not the next one only
    #[arg(long)]
    round_robin: bool,
    /// Racks of each pairing; the players break in turn
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    racks: u32,
    /// Decides every rack and every error of a hand
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Threads; without this option one for each processor. They change nothing but the time
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Preset to play with; without this option the one that the game is played with
    #[arg(long, value_name = "NAME|FILE")]
    preset: Option<String>,
    /// Write the result as one JSON object
    #[arg(long)]
    json: bool,
}

/// Plays the tournament and prints the table.
pub(super) fn run(options: &TournamentOptions) -> Result<(), CommandError> {
    let game = game(&options.game)?;
    let levels = levels(&options.levels)?;
    let equipment = options
        .preset
        .as_deref()
        .unwrap_or(game.rules().code().equipment);
    let like = preset::open(equipment)?.equipment.scene();
    let pairs = pairs(levels.len(), options.round_robin);
    let racks = options.racks as usize;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.map_or(0, usize::from))
        .build()
        .map_err(|error| CommandError::Unfinished(format!("threads: {error}")))?;
    let bar = progress_bar(pairs.len() * racks);
    let begun = Instant::now();
    let results: Vec<Result<(Rack, Duration), ContestError>> = pool.install(|| {
        (0..pairs.len() * racks)
            .into_par_iter()
            .map(|job| {
                let (pair, rack) = (pairs[job / racks], job % racks);
                let begun = Instant::now();
                let played = play(
                    &game,
                    [&levels[pair.0], &levels[pair.1]],
                    rack,
                    &like,
                    options.seed,
                );
                bar.inc(1);
                played.map(|rack| (rack, begun.elapsed()))
            })
            .collect()
    });
    bar.finish_and_clear();
    let mut standings = Standings::new(game.rules().code().name, equipment, options.seed);
    let mut busy = Duration::ZERO;
    for (pair, results) in pairs.iter().zip(results.chunks(racks)) {
        let mut pairing = Pairing::new(&levels[pair.0], &levels[pair.1]);
        for (rack, result) in results.iter().enumerate() {
            match result {
                Ok((rack, time)) => {
                    pairing.add(rack);
                    busy += *time;
                }
                Err(error) => {
                    let names = (levels[pair.0].name, levels[pair.1].name);
                    say(&format!(
                        "masse: {} against {}, rack {rack}: {error}",
                        names.0, names.1
                    ));
                    pairing.unfinished += 1;
                }
            }
        }
        standings.pairings.push(pairing);
    }
    let strokes: u32 = standings.pairings.iter().map(Pairing::shots).sum();
    to_stdout(|out| {
        if options.json {
            serde_json::to_writer_pretty(&mut *out, &standings)?;
            writeln!(out)
        } else {
            write!(out, "{}", standings.text())
        }
    })?;
    say(&format!(
        "{} racks, {strokes} strokes in {:.1} s; {:.1} ms a stroke on one thread",
        pairs.len() * racks,
        begun.elapsed().as_secs_f64(),
        1e3 * busy.as_secs_f64() / f64::from(strokes.max(1)),
    ));
    Ok(())
}

fn play(
    game: &Game,
    levels: [&Level; 2],
    rack: usize,
    like: &Scene,
    seed: u64,
) -> Result<Rack, ContestError> {
    // The same racks for every pairing, however many are played.
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(rack as u64);
    play_rack(game, levels, rack % 2, like, rng.random())
}

fn game(name: &str) -> Result<Game, CommandError> {
    let contest = |game: &Game| !matches!(game, Game::FreePractice(_));
    Game::named(name).filter(contest).ok_or_else(|| {
        let all = Game::all();
        let contests = all.iter().filter(|game| contest(game));
        let names: Vec<&str> = contests.map(|game| game.rules().code().name).collect();
        CommandError::Usage(format!(
            "--game {name}: no such game; there are {}",
            names.join(", ")
        ))
    })
}

fn levels(names: &[String]) -> Result<Vec<Level>, CommandError> {
    let levels: Option<Vec<Level>> = names.iter().map(|name| Level::named(name)).collect();
    match levels {
        Some(levels) if levels.len() >= 2 => Ok(levels),
        Some(_) => Err(CommandError::Usage(
            "--levels: at least two are needed".to_owned(),
        )),
        None => {
            let known = Level::ALL.map(|level| level.name).join(", ");
            let given = names.join(",");
            Err(CommandError::Usage(format!(
                "--levels {given}: there are {known}"
            )))
        }
    }
}

/// Index of the stronger and the weaker level of every pairing.
fn pairs(levels: usize, all: bool) -> Vec<(usize, usize)> {
    (1..levels)
        .flat_map(|strong| {
            let from = if all { 0 } else { strong - 1 };
            (from..strong).rev().map(move |weak| (strong, weak))
        })
        .collect()
}

fn progress_bar(racks: usize) -> ProgressBar {
    let bar = ProgressBar::new(racks as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} racks, {eta} left") {
        bar.set_style(style);
    }
    bar
}
