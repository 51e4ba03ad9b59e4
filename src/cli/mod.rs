//! The command line.

mod crowd;
mod film;
mod judge;
mod laws;
mod list;
mod picture;
mod play;
mod report;
mod rules;
mod run;
mod scene_options;
mod sensitivity;
mod share;
mod solve;
mod sweep;
mod tournament;
mod write;

pub use play::fallback;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::{Parser, Subcommand};
use thiserror::Error;

use crate::kept;
use crate::physics::scene::SceneError;
use crate::report::record_file::RecordFileError;
use crate::scenarios::file::FileError;
use crate::scenarios::library::OpenError;
use crate::scenarios::share::ShareError;
use crate::sim::play::Stopped;
use film::FilmOptions;
use judge::JudgeOptions;
use laws::LawsOptions;
use picture::PictureOptions;
use report::ReportOptions;
use run::RunOptions;
use sensitivity::SensitivityOptions;
use solve::SolveOptions;
use sweep::SweepOptions;
use tournament::TournamentOptions;

/// Massé: a billiards game and simulator.
#[derive(Parser, Debug)]
#[command(
    name = "masse",
    version,
    about = "Massé: a billiards game and simulator",
    long_about = "Massé is a billiards game and simulator.\n\n\
        Without a command it opens a window with a racked table: aim with the mouse, shoot with the space bar; F1 shows \
        every key. `masse run` plays a scene without a window and writes everything that happens as text. Where there is \
        no display, `masse` runs the break without a window and draws a picture of it.",
    after_long_help = "EXAMPLES\n  \
        masse                                        play\n  \
        masse play draw-back                         play, beginning with a scene\n  \
        masse list                                   name the scenes that are built in\n  \
        masse run break-nine                         write the events of a break as JSON lines\n  \
        masse run break-nine --picture break.svg -q  draw the paths and write nothing else\n  \
        masse run my.ron --solver stepped --tick 0.001 --out my.jsonl\n  \
        masse picture my.jsonl my.svg                draw a run that was written, without running it again\n  \
        masse film butterfly --out frames            numbered pictures of a shot for a video\n  \
        masse sweep follow --over speed=1:7:100      the same shot at a hundred speeds, as a table\n  \
        masse write gas gas.ron                      write a scene out in full, to change it\n  \
        masse tournament --racks 20                  computer against computer\n  \
        masse laws Han2005                           formula, paper, numbers and errors of a law\n  \
        masse judge                                  every law beside closed forms and experiments\n  \
        masse report --quick                         what each solver costs, and how far it is off\n  \
        masse write snooker my-table.ron             copy a preset, with the sources of its numbers\n  \
        masse play --preset my-table.ron             play with it; the game follows every change of the file\n  \
        masse run throw --preset heated_carom -q     the same shot with other equipment\n\n\
        RECORDS\n  \
        `masse run` writes a record: a line with the scene as it was, a line for each event, the paths that the events do\n  \
        not tell, and a summary. Every line is a JSON object. An event has: time in s, kind (strike, ball_ball, cushion,\n  \
        pocketed, motion), who (names of balls), impulse in N s, and the states of these balls before and after: position\n  \
        in m, velocity in m/s, spin in rad/s. x runs along the table to the foot, y up, z across. Numbers have all their\n  \
        digits; the same scene gives the same text.\n\n\
        EXIT CODES\n  \
        0  done\n  \
        1  `masse judge`: an exact judge misses; `masse run`: an expectation of the scene is missed;\n  \
           `masse solve`: nothing that meets them was found; `masse report`: a solver converges slower than demanded\n  \
        2  bad input: the message names the file, the place in it and the value; nothing is written\n  \
        3  a file cannot be written\n  \
        4  the solver could not finish the scene\n  \
        5  `masse film`: there is nothing to draw with; `masse`: the graphics driver failed"
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand, Debug)]
enum Command {
    /// Open the window and play
    Play {
        /// Built-in scene or scene file to begin with; without it a racked table
        scene: Option<String>,
        /// Preset to play with (see `masse list`), or a preset file, which may be edited while playing
        #[arg(long, value_name = "NAME|FILE")]
        preset: Option<String>,
        /// Print how long the start takes, phase by phase, and the memory; then end
        #[arg(long)]
        time_start: bool,
    },
    /// Run a scene without a window and write what happens as JSON lines
    Run(RunOptions),
    /// Search for a shot, or a layout, that does what is expected, and write it as a scene file
    Solve(SolveOptions),
    /// Tell how far each number of a stroke may vary before its shot fails, and draw a map over two of them
    Sensitivity(SensitivityOptions),
    /// Play a scene many times with other numbers, on all threads, and write a table with a row a shot
    Sweep(SweepOptions),
    /// Print a scene as a short text that can be pasted; every command that takes a scene takes the text too
    Share {
        /// Built-in scene or scene file
        scene: String,
    },
    /// Draw a scene, or a run that `masse run` wrote, which is not run again
    Picture(PictureOptions),
    /// Draw a shot frame by frame without a window, as the game does: numbered PNG files for a video
    Film(FilmOptions),
    /// Compare every law with closed forms and with experiments: tables and pictures
    Judge(JudgeOptions),
    /// Name the laws with their papers and their errors, or tell the formula and the numbers of one
    Laws(LawsOptions),
    /// Measure speed against error of every solver: tables and pictures
    Report(ReportOptions),
    /// Let the computer opponents play each other: win rates, pots, fouls, thought
    Tournament(TournamentOptions),
    /// Name the scenes, presets and cloths that are built in
    List,
    /// Name the games, or print the options of one and the code that they come from
    Rules {
        /// The game: 8-ball, 9-ball, 10-ball, 14.1, snooker, three-cushion, practice
        game: Option<String>,
    },
    /// Write out a scene in full, or a preset or a cloth with the sources of its numbers, to change it
    Write {
        /// Built-in scene, preset or cloth, or a scene file
        name: String,
        /// The file to write
        file: PathBuf,
    },
}

