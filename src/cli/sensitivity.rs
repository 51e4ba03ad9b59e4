//! `masse sensitivity`.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::cli::{CommandError, say, to_file, to_stdout};
use crate::report::heat_map::{self, HeatMap};
use crate::scenarios::dial::Dial;
use crate::scenarios::file::Scenario;
use crate::scenarios::library;
use crate::scenarios::sensitivity::{self, Edge, Room, in_four_digits};

/// Values each way of a map.
const CELLS: usize = 81;

/// What to vary, and how to tell it.
#[derive(Args, Debug)]
pub(super) struct SensitivityOptions {
    /// Built-in scene, scene file or shared text, with expectations
    scene: String,
    /// Two numbers of the stroke to vary together: heading, speed, side, height, elevation
    #[arg(long, value_name = "A,B", value_parser = pair, default_value = "heading,speed")]
    over: (Dial, Dial),
    /// File for the map over these two numbers, in SVG
    #[arg(long, value_name = "FILE.svg")]
    out: Option<PathBuf>,
    /// Write the table as JSON lines
    #[arg(long)]
    json: bool,
}

fn pair(text: &str) -> Result<(Dial, Dial), String> {
    let dial = |name: &str| {
        let mut dials = Dial::ALL.into_iter();
        dials.find(|dial| dial.name() == name.trim())
    };
    let named = text
        .split_once(',')
        .and_then(|(a, b)| Some((dial(a)?, dial(b)?)));
    named.filter(|(a, b)| a != b).ok_or_else(|| {
        "two of heading, speed, side, height, elevation, such as heading,speed".to_owned()
    })
}

/// Tells how far each number of a stroke may be turned, and draws the map if asked for.
pub(super) fn run(options: &SensitivityOptions) -> Result<ExitCode, CommandError> {
    let scenario = library::open(&options.scene)?;
    let refused = |error: sensitivity::SensitivityError| {
        CommandError::Usage(format!("{}: {error}", options.scene))
    };
    let rooms = match sensitivity::sensitivity(&scenario) {
        Ok(rooms) => rooms,
        Err(sensitivity::SensitivityError::Misses { expectation }) => {
            say(&format!(
                "masse: {}: the shot as it is misses expectation {expectation}: {:?}",
                options.scene, scenario.expect[expectation]
            ));
            return Ok(ExitCode::from(1));
        }
        Err(error) => return Err(refused(error)),
    };
    to_stdout(|out| {
        rooms.iter().try_for_each(|room| {
            if options.json {
                writeln!(out, "{}", json(room))
            } else {
                writeln!(out, "{}", line(room, &scenario))
            }
        })
    })?;
    if let Some(path) = &options.out {
        let map = sensitivity::map(&scenario, options.over, CELLS).map_err(refused)?;
        let value = |dial: Dial| {
            rooms
                .iter()
                .find(|room| room.dial == dial)
                .map_or(0.0, |r| r.value)
        };
        let text = heat_map::draw(&HeatMap {
            title: &scenario.title,
            across: (map.across.name(), map.across.unit()),
            along: (map.along.name(), map.along.unit()),
            columns: &map.columns,
            rows: &map.rows,
            misses: &map.misses,
            shot: (value(map.across), value(map.along)),
        });
        to_file(path, text.as_bytes())?;
    }
    Ok(ExitCode::SUCCESS)
}

fn line(room: &Room, scenario: &Scenario) -> String {
    let side = |edge: &Edge, sign: &str| {
        let why = match edge.fails {
            Some(fails) => {
                let wanted = scenario.expect.get(fails).map(ToString::to_string);
                format!("then not: {}", wanted.unwrap_or_default())
            }
            None => "its stop".to_owned(),
        };
        format!("{sign}{} ({why})", in_four_digits(edge.by))
    };
    format!(
        "{:9} {:>10} {:7}  {}  {}",
        room.dial.name(),
        in_four_digits(room.value),
        room.dial.unit(),
        side(&room.below, "-"),
        side(&room.above, "+"),
    )
}

fn json(room: &Room) -> serde_json::Value {
    let edge = |edge: &Edge| serde_json::json!({ "by": edge.by, "fails": edge.fails });
    serde_json::json!({
        "dial": room.dial.name(),
        "unit": room.dial.unit(),
        "value": room.value,
        "below": edge(&room.below),
        "above": edge(&room.above),
    })
}
