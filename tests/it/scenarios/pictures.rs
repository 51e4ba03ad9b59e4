//! Diagrams: before the shot and after it, as SVG and as PNG.

use super::command_line;
use masse::physics::exact::{self, Limits};
use masse::report::picture::{Style, draw, draw_as, draw_set_up};
use masse::report::raster;
use masse::scenarios::library;
use resvg::tiny_skia::Pixmap;

#[test]
fn a_diagram_has_ghosts_numbers_and_colours_of_motion() {
    let shot = library::open("jump-shot").unwrap_or_else(|error| panic!("{error}"));
    let record = exact::solve(&shot.scene, Limits::default()).expect("a sound scene");
    let plain = draw(&shot.title, &shot.scene, &record);
    let diagram = draw_as(&shot.title, &shot.scene, &record, Style::DIAGRAM);
    for part in [
        "id=\"ghosts\"",
        "id=\"numbers\"",
        "flies",
        "slides",
        "cue lands",
        "cue meets 1",
    ] {
        assert!(diagram.contains(part) && !plain.contains(part), "{part}");
    }
    // As many numbers as events that are told; the cue ball's two hits with the 1 give it two ghosts.
    assert!(diagram.contains("the cue strikes cue"));
    let ghosts = diagram.split("id=\"ghosts\"").nth(1).expect("ghosts");
    let ghosts = ghosts.split("</g>").next().expect("their end");
    assert!(ghosts.matches("<circle").count() >= 2, "{ghosts}");
}

#[test]
fn a_scene_is_drawn_before_its_shot() {
    let shot = library::open("throw").unwrap_or_else(|error| panic!("{error}"));
    let before = draw_set_up(&shot.title, &shot.scene);
    assert!(before.contains("id=\"shot\"") && before.contains("speed of the cue 0.81 m/s"));
    assert!(!before.contains("id=\"paths\""));
    let mut still = shot.scene;
    still.shot = None;
    assert!(draw_set_up("t", &still).contains("2 balls, no shot"));
}

#[test]
fn a_png_has_the_pixels_of_the_picture() {
    let shot = library::open("stop-shot").unwrap_or_else(|error| panic!("{error}"));
    let svg = draw_set_up(&shot.title, &shot.scene);
    let png = raster::png(&svg, 800).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(png, raster::png(&svg, 800).expect("again"));
    let pixels = Pixmap::decode_png(&png).expect("a PNG");
    assert_eq!(pixels.width(), 800);
    let green = |x: u32, y: u32| {
        let pixel = pixels.pixel(x, y).expect("inside");
        pixel.green() > pixel.red() && pixel.green() > pixel.blue()
    };
    assert!(
        green(300, pixels.height() / 2),
        "the middle of the table is green"
    );
    // The title is written: something bright stands in its line.
    let bright = (0..200).any(|x| pixels.pixel(16 + x, 14).is_some_and(|p| p.red() > 150));
    assert!(bright, "the title can be read");
    assert!(raster::png(&svg, 3).is_err() && raster::png("<svg", 100).is_err());
}

#[test]
fn the_command_draws_scenes_and_records() {
    let svg = command_line::file("pictures", "x", "").with_file_name("p.svg");
    let (png, jsonl) = (svg.with_file_name("p.png"), svg.with_file_name("p.jsonl"));
    let path = |of: &std::path::Path| of.display().to_string();
    let run = command_line::masse(&["run", "-q", "cradle", "--out", &path(&jsonl)]);
    assert_eq!(run.status.code(), Some(0));
    for (arguments, file) in [
        (vec!["picture", "cradle", "", "--diagram"], &svg),
        (
            vec!["picture", "cradle", "", "--before", "--width", "500"],
            &png,
        ),
        (vec!["picture", "JSONL", "", "--numbers"], &png),
    ] {
        let (file, jsonl) = (path(file), path(&jsonl));
        let arguments: Vec<&str> = arguments
            .iter()
            .map(|argument| match *argument {
                "" => file.as_str(),
                "JSONL" => jsonl.as_str(),
                other => other,
            })
            .collect();
        let drawn = command_line::masse(&arguments);
        assert_eq!(
            drawn.status.code(),
            Some(0),
            "{}",
            command_line::text(&drawn.stderr)
        );
    }
    assert!(std::fs::read(&png).expect("a file").starts_with(b"\x89PNG"));
    let wide = command_line::masse(&["picture", "cradle", &path(&png), "--width", "1000000"]);
    assert_eq!(wide.status.code(), Some(2));
}
