//! J11 and J12: the stroke and squirt (Alciatore, TP A.30, A.31).

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::cue::{Cue, Shot, Tip};
use masse::physics::laws::cue_ball::{Struck, squirt_angle, strike};
use masse::physics::laws::slate::SlateLaw;

use super::{moving, settled, turn};
use crate::closeness::{assert_close, assert_printed, assert_relative, assert_vectors};

const BALL: Ball = Ball::POOL;

/// A cue without squirt.
fn cue(tip_restitution: f64) -> Cue {
    Cue {
        mass: 0.567,
        tip_restitution,
        end_mass: 0.0,
        miscue_offset: 0.5,
        ..Cue::default()
    }
}

fn struck(cue: &Cue, shot: &Shot) -> Struck {
    let rest = State::at_rest(DVec3::Y * BALL.radius);
    strike(cue, &SlateLaw::Held, &BALL, &rest, shot)
}

fn shot(side: f64, height: f64) -> Shot {
    Shot {
        side,
        height,
        speed: 3.0,
        ..Shot::default()
    }
}

#[test]
fn j11_speed_and_spin_of_a_level_stroke() {
    for restitution in [1.0, 0.73] {
        for b in [0.0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5] {
            let ratio = BALL.mass / 0.567;
            let expected = (1.0 + restitution) / (1.0 + ratio + 2.5 * b * b);
            for (side, height) in [(b, 0.0), (-b, 0.0), (0.0, b), (0.0, -b), (0.6 * b, 0.8 * b)] {
                let state = struck(&cue(restitution), &shot(side, height)).state;
                assert_relative("v/V₀", state.velocity.x / 3.0, expected, 1e-14, "1");
                assert_close("aside", state.velocity.z, 0.0, 1e-15, "m/s");
                let surface = BALL.radius * state.angular_velocity / state.velocity.x;
                // Right english is counter-clockwise seen from above; follow turns the ball as rolling does.
                let expected = DVec3::new(0.0, 2.5 * side, -2.5 * height);
                assert_vectors("R ω / v", surface, expected, 1e-14, "1");
            }
        }
    }
}

#[test]
fn j11_printed_speeds() {
    let printed = [
        (0.0, 1.53847),
        (0.1, 1.50944),
        (0.2, 1.42858),
        (0.25, 1.37340),
        (0.3, 1.31148),
        (0.4, 1.17647),
        (0.5, 1.03896),
    ];
    for (b, printed) in printed {
        let state = struck(&cue(1.0), &shot(0.0, b)).state;
        assert_printed(&format!("b = {b}"), state.velocity.x / 3.0, printed, 5, "1");
    }
    let state = struck(&cue(0.73), &shot(0.0, 0.0)).state;
    assert_printed("leather tip", state.velocity.x / 3.0, 1.33077, 5, "1");
}

#[test]
fn j11_the_height_that_rolls_fastest() {
    let final_speed = |b: f64| settled(&struck(&cue(1.0), &shot(0.0, b)).state).velocity.x;
    let best = -1.0 + (1.0 + 0.4 * (1.0 + BALL.mass / 0.567)).sqrt();
    assert_printed("height", best, 0.23288, 5, "R");
    let top = final_speed(best);
    for aside in [1e-4, 1e-3, 0.05, 0.2] {
        // Near the top the speed falls with the square: at 1e-4 by 1e-8 of itself.
        assert!(final_speed(best - aside) < top * (1.0 - 0.3 * aside * aside));
        assert!(final_speed(best + aside) < top * (1.0 - 0.3 * aside * aside));
    }
}

#[test]
fn j11_a_hit_at_two_fifths_rolls_at_once() {
    let state = struck(&cue(1.0), &shot(0.0, 0.4)).state;
    let slip = BALL.slip(state.velocity, state.angular_velocity);
    assert_vectors("slip", slip, DVec3::ZERO, 1e-14, "m/s");
    let state = moving(state.velocity, state.angular_velocity);
    assert_eq!(state.motion, masse::physics::ball::Motion::Rolling);
}

#[test]
fn a_tip_is_named_by_what_it_is_made_of() {
    for tip in Tip::ALL {
        let (least, most) = tip.measured_restitution();
        let cue = Cue::default().with_tip(tip);
        assert!((least..=most).contains(&cue.tip_restitution), "{tip:?}");
        let state = struck(
            &Cue {
                end_mass: 0.0,
                ..cue
            },
            &shot(0.0, 0.0),
        )
        .state;
        let expected = (1.0 + tip.restitution()) / (1.0 + BALL.mass / cue.mass);
        assert_relative("v/V₀", state.velocity.x / 3.0, expected, 1e-14, "1");
    }
}

#[test]
fn the_miscue_offset_is_the_friction_of_the_tip() {
    assert_printed("Alciatore's 0.6", Cue::miscue_offset_of(0.6), 0.514, 3, "R");
    for offset in [0.0, 0.3, 0.5, 0.9] {
        let cue = Cue {
            miscue_offset: offset,
            ..cue(1.0)
        };
        let back = Cue::miscue_offset_of(cue.tip_friction());
        assert_close("offset", back, offset, 1e-15, "R");
        // At the limit the force of a gripping tip lies on the edge of the friction cone.
        let shot = shot(offset, 0.0);
        let lean = shot.along().cross(shot.contact()).length() / -shot.along().dot(shot.contact());
        assert_close("tangent", lean, cue.tip_friction(), 1e-14, "1");
    }
}

