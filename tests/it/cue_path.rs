//! Where the cue has room: closed forms, and the distance of a cue made of many spheres.

use glam::{DVec2, DVec3};

use masse::physics::ball::Ball;
use masse::physics::cue::{Cue, Shot, Stick};
use masse::physics::cue_path::{Lift, Obstacle, lift, obstacle};
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

use crate::closeness::assert_close;

const R: f64 = Ball::POOL.radius;

/// A cue of the same thickness from end to end, with a sharp tip.
fn rod(width: f64) -> Cue {
    Cue {
        tip_radius: 0.0,
        stick: Stick {
            length: 1.473,
            tip_width: width,
            butt_width: width,
        },
        ..Cue::default()
    }
}

fn scene(table: Preset, balls: &[(f64, f64)]) -> Scene {
    let mut scene = Scene::new(table.table(), Laws::default());
    for (i, (x, z)) in balls.iter().enumerate() {
        scene.place(&i.to_string(), Ball::POOL, *x, *z);
    }
    scene
}

fn needed(scene: &Scene, shot: &Shot) -> Lift {
    lift(scene, 0, shot).expect("a steep cue is free")
}

/// A hall without cushions near enough to matter.
const HALL: Preset = Preset::Box {
    length: 20.0,
    width: 20.0,
};

#[test]
fn a_cue_over_a_ball_just_touches_it() {
    // A thin rod through the centre, the other ball d behind: it touches where d sin θ = R.
    for distance in [2.0 * R, 0.1, 0.2, 0.5] {
        let mut scene = scene(HALL, &[(0.0, 0.0), (-distance, 0.0)]);
        scene.cue = rod(1e-4);
        let found = needed(&scene, &Shot::default());
        let sine = (R + 0.5e-4) / distance;
        assert_close("sine", libm::sin(found.elevation), sine, 1e-8, "1");
        assert_eq!(found.over, Some(Obstacle::Ball(1)));
    }
    // Beyond the butt a ball is in nobody's way, nor in front, nor aside.
    for free in [(-1.6, 0.0), (0.3, 0.0), (-0.3, 0.1)] {
        let scene = scene(HALL, &[(0.0, 0.0), free]);
        assert_eq!(needed(&scene, &Shot::default()).over, None, "{free:?}");
    }
}

#[test]
fn follow_needs_less_and_a_thick_cue_more() {
    let scene = scene(HALL, &[(0.0, 0.0), (-0.15, 0.0)]);
    let at = |height: f64| {
        needed(
            &scene,
            &Shot {
                height,
                ..Shot::default()
            },
        )
        .elevation
    };
    assert!(at(0.4) < at(0.0) && at(0.0) < at(-0.4));
    let mut thick = scene.clone();
    thick.cue.stick.tip_width = 0.02;
    assert!(needed(&thick, &Shot::default()).elevation > at(0.0));
}

#[test]
fn a_ball_frozen_to_the_rail_is_struck_from_above() {
    // The cue ball touches the sharp nose of the head cushion, at h − R above its centre. A thin rod through the centre
    // passes over that nose where it is as steep as the line from the centre to it.
    let table = Preset::NineFoot.table();
    let x = table.reach(R) - 0.5 * table.length;
    let mut scene = scene(Preset::NineFoot, &[(x, 0.2)]);
    scene.cue = rod(1e-4);
    let found = needed(&scene, &Shot::default());
    let rise = table.nose_height - R;
    let tilt = libm::asin(rise / R) + libm::asin(0.5e-4 / R);
    assert_close("elevation", found.elevation, tilt, 1e-4, "rad");
    assert!(
        matches!(found.over, Some(Obstacle::Cushion(_))),
        "{:?}",
        found.over
    );
    // With a real cue: more than 25 degrees through the middle, far less for the top of the ball.
    scene.cue = Cue::default();
    let middle = needed(&scene, &Shot::default()).elevation.to_degrees();
    let top = needed(
        &scene,
        &Shot {
            height: 0.45,
            ..Shot::default()
        },
    );
    let top = top.elevation.to_degrees();
    assert!((25.0..35.0).contains(&middle), "{middle}°");
    assert!(top < 0.4 * middle, "{top}°");
    // Away from the rail, along it, there is room.
    let along = Shot {
        heading: 0.5 * std::f64::consts::PI,
        ..Shot::default()
    };
    assert!(needed(&scene, &along).elevation.to_degrees() < 5.0);
}

