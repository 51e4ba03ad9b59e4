//! One law at a time, to 1e-12.
//!
//! What their tables hold and is not compared to that:
//! - `mathavan_2010_default`: Euler steps of 6 mm/s, 0.5 % off in the median, and chaotic where a slip vanishes. The same
//!   with 1e5 steps, `mathavan_2010_fine`, is compared, to 1e-5.
//! - `frictional_mathavan_N1000`, `_N100000`: the slip at the cloth has the wrong sign of spin there (u = v + R ω × n̂ for a
//!   point below the centre), so that a rolling ball slips at 2 v. Our law is compared with the paper (J15) and with the
//!   same stepping with the sign put right.
//! - `frictionless_inelastic` of the slate: no law of ours bounces without friction there.

use glam::DVec3;

use masse::physics::ball::{Ball, Motion, State};
use masse::physics::cue::{Cue, Shot};
use masse::physics::laws::ball_ball::{
    BallBallLaw, Friction, Frictional, Frictionless, PairContact, PeerCap,
};
use masse::physics::laws::cue_ball::strike;
use masse::physics::laws::cushion::{
    CushionContact, CushionLaw, Han2005, Impulse, Inclination, Mathavan2010, Mirror, Stronge2018,
};
use masse::physics::laws::slate::SlateLaw;
use masse::physics::table::{Cushion, Nose};

use super::tables::{CushionRow, CushionSetup, Tables};
use super::{motion, state, vector};
use crate::closeness::{assert_relative, assert_vectors};

const TOLERANCE: f64 = 1e-12;

#[track_caller]
fn assert_velocities(what: &str, value: &State, expected: &State) {
    assert_vectors(what, value.velocity, expected.velocity, TOLERANCE, "m/s");
    let (spin, expected) = (value.angular_velocity, expected.angular_velocity);
    assert_vectors(what, spin, expected, TOLERANCE, "rad/s");
}

#[test]
fn reference_free_motion_with_its_transition_times() {
    let tables = Tables::load();
    let (ball, law) = (tables.ball(), tables.cloth());
    assert_eq!(tables.motion.len(), 30);
    for (i, row) in tables.motion.iter().enumerate() {
        let what = format!("motion[{i}]");
        let start = law.classify(&ball, state(&row.before));
        assert_eq!(start.motion, motion(row.s), "{what}");
        let labelled = |motion| law.piece(&ball, &State { motion, ..start }).duration;
        if row.slide_time > 0.0 {
            assert_relative(
                &what,
                labelled(Motion::Sliding),
                row.slide_time,
                TOLERANCE,
                "s",
            );
        }
        if row.roll_time > 0.0 {
            assert_relative(
                &what,
                labelled(Motion::Rolling),
                row.roll_time,
                TOLERANCE,
                "s",
            );
        }
        assert_relative(
            &what,
            labelled(Motion::Spinning),
            row.spin_time,
            TOLERANCE,
            "s",
        );
        let end = law.advance(&ball, &start, row.t);
        let expected = state(&row.out);
        assert_eq!(end.motion, motion(row.s_out), "{what}");
        assert_vectors(&what, end.position, expected.position, TOLERANCE, "m");
        assert_velocities(&what, &end, &expected);
    }
}

/// The geometry of a row of their cushion table, for this law.
fn cushion_contact(tables: &Tables, row: &CushionRow, law: &CushionLaw) -> CushionContact {
    // Their line lies along our x axis, their arc around our origin.
    let (setup, before) = (&tables.cushion_setup, state(&row.before));
    let flat = DVec3::new(before.position.x, 0.0, before.position.z);
    let (away, nose) = match row.kind.as_str() {
        "linear" => (DVec3::Z * flat.z, Cushion::Line(CushionSetup::line())),
        "circular" => (flat, Cushion::Arc(setup.arc())),
        other => panic!("there is no cushion of kind {other}"),
    };
    CushionContact {
        normal: away.normalize(),
        nose_height: law.nose_height(setup.height, &tables.ball(), &nose),
        nose: Nose::Wall,
        restitution: None,
    }
}

/// How far two outcomes are apart, over the speed and R times the spin before.
fn apart(ball: &Ball, before: &State, ours: &State, theirs: &State) -> f64 {
    crate::frames::distance(
        &State {
            position: theirs.position,
            ..*ours
        },
        theirs,
        ball.radius,
    ) / crate::frames::size(before, ball.radius)
}

#[test]
fn reference_mathavan_2010_as_fine_as_theirs() {
    // Their column `mathavan_2010_default` cannot be compared: Euler steps of 6 mm/s, 0.5 % off in the median, and where
    // a slip vanishes it chatters by its own rounding. `mathavan_2010_fine` is the same with 1e5 steps.
    let tables = Tables::load();
    let (p, ball) = (&tables.ball_params, tables.ball());
    let law = CushionLaw::Mathavan2010(Mathavan2010 {
        restitution: p.e_c.into(),
        friction: p.f_c.into(),
        sliding: p.u_s,
    });
    let mut errors = Vec::new();
    for row in &tables.cushion {
        let before = state(&row.before);
        let contact = cushion_contact(&tables, row, &law);
        let after = law.rebound(&ball, &before, &contact).state;
        errors.push(apart(
            &ball,
            &before,
            &after,
            &state(&row.out["mathavan_2010_fine"]),
        ));
    }
    assert_eq!(errors.len(), 30);
    errors.sort_by(f64::total_cmp);
    assert!(errors[15] < 3e-6 && errors[29] < 1e-5, "{errors:?}");
}

