//! Several at once: judge J10.

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::laws::Laws;
use masse::physics::scene::PlannedShot;

use super::{play, scene, smooth};
use crate::closeness::assert_relative;

const R: f64 = Ball::POOL.radius;

#[test]
fn j10_a_frozen_pair_leaves_at_twice_the_tangent() {
    for degrees in [20.0_f64, 46.0, 70.0] {
        let mut scene = scene(Laws {
            ball_ball: smooth(0.95, 1.0).ball_ball,
            ..Laws::default()
        });
        scene.place("cue", Ball::POOL, 0.0, 0.0);
        scene.place("1", Ball::POOL, 2.0 * R, 0.0);
        let shot = Shot {
            heading: degrees.to_radians(),
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = play(&scene);
        let velocity = record.state_at(0, 0.0).velocity;
        let tangent = (velocity.z / velocity.x).abs();
        assert_relative(
            "tan θ",
            tangent,
            2.0 * libm::tan(degrees.to_radians()),
            1e-12,
            "",
        );
    }
}