#[test]
fn a_level_cue_meets_the_wood_behind_the_table() {
    // From the head spot: the rod has to rise from the middle of the ball to the edge of the rail, 5 cm behind the nose.
    let mut scene = scene(Preset::NineFoot, &[(-0.635, 0.0)]);
    scene.cue = rod(0.02);
    let found = needed(&scene, &Shot::default());
    assert_eq!(found.over, Some(Obstacle::Rail));
    let table = Preset::NineFoot.table();
    let (away, rise) = (0.685, table.rail_height() - R);
    let tilt = libm::atan2(rise, away) + libm::asin(0.01 / libm::hypot(away, rise));
    assert_close("elevation", found.elevation, tilt, 1e-8, "rad");
    // From the far end no cue reaches the rail, and only the slate is below.
    let far = scene_with(&scene, (1.0, 0.0));
    let low = Shot {
        height: -0.9,
        ..Shot::default()
    };
    assert_eq!(needed(&far, &low).over, Some(Obstacle::Slate));
    assert_eq!(needed(&far, &Shot::default()).over, None);
}

fn scene_with(like: &Scene, (x, z): (f64, f64)) -> Scene {
    let mut scene = like.clone();
    scene.balls.clear();
    scene.place("0", Ball::POOL, x, z);
    scene
}

/// Distance of a cue made of many spheres from the nearest other ball and the nearest nose in front of the wood.
fn sampled(scene: &Scene, shot: &Shot) -> f64 {
    let ball = &scene.balls[0];
    let cue = &scene.cue;
    let middle = ball.state.position + R * cue.tip_offset(&ball.ball) * shot.contact();
    let tip = middle + cue.tip_radius * shot.along();
    let mut least = f64::INFINITY;
    for i in 0..=20_000 {
        let along = 0.0065 + (cue.stick.length - 0.0065) * f64::from(i) / 20_000.0;
        let radius = 0.5
            * (cue.stick.tip_width
                + (cue.stick.butt_width - cue.stick.tip_width) * along / cue.stick.length);
        let center = tip - along * shot.along();
        for other in &scene.balls[1..] {
            least = least.min((center - other.state.position).length() - radius - R);
        }
        let height = scene.table.nose_height;
        for cushion in &scene.table.cushions {
            let plan = DVec2::new(center.x, center.z);
            let (distance, _) = cushion.nearest(plan);
            let edge = DVec3::new(distance.max(0.0), center.y - height, 0.0).length();
            least = least.min(edge - radius);
        }
    }
    least
}

#[test]
fn many_spheres_find_the_same_clearance() {
    let mut scene = scene(
        Preset::NineFoot,
        &[
            (-0.9, 0.3),
            (-1.02, 0.33),
            (-1.0, 0.27),
            (-0.8, 0.1),
            (0.4, -0.2),
        ],
    );
    let mut lifted = 0;
    for turn in 0..24 {
        for (side, height) in [(0.0, 0.0), (0.3, -0.2), (-0.2, 0.4)] {
            let shot = Shot {
                heading: f64::from(turn) * 0.261,
                side,
                height,
                ..Shot::default()
            };
            let found = needed(&scene, &shot);
            let at = |elevation: f64| Shot {
                elevation: elevation.max(0.0),
                ..shot
            };
            assert_eq!(obstacle(&scene, 0, &at(found.elevation + 1e-6)), None);
            if let Some(Obstacle::Ball(_)) = found.over {
                lifted += 1;
                assert!(obstacle(&scene, 0, &at(found.elevation - 1e-6)).is_some());
                let clearance = sampled(&scene, &at(found.elevation));
                assert_close("clearance", clearance, 0.0, 2e-6, "m");
            } else {
                assert!(sampled(&scene, &at(found.elevation)) > -2e-4, "{shot:?}");
            }
            // In a mirror.
            let image = Shot {
                heading: -shot.heading,
                side: -shot.side,
                ..shot
            };
            for ball in &mut scene.balls {
                ball.state.position.z = -ball.state.position.z;
            }
            let mirrored = needed(&scene, &image).elevation;
            for ball in &mut scene.balls {
                ball.state.position.z = -ball.state.position.z;
            }
            assert_close("mirror", mirrored, found.elevation, 1e-7, "rad");
        }
    }
    assert!(lifted >= 6, "{lifted} shots over a ball");
}

#[test]
fn a_cue_without_room_is_told() {
    // Struck from below its middle almost upright, with balls all around.
    let ring: Vec<(f64, f64)> = std::iter::once((0.0, 0.0))
        .chain((0..6).map(|i| {
            let angle = f64::from(i) * std::f64::consts::PI / 3.0;
            (2.0 * R * libm::cos(angle), 2.0 * R * libm::sin(angle))
        }))
        .collect();
    let scene = scene(HALL, &ring);
    let middle = needed(&scene, &Shot::default());
    assert!(middle.elevation.to_degrees() > 30.0, "{middle:?}");
    let low = Shot {
        height: -0.9,
        ..Shot::default()
    };
    assert_eq!(lift(&scene, 0, &low), None);
    assert_eq!(obstacle(&scene, 99, &low), None);
}