#[test]
fn a_round_tip_is_held_farther_out_than_it_hits() {
    // A nickel of 10.6 mm on a ball of 28.575 mm: 37 % farther out.
    assert_printed("pool", Cue::default().tip_offset(&BALL), 1.371, 3, "1");
    let sharp = Cue {
        tip_radius: 0.0,
        ..Cue::default()
    };
    assert_eq!(sharp.tip_offset(&BALL), 1.0);
    // What the tip is like changes nothing of the stroke, because the contact is named.
    let round = struck(&Cue::default(), &shot(0.3, -0.2)).state;
    assert_eq!(struck(&sharp, &shot(0.3, -0.2)).state, round);
}

#[test]
fn j12_squirt_turns_the_ball_away_from_the_english() {
    for (ratio, printed) in [
        (20.0, [0.6071, 1.1994, 1.7607, 2.2721, 2.7094]),
        (30.0, [0.4257, 0.8403, 1.2317, 1.5861, 1.8860]),
    ] {
        let cue = Cue {
            end_mass: BALL.mass / ratio,
            ..cue(1.0)
        };
        for (b, printed) in [0.1, 0.2, 0.3, 0.4, 0.5].into_iter().zip(printed) {
            for speed in [0.1, 3.0, 9.0] {
                let shot = Shot {
                    heading: 0.7,
                    speed,
                    ..shot(b, 0.0)
                };
                let struck = struck(&cue, &shot);
                let angle = turn(shot.forward(), struck.state.velocity);
                let expected = libm::atan2(
                    2.5 * b * (1.0 - b * b).sqrt(),
                    1.0 + ratio + 2.5 * (1.0 - b * b),
                );
                assert_close("squirt", angle, expected, 1e-15, "rad");
                assert_close("squirt told", struck.squirt, expected, 1e-15, "rad");
                assert_printed("squirt", angle.to_degrees(), printed, 4, "°");
            }
        }
    }
    let cue = Cue {
        end_mass: BALL.mass / 20.0,
        ..cue(1.0)
    };
    let degrees = squirt_angle(&cue, &BALL, 0.2).to_degrees();
    assert_printed("squirt", degrees, 1.1993583313, 10, "°");
}

#[test]
fn an_elevated_cue_keeps_its_horizontal_share() {
    for elevation_deg in [0.0, 10.0, 45.0, 80.0] {
        let elevation = f64::to_radians(elevation_deg);
        let shot = Shot {
            elevation,
            ..shot(0.0, 0.0)
        };
        let struck = struck(&cue(1.0), &shot);
        let full = 2.0 * 3.0 / (1.0 + BALL.mass / 0.567);
        let expected = DVec3::X * (full * libm::cos(elevation));
        assert_vectors("velocity", struck.state.velocity, expected, 1e-15, "m/s");
        assert_relative("impulse", struck.impulse, BALL.mass * full, 1e-15, "N s");
        assert_close(
            "spin",
            struck.state.angular_velocity.length(),
            0.0,
            1e-13,
            "rad/s",
        );
    }
}

#[test]
fn j13_side_on_a_steep_cue_curves_towards_the_english() {
    // θ = 60°, right side 0.3 R: slip backwards and the draw axis leans, so the ball curves right.
    let shot = Shot {
        elevation: f64::to_radians(60.0),
        ..shot(0.3, 0.0)
    };
    let state = struck(&cue(1.0), &shot).state;
    let end = settled(&state);
    assert!(turn(DVec3::X, end.velocity) < -0.1, "{:?}", end.velocity);
    // The final direction is parallel to the line from the lowest point of the ball to where the cue line meets the cloth.
    let (sin, cos) = (libm::sin(shot.elevation), libm::cos(shot.elevation));
    let depth = (1.0_f64 - 0.09).sqrt();
    let height = 1.0 + depth * sin;
    let met = DVec3::new(-depth * cos + height * cos / sin, 0.0, 0.3);
    assert_close("direction", turn(met, end.velocity), 0.0, 1e-14, "rad");
}

#[test]
fn a_miscue_begins_at_its_offset_and_without_a_jump() {
    let at = struck(&cue(1.0), &shot(0.5, 0.0));
    let beyond = struck(&cue(1.0), &shot(0.5 + 1e-9, 0.0));
    assert!(!at.miscue && beyond.miscue);
    assert_vectors(
        "velocity",
        beyond.state.velocity,
        at.state.velocity,
        1e-7,
        "m/s",
    );
    let far = struck(&cue(1.0), &shot(0.8, 0.0));
    let gripped = struck(
        &Cue {
            miscue_offset: 0.9,
            ..cue(1.0)
        },
        &shot(0.8, 0.0),
    );
    assert!(far.miscue && !gripped.miscue);
    let spin = |struck: &Struck| struck.state.angular_velocity.y;
    // What is left falls to nothing where the cue passes the ball by.
    let push = |offset: f64| struck(&cue(1.0), &shot(offset, 0.0)).impulse;
    assert!(push(0.6) < push(0.5) && push(0.8) < push(0.6) && push(0.99) < 0.2 * push(0.5));
    assert!(
        spin(&far) < spin(&gripped),
        "a tip that slips gives less spin"
    );
    assert!(
        turn(DVec3::X, far.state.velocity) > 0.1,
        "and pushes the ball aside"
    );
}