/// Why a command failed.
#[derive(Debug, Error)]
enum CommandError {
    /// No such scene, or a scene that is no good.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// A scene file that is no good.
    #[error(transparent)]
    File(#[from] FileError),
    /// A scene that cannot be shared.
    #[error(transparent)]
    Share(#[from] ShareError),
    /// A record file that is no good.
    #[error(transparent)]
    Record(#[from] RecordFileError),
    /// Options that make a scene unplayable.
    #[error("command line: {0}")]
    Options(#[from] SceneError),
    /// Options that do not fit each other.
    #[error("command line: {0}")]
    Usage(String),
    /// The solver gave up.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// What was begun could not be brought to an end.
    #[error("{0}")]
    Unfinished(String),
    /// There is nothing to draw with.
    #[error("{0}")]
    NoDisplay(String),
    /// Something cannot be written.
    #[error("{to}: cannot be written: {source}")]
    Write {
        /// The file, or the stream.
        to: String,
        /// What the system says.
        source: io::Error,
    },
}

impl CommandError {
    fn code(&self) -> u8 {
        match self {
            Self::Open(_)
            | Self::File(_)
            | Self::Share(_)
            | Self::Record(_)
            | Self::Options(_)
            | Self::Usage(_) => 2,
            Self::Write { .. } => 3,
            Self::Stopped(_) | Self::Unfinished(_) => 4,
            Self::NoDisplay(_) => 5,
        }
    }
}

/// Reads a command line, the name of the program first, without doing what it says: the exit code that it deserves, 0 if it
/// is one, or asks for help.
pub fn read(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    match Cli::try_parse_from(arguments) {
        Ok(_) => 0,
        Err(error) => u8::try_from(error.exit_code()).unwrap_or(2),
    }
}

/// Does what the arguments of the program say.
#[must_use]
pub fn main() -> ExitCode {
    let begun = Instant::now();
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // Whoever reads help through a pipe may stop reading.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let outcome = match cli.command {
        None => play::play(None, None, None),
        Some(Command::Play {
            scene,
            preset,
            time_start,
        }) => {
            let timed = time_start.then_some(begun);
            play::play(scene.as_deref(), preset.as_deref(), timed)
        }
        Some(Command::Run(options)) => run::run(&options),
        Some(Command::Solve(options)) => solve::run(&options),
        Some(Command::Sensitivity(options)) => sensitivity::run(&options),
        Some(Command::Sweep(options)) => sweep::run(&options),
        Some(Command::Share { scene }) => share::share(&scene).map(|()| ExitCode::SUCCESS),
        Some(Command::Picture(options)) => picture::draw(&options).map(|()| ExitCode::SUCCESS),
        Some(Command::Film(options)) => film::run(&options),
        Some(Command::Judge(options)) => judge::run(&options),
        Some(Command::Laws(options)) => laws::run(&options).map(|()| ExitCode::SUCCESS),
        Some(Command::Report(options)) => report::run(&options),
        Some(Command::Tournament(options)) => tournament::run(&options).map(|()| ExitCode::SUCCESS),
        Some(Command::List) => list::list().map(|()| ExitCode::SUCCESS),
        Some(Command::Rules { game }) => rules::rules(game.as_deref()).map(|()| ExitCode::SUCCESS),
        Some(Command::Write { name, file }) => {
            write::write(&name, &file).map(|()| ExitCode::SUCCESS)
        }
    };
    outcome.unwrap_or_else(|error| {
        say(&format!("masse: {error}"));
        ExitCode::from(error.code())
    })
}

/// A line for the person, apart from the results. Nobody listening is no error.
fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// Writes to the standard output. A reader that has gone away, as `head` does, has read enough: that is no error.
fn to_stdout(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CommandError> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => Err(CommandError::Write {
            to: "standard output".to_owned(),
            source,
        }),
        _ => Ok(()),
    }
}

/// Writes a whole file, or none: what was there before is lost only to what is whole.
fn to_file(path: &std::path::Path, text: &[u8]) -> Result<(), CommandError> {
    kept::write(path, text).map_err(|source| CommandError::Write {
        to: path.display().to_string(),
        source,
    })
}
