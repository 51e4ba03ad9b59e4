//! Films: frames from the software driver, in order, of what the record says; and both halves of a shared picture.

use std::io;

use glam::DVec3;
use masse::game::settings::Quality;
use masse::game::view::{Beside, CameraMode};
use masse::physics::exact::{Limits, solve};
use masse::physics::record::Record;
use masse::scenarios::file::Scenario;
use masse::scenarios::library;
use masse::window::film::{Film, FilmError};
use masse::window::seats;
use masse::window::snapshot::picture;

const SIZE: (u32, u32) = (320, 160);

fn shot(name: &str) -> (Scenario, Record) {
    let scenario = library::open(name).expect("it is built in");
    let record = solve(&scenario.scene, Limits::default()).expect("it can be played");
    (scenario, record)
}

fn film<'a>(scenario: &'a Scenario, record: &'a Record) -> Film<'a> {
    Film {
        scene: &scenario.scene,
        record,
        size: SIZE,
        fps: 2.0,
        slow: 1.0,
        span: (0.0, Some(1.5)),
        camera: CameraMode::Overhead,
        cameras: seats(scenario),
        beside: Beside::Nothing,
        trails: false,
        quality: Quality::Low,
    }
}

fn frames(film: &Film) -> Vec<Vec<u8>> {
    let mut frames = Vec::new();
    let count = film.take(|number, of, pixels| {
        assert_eq!(number as usize, frames.len() + 1);
        assert_eq!(of, 4);
        assert_eq!(pixels.len() as u32, 4 * SIZE.0 * SIZE.1);
        frames.push(pixels);
        Ok(())
    });
    assert_eq!(count.expect("a software driver is enough to draw with"), 4);
    frames
}

/// Least of red, green and blue of the lightest pixel within two of a place.
fn lightest(frame: &[u8], (x, y): (u32, u32)) -> u8 {
    let around = (x.saturating_sub(2)..=x + 2)
        .flat_map(|x| (y.saturating_sub(2)..=y + 2).map(move |y| (x, y)));
    let inside = around.filter(|(x, y)| *x < SIZE.0 && *y < SIZE.1);
    let least = inside.map(|(x, y)| {
        let at = 4 * (y * SIZE.0 + x) as usize;
        frame[at..at + 3].iter().copied().min().unwrap_or(0)
    });
    least.max().unwrap_or(0)
}

#[test]
fn every_frame_shows_the_cue_ball_where_the_record_has_it_then() {
    let (scenario, record) = shot("draw-back");
    let frames = frames(&film(&scenario, &record));
    let still = picture(&scenario.scene, SIZE, CameraMode::Overhead, &[]);
    let still = still.expect("a software driver is enough to draw with");
    let cue = scenario.scene.ball_named("cue").expect("there is one");
    let at = |frame: usize| {
        let place = record.state_at(cue, 0.5 * frame as f64).position;
        let top = DVec3::new(place.x, 2.0 * place.y, place.z);
        still.pixel_of(top).expect("it is in the picture")
    };
    assert!(at(0) != at(1) && at(1) != at(3), "it moves");
    for (number, frame) in frames.iter().enumerate() {
        let here = lightest(frame, at(number));
        assert!(here > 120, "frame {number}: {here} at {:?}", at(number));
    }
    // And not where it is in another frame.
    let there = lightest(&frames[0], at(3));
    assert!(there < 120, "{there}");
    // Once more is the same film.
    assert_eq!(self::frames(&film(&scenario, &record)), frames);
}

/// Pixels in which the two halves of a frame differ by more than dither and the edges of one grid on another.
fn between_halves(frame: &[u8]) -> usize {
    let half = SIZE.0 / 2 - 2;
    let pixels = (0..SIZE.1).flat_map(|y| (0..half).map(move |x| (x, y)));
    let green = |x: u32, y: u32| frame[4 * (y * SIZE.0 + x) as usize + 1];
    pixels
        .filter(|(x, y)| green(*x, *y).abs_diff(green(x + half + 4, *y)) > 40)
        .count()
}

#[test]
fn other_laws_begin_alike_and_part_and_two_cameras_never_are() {
    let (scenario, record) = shot("real-draw-english");
    let laws = frames(&Film {
        beside: Beside::Laws,
        ..film(&scenario, &record)
    });
    let apart: Vec<usize> = laws.iter().map(|frame| between_halves(frame)).collect();
    assert_eq!(apart[0], 0, "the same table in the same light: {apart:?}");
    assert!(apart[3] > 6, "other laws: {apart:?}");

    let cameras = frames(&Film {
        beside: Beside::Camera(CameraMode::Follow),
        ..film(&scenario, &record)
    });
    assert!(between_halves(&cameras[0]) > 1000);
    assert_ne!(cameras[0], cameras[3]);
}

#[test]
fn a_frame_that_cannot_be_kept_ends_the_film() {
    let (scenario, record) = shot("stop-shot");
    let ended = film(&scenario, &record).take(|_, _, _| Err(io::Error::other("full")));
    assert!(matches!(ended, Err(FilmError::Kept(_))), "{ended:?}");
}