#[test]
fn reference_cushions() {
    let tables = Tables::load();
    let p = &tables.ball_params;
    let laws = [
        (
            "unrealistic",
            CushionLaw::Mirror(Mirror {
                restitution: p.e_c.into(),
            }),
        ),
        (
            "han_2005",
            CushionLaw::Han2005(Han2005 {
                restitution: p.e_c.into(),
                friction: p.f_c.into(),
            }),
        ),
        (
            "impulse_frictional_inelastic",
            CushionLaw::Impulse(Impulse {
                restitution: p.e_c.into(),
                friction: p.f_c.into(),
                inclination: Inclination::Peer,
            }),
        ),
        (
            "stronge_compliant_1.8",
            CushionLaw::Stronge2018(Stronge2018 {
                restitution: p.e_c.into(),
                friction: p.f_c,
                frequency_ratio: 1.8,
                inclination: Inclination::Peer,
            }),
        ),
    ];
    assert_eq!(tables.cushion.len(), 30);
    for (i, row) in tables.cushion.iter().enumerate() {
        let before = state(&row.before);
        for (name, law) in &laws {
            let contact = cushion_contact(&tables, row, law);
            let after = law.rebound(&tables.ball(), &before, &contact).state;
            let what = format!("cushion[{i}] {name}");
            assert_velocities(&what, &after, &state(&row.out[*name]));
        }
    }
}

#[test]
fn reference_ball_ball() {
    let tables = Tables::load();
    let (p, mu) = (&tables.ball_params, &tables.friction_alciatore);
    let laws = [
        (
            "frictionless_elastic",
            BallBallLaw::Frictionless(Frictionless { restitution: 1.0 }),
        ),
        (
            "frictional_inelastic",
            BallBallLaw::PeerCap(PeerCap(Frictional {
                restitution: p.e_b,
                friction: Friction::Marlow {
                    a: mu.a,
                    b: mu.b,
                    c: mu.c,
                },
            })),
        ),
    ];
    assert_eq!(tables.ball_ball.len(), 40);
    let ball = tables.ball();
    for (i, row) in tables.ball_ball.iter().enumerate() {
        let (first, second) = (state(&row.ball1), state(&row.ball2));
        let contact = PairContact::between(&first, &second);
        for (name, law) in &laws {
            let after = law.collide((&ball, &first), (&ball, &second), &contact);
            let what = format!("ball_ball[{i}] {name}");
            let expected = &row.out[*name];
            assert_velocities(&what, &after.first, &state(&expected.ball1));
            assert_velocities(&what, &after.second, &state(&expected.ball2));
        }
    }
}

#[test]
fn reference_friction_of_the_slate() {
    let tables = Tables::load();
    let p = &tables.ball_params;
    // Theirs bounces with e, ours does not: the rub of the bounce is that of 1 + e times the friction.
    let law = SlateLaw::Rubbed {
        friction: p.u_s * (1.0 + p.e_t),
    };
    assert_eq!(tables.ball_table.len(), 15);
    for (i, row) in tables.ball_table.iter().enumerate() {
        let before = state(&row.before);
        assert!(before.velocity.y < 0.0);
        let after = law.land(&tables.ball(), &before);
        let mut expected = state(&row.out["frictional_inelastic"].rvw);
        // Theirs bounces on, and where friction sticks it also takes spin about the vertical: a known defect.
        expected.velocity.y = 0.0;
        expected.angular_velocity.y = before.angular_velocity.y;
        assert_velocities(&format!("ball_table[{i}]"), &after, &expected);
    }
}

#[test]
fn reference_cue_strike() {
    let tables = Tables::load();
    let ball = tables.ball();
    assert_eq!(tables.strike.len(), 20);
    for (i, row) in tables.strike.iter().enumerate() {
        let cue = Cue {
            mass: row.mass,
            tip_restitution: 1.0,
            end_mass: row.end_mass,
            miscue_offset: 0.99,
            ..Cue::default()
        };
        let shot = Shot {
            heading: (row.phi - 90.0).to_radians(),
            elevation: row.theta.to_radians(),
            side: -row.a,
            height: row.b,
            speed: row.speed,
        };
        let rest = State::at_rest(DVec3::Y * ball.radius);
        let struck = strike(&cue, &SlateLaw::Held, &ball, &rest, &shot);
        let velocity = vector(&row.v3d);
        let expected = State {
            velocity: DVec3::new(velocity.x, 0.0, velocity.z),
            angular_velocity: vector(&row.w),
            ..rest
        };
        let what = format!("strike[{i}]");
        assert_velocities(&what, &struck.state, &expected);
        let impulse = ball.mass * velocity.length();
        assert_relative(&what, struck.impulse, impulse, TOLERANCE, "N s");
    }
}
