//! Draws a racked table without a window:
//! `cargo run --release --example look -- picture.png orbit 1280 720 turn lift zoom right away scene`, with turn and lift in
//! degrees, zoom in powers of e, right and away in metres, another scene if one is named, and settings as in their file:
//! `'(quality: Ultra, table: BarBox, cloth: Blue)'`.

use bevy::math::Vec2;
use masse::game::settings::Settings;
use masse::game::view::{CameraInput, CameraMode};
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::{Rack, Scene};
use masse::physics::table::Preset;
use masse::scenarios::library;
use masse::window::snapshot::picture_with;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let word = |i: usize, or: &str| arguments.get(i).cloned().unwrap_or_else(|| or.to_owned());
    let camera = match word(1, "behind").as_str() {
        "overhead" => CameraMode::Overhead,
        "orbit" => CameraMode::Orbit,
        _ => CameraMode::BehindCue,
    };
    let size = (word(2, "1280").parse()?, word(3, "720").parse()?);
    let number = |i: usize| word(i, "0").parse::<f32>();
    let input = CameraInput {
        orbit: Vec2::new(number(4)?.to_radians(), number(5)?.to_radians()),
        zoom: number(6)?,
        pan: Vec2::new(number(7)?, number(8)?),
    };
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    Rack::EightBall.place(&mut scene, Ball::POOL, 0.0, 1);
    if let Some(name) = arguments.get(9).filter(|name| !name.is_empty()) {
        scene = library::open(name)?.scene;
    }
    let settings: Settings = ron::from_str(&word(10, "()"))?;
    let picture = picture_with(&scene, size, camera, &[input], &settings)?;
    image::save_buffer(
        word(0, "table.png"),
        &picture.pixels,
        picture.width,
        picture.height,
        image::ColorType::Rgba8,
    )?;
    Ok(())
}
