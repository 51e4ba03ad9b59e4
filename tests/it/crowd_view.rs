//! Crowds on the screen: what the one draw of all balls shows, from the software driver.

use bevy::math::Vec2;
use glam::DVec3;

use masse::game::view::{CameraInput, CameraMode};
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::window::NoDisplay;
use masse::window::snapshot::{Picture, picture};

/// A ball without spin, so without markings.
const SMOOTH: Ball = Ball {
    spins: false,
    ..Ball::POOL
};

/// A small box with these balls at x, z, each with its speed in m/s.
fn scene(balls: &[(f64, f64, f64)]) -> Scene {
    let table = Preset::Box {
        length: 0.8,
        width: 0.4,
    };
    let mut scene = Scene::new(table.table(), Laws::ideal());
    for (i, &(x, z, speed)) in balls.iter().enumerate() {
        let ball = scene.place(&i.to_string(), SMOOTH, x, z);
        scene.balls[ball].state.velocity.x = speed;
    }
    scene.solver = Solver::Stepped(Stepped {
        crowd: true,
        grid: None,
        ..Stepped::default()
    });
    scene
}

/// The picture, or none where there is nothing to draw with.
fn drawn(scene: &Scene, camera: CameraMode, input: &[CameraInput]) -> Option<Picture> {
    match picture(scene, (640, 360), camera, input) {
        Ok(picture) => Some(picture),
        Err(NoDisplay::Adapter) => {
            println!("there is no adapter to draw with, not even a software driver");
            None
        }
        Err(error) => panic!("{error}"),
    }
}

fn colour_at(picture: &Picture, point: DVec3) -> [f64; 3] {
    let pixel = picture
        .pixel_of(point)
        .unwrap_or_else(|| panic!("{point} is not in the picture"));
    picture.colour(pixel).map(f64::from)
}

fn is_cloth([red, green, blue]: [f64; 3]) -> bool {
    green > 1.8 * red && green > blue && blue > red
}

#[test]
fn every_sphere_covers_its_disc_and_no_more() {
    let balls = [(-0.25, 0.1, 1.0), (0.0, -0.05, 0.0), (0.2, 0.08, 0.0)];
    let Some(picture) = drawn(&scene(&balls), CameraMode::Overhead, &[]) else {
        return;
    };
    let radius = SMOOTH.radius;
    for (x, z, _) in balls {
        let center = DVec3::new(x, radius, z);
        for step in 0..12 {
            let angle = 0.1 + f64::from(step) * std::f64::consts::TAU / 12.0;
            let way = radius * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
            let inside = colour_at(&picture, center + 0.85 * way);
            let outside = colour_at(&picture, center + 1.2 * way);
            assert!(!is_cloth(inside), "{inside:?} at {angle} of {center}");
            assert!(is_cloth(outside), "{outside:?} at {angle} of {center}");
            assert!(
                inside.into_iter().fold(0.0, f64::max) > 40.0,
                "{inside:?} is black"
            );
        }
    }
}

/// From the front and above, where no cushion is in the way.
fn front() -> CameraInput {
    CameraInput {
        orbit: Vec2::new(-0.5, -0.17),
        ..CameraInput::default()
    }
}

#[test]
fn light_comes_from_above() {
    let scene = scene(&[(0.0, 0.0, 1.0)]);
    let Some(picture) = drawn(&scene, CameraMode::Orbit, &[front()]) else {
        return;
    };
    let at = |normal: DVec3| {
        let center = DVec3::new(0.0, SMOOTH.radius, 0.0);
        let colour = colour_at(&picture, center + SMOOTH.radius * normal.normalize());
        colour.into_iter().sum::<f64>()
    };
    let upper = at(DVec3::new(0.5, 0.8, 0.4));
    let lower = at(DVec3::new(0.5, -0.2, 0.8));
    assert!(upper > 1.2 * lower && lower > 30.0, "{upper} {lower}");
}

/// One ball stands before another and hides it, whichever is drawn first. They are told by their speeds: a slow ball is
/// blue, a fast one is not.
#[test]
fn the_nearer_ball_hides_the_farther_whatever_their_order() {
    let (near, far) = (0.05, -0.008);
    for fast_is_near in [true, false] {
        for first_is_near in [true, false] {
            let (near_speed, far_speed) = if fast_is_near { (1.0, 0.0) } else { (0.0, 1.0) };
            let mut balls = [(0.0, near, near_speed), (0.0, far, far_speed)];
            if !first_is_near {
                balls.reverse();
            }
            let Some(picture) = drawn(&scene(&balls), CameraMode::Orbit, &[front()]) else {
                return;
            };
            // A point of the near ball before the middle of the far one, beside the mirrored lamps.
            let normal = DVec3::new(0.5, 0.68, 0.54);
            let center = DVec3::new(0.0, SMOOTH.radius, near);
            let [red, green, blue] = colour_at(&picture, center + SMOOTH.radius * normal);
            let is_blue = blue > 1.3 * green && blue > red;
            assert_eq!(
                is_blue, !fast_is_near,
                "{red} {green} {blue}, fast is near: {fast_is_near}, first is near: {first_is_near}"
            );
        }
    }
}
