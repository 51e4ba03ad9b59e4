//! `masse film`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use crate::cli::{CommandError, say};
use crate::game::view::CameraMode;
use crate::scenarios::library;
use crate::sim::play::play;

/// Frames that the numbers in the names of files have room for.
const MOST: f64 = 99_999.0;

/// What to film, and how.
#[derive(Args, Debug)]
pub(super) struct FilmOptions {
    /// Built-in scene, scene file or shared text
    scene: String,
    /// Folder for the frames, frame-00001.png and on; made if it is not there, refused if it is not empty
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Frames in a second of the film
    #[arg(long, default_value_t = 30.0, value_parser = within(1.0, 240.0))]
    fps: f64,
    /// Width and height in pixels
    #[arg(long, default_value = "1280x720", value_parser = size)]
    size: (u32, u32),
    /// From where it is seen: overhead, behind, free, follow, or the number of a camera of the scene; without it the
    /// first of the scene
    #[arg(long, value_name = "CAMERA")]
    camera: Option<String>,
    /// A second camera for the other half of the picture
    #[arg(long, value_name = "CAMERA", conflicts_with = "other_laws")]
    second: Option<String>,
    /// The same stroke by other laws in the other half: the model of the coursework beside real physics
    #[arg(long)]
    other_laws: bool,
    /// How many times slower than life
    #[arg(long, default_value_t = 1.0, value_parser = within(0.1, 100.0))]
    slow: f64,
    /// Time of the shot at which the film begins, s
    #[arg(long, default_value_t = 0.0, value_parser = within(0.0, 3600.0))]
    from: f64,
    /// Time of the shot at which it ends, s; without it when all balls rest
    #[arg(long, value_parser = within(0.0, 3600.0))]
    to: Option<f64>,
    /// Draw the paths
    #[arg(long)]
    trails: bool,
    /// How much work a frame may be; without it what suits the graphics adapter
    #[arg(long)]
    quality: Option<Work>,
}

/// How much work a frame may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Work {
    Low,
    Medium,
    High,
    Ultra,
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once(['x', 'X']).and_then(|(width, height)| {
        let side = |text: &str| text.trim().parse::<u32>().ok();
        Some((side(width)?, side(height)?))
    });
    let fits = |side: &u32| (64..=8192).contains(side);
    sides
        .filter(|(width, height)| fits(width) && fits(height))
        .ok_or_else(|| {
            "width x height in pixels, each from 64 to 8192, such as 1280x720".to_owned()
        })
}

/// A number between two ends.
fn within(least: f64, most: f64) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    move |text| {
        let number = text.parse::<f64>().ok();
        number
            .filter(|number| (least..=most).contains(number))
            .ok_or_else(|| format!("a number from {least} to {most}"))
    }
}

/// The camera that a person calls by this name.
fn camera(option: &str, name: &str, of_scene: usize) -> Result<CameraMode, CommandError> {
    let numbered = || {
        let place = name.parse::<usize>().ok()?.checked_sub(1)?;
        (place < of_scene).then_some(CameraMode::Scene(place))
    };
    let mode = match name {
        "overhead" => Some(CameraMode::Overhead),
        "behind" => Some(CameraMode::BehindCue),
        "free" => Some(CameraMode::Orbit),
        "follow" => Some(CameraMode::Follow),
        _ => numbered(),
    };
    mode.ok_or_else(|| {
        CommandError::Usage(format!(
            "{option} {name}: cameras are overhead, behind, free, follow, and 1 to {of_scene} of this scene"
        ))
    })
}

/// An empty folder for the frames.
fn folder(path: &Path) -> Result<(), CommandError> {
    let write = |source| CommandError::Write {
        to: path.display().to_string(),
        source,
    };
    if path.exists() && !path.is_dir() {
        return Err(CommandError::Usage(format!(
            "--out {}: this is a file, a folder is needed",
            path.display()
        )));
    }
    fs::create_dir_all(path).map_err(write)?;
    if fs::read_dir(path).map_err(write)?.next().is_some() {
        return Err(CommandError::Usage(format!(
            "--out {}: the folder is not empty: frames of two films would be mixed",
            path.display()
        )));
    }
    // Better now than after the first frame.
    tempfile::tempfile_in(path).map(drop).map_err(write)
}

/// Plays a scene, draws it frame by frame without a window, and writes the frames.
pub(super) fn run(options: &FilmOptions) -> Result<ExitCode, CommandError> {
    let scenario = library::open(&options.scene)?;
    if scenario.scene.solver.is_crowd() {
        return Err(CommandError::Usage(format!(
            "{}: a crowd is counted and not recorded, so that it cannot be filmed",
            options.scene
        )));
    }
    if options.to.is_some_and(|to| to < options.from) {
        return Err(CommandError::Usage(
            "--to: the film would end before it begins".to_owned(),
        ));
    }
    let count = scenario.cameras.len();
    let named = |option, name: &Option<String>| {
        let mode = name.as_deref().map(|name| camera(option, name, count));
        mode.transpose()
    };
    let cameras = (
        named("--camera", &options.camera)?,
        named("--second", &options.second)?,
    );
    let record = play(&scenario.scene)?;
    let end = options.to.unwrap_or(record.end_time);
    let frames = (end - options.from) * options.fps * options.slow;
    if frames > MOST {
        return Err(CommandError::Usage(format!(
            "{frames:.0} frames are more than {MOST}: set --from and --to, or a smaller --fps or --slow"
        )));
    }
    folder(&options.out)?;
    let count = drawing::draw(options, &scenario, &record, cameras)?;
    let (folder, plural) = (options.out.display(), if count == 1 { "" } else { "s" });
    say(&format!("masse: {count} frame{plural} in {folder}"));
    Ok(ExitCode::SUCCESS)
}

