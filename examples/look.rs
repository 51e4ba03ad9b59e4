//! Draws a racked table without a window: `cargo run --release --example look -- picture.png overhead 1280 720`.

use masse::game::view::CameraMode;
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::{Rack, Scene};
use masse::physics::table::Preset;
use masse::window::snapshot::picture;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let word = |i: usize, or: &str| arguments.get(i).cloned().unwrap_or_else(|| or.to_owned());
    let camera = match word(1, "behind").as_str() {
        "overhead" => CameraMode::Overhead,
        "orbit" => CameraMode::Orbit,
        _ => CameraMode::BehindCue,
    };
    let size = (word(2, "1280").parse()?, word(3, "720").parse()?);
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    Rack::EightBall.place(&mut scene, Ball::POOL, 0.0, 1);
    let picture = picture(&scene, size, camera)?;
    image::save_buffer(
        word(0, "table.png"),
        &picture.pixels,
        picture.width,
        picture.height,
        image::ColorType::Rgba8,
    )?;
    Ok(())
}