#[cfg(not(feature = "window"))]
mod drawing {
    //! A build without a window cannot draw.

    use super::{CameraMode, FilmOptions};
    use crate::cli::CommandError;
    use crate::physics::record::Record;
    use crate::scenarios::file::Scenario;

    pub(super) fn draw(
        _: &FilmOptions,
        _: &Scenario,
        _: &Record,
        _: (Option<CameraMode>, Option<CameraMode>),
    ) -> Result<u32, CommandError> {
        let reason = "this is a build without a window, which cannot draw";
        Err(CommandError::NoDisplay(reason.to_owned()))
    }
}

#[cfg(feature = "window")]
mod drawing {
    //! Frames become files.

    use std::io;

    use image::{ExtendedColorType, ImageFormat, write_buffer_with_format};
    use indicatif::{ProgressBar, ProgressStyle};

    use super::{CameraMode, FilmOptions, Work};
    use crate::cli::CommandError;
    use crate::game::settings::Quality;
    use crate::game::view::Beside;
    use crate::kept;
    use crate::physics::record::Record;
    use crate::scenarios::file::Scenario;
    use crate::window::film::{Film, FilmError};

    pub(super) fn draw(
        options: &FilmOptions,
        scenario: &Scenario,
        record: &Record,
        (first, second): (Option<CameraMode>, Option<CameraMode>),
    ) -> Result<u32, CommandError> {
        let (width, height) = options.size;
        let cameras = crate::window::seats(scenario);
        // What every table has is not a camera of its own.
        let plain = |mode| match mode {
            CameraMode::Scene(place) => cameras.mode(place).unwrap_or(mode),
            mode => mode,
        };
        let first = match first {
            Some(mode) => plain(mode),
            None => cameras.mode(0).unwrap_or(CameraMode::Overhead),
        };
        let beside = match second {
            Some(mode) => Beside::Camera(plain(mode)),
            None if options.other_laws => Beside::Laws,
            None => Beside::Nothing,
        };
        let film = Film {
            scene: &scenario.scene,
            record,
            size: options.size,
            fps: options.fps,
            slow: options.slow,
            span: (options.from, options.to),
            camera: first,
            cameras,
            beside,
            trails: options.trails,
            quality: match options.quality {
                None => Quality::Automatic,
                Some(Work::Low) => Quality::Low,
                Some(Work::Medium) => Quality::Medium,
                Some(Work::High) => Quality::High,
                Some(Work::Ultra) => Quality::Ultra,
            },
        };
        let bar = ProgressBar::new(0);
        let style = "{elapsed_precise} {bar:40} {pos} of {len} frames, {eta} to go";
        if let Ok(style) = ProgressStyle::with_template(style) {
            bar.set_style(style);
        }
        let taken = film.take(|number, of, pixels| {
            bar.set_length(u64::from(of));
            let path = options.out.join(format!("frame-{number:05}.png"));
            let colours: Vec<u8> = pixels
                .chunks_exact(4)
                .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
                .collect();
            let (mut packed, colour) = (io::Cursor::new(Vec::new()), ExtendedColorType::Rgb8);
            write_buffer_with_format(
                &mut packed,
                &colours,
                width,
                height,
                colour,
                ImageFormat::Png,
            )
            .map_err(io::Error::other)
            .and_then(|()| kept::write(&path, packed.get_ref()))
            .map_err(|error| io::Error::other(format!("{}: {error}", path.display())))?;
            bar.set_position(u64::from(number));
            Ok(())
        });
        bar.finish_and_clear();
        taken.map_err(|error| match error {
            FilmError::Kept(source) => CommandError::Write {
                to: options.out.display().to_string(),
                source,
            },
            FilmError::Twin(_) => CommandError::Unfinished(error.to_string()),
            FilmError::NoDisplay(_) | FilmError::Lost { .. } => {
                CommandError::NoDisplay(error.to_string())
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_two_whole_numbers_that_a_graphics_card_can_draw() {
        assert_eq!(size("1280x720"), Ok((1280, 720)));
        assert_eq!(size("64X8192"), Ok((64, 8192)));
        for bad in [
            "",
            "1280",
            "x",
            "1280x",
            "0x0",
            "63x64",
            "8193x64",
            "-5x100",
            "1e3x1e3",
            "100x100x100",
        ] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_lie_between_their_ends() {
        let fps = within(1.0, 240.0);
        assert_eq!(fps("29.97"), Ok(29.97));
        for bad in ["0", "241", "NaN", "inf", "-1", "thirty"] {
            assert!(fps(bad).is_err(), "{bad}");
        }
    }
}
