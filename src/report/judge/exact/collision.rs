//! J3 and J4: stun shots, head-on shots, unequal masses.

use glam::DVec3;

use crate::physics::ball::{Ball, State};
use crate::physics::laws::ball_ball::{BallBallLaw, Friction, Frictional, PairContact, PeerCap};
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, ball_ball_laws, rough, smooth, turn};

const TANGENT: &str = "closed form (Alciatore, TP A.6)";
const HEAD_ON: &str = "closed form, momentum and restitution";

pub(super) fn rows() -> Vec<Row> {
    let mut rows = right_angle();
    rows.extend(separation());
    rows.extend(head_on());
    rows.extend(unequal());
    rows
}

fn right_angle() -> Vec<Row> {
    let stand = Stand::POOL;
    let mut rows = Vec::new();
    for (law, name) in [
        (smooth(1.0), "Frictionless, e 1"),
        (rough(1.0, Friction::Constant(0.0)), "Frictional, e 1, μ 0"),
    ] {
        for cut_deg in [10.0, 30.0, 45.0, 60.0, 80.0] {
            let cut = f64::to_radians(cut_deg);
            let after = stand.hit(&law, &stand.stunned(1.0), cut);
            let (cue, object) = (after.first.velocity, after.second.velocity);
            let mut add = |what: &str, expected: f64, ours: f64, unit| {
                let title = format!("J3 stun, {cut_deg}° cut: {what}");
                rows.push(Row::closed(&title, name, expected, ours, unit).by(TANGENT));
            };
            add("object ball", libm::cos(cut), object.length(), "v");
            add("cue ball", libm::sin(cut), cue.length(), "v");
            add(
                "separation",
                90.0,
                turn(cue, object).abs().to_degrees(),
                "°",
            );
        }
    }
    rows
}

/// Restitution and friction close the right angle.
fn separation() -> Vec<Row> {
    let stand = Stand::POOL;
    let cut = f64::to_radians(30.0);
    let (sin, cos) = (libm::sin(cut), libm::cos(cut));
    let mut rows = Vec::new();
    for restitution in [0.95, 0.897] {
        for mu in [0.0, 0.06, 0.1] {
            let law = Frictional {
                restitution,
                friction: Friction::Constant(mu),
            };
            // Our limit of friction is μ times the whole impulse; the peer's, for comparison, μ times 2e/(1 + e) of it.
            let peer = 2.0 * restitution / (1.0 + restitution);
            for (law, name, cap) in [
                (BallBallLaw::Frictional(law), "Frictional", 1.0),
                (BallBallLaw::PeerCap(PeerCap(law)), "PeerCap", peer),
            ] {
                let after = stand.hit(&law, &stand.stunned(1.0), cut);
                let ours = turn(after.first.velocity, after.second.velocity).abs();
                let share = 0.5 * (1.0 + restitution) * cos;
                let thrown = (cap * mu * share).min(sin / 7.0);
                let expected = libm::atan2(sin - thrown, cos - share) - libm::atan2(thrown, share);
                let title = format!("J3 stun, 30° cut, e {restitution}, μ {mu}: separation");
                let (expected, ours) = (expected.to_degrees(), ours.to_degrees());
                rows.push(Row::closed(&title, name, expected, ours, "°").by(TANGENT));
            }
        }
    }
    rows
}

/// Every law, with its own restitution and with others.
fn head_on() -> Vec<Row> {
    let stand = Stand::POOL;
    let mut rows = Vec::new();
    for (name, law) in ball_ball_laws() {
        for given in [None, Some(0.5), Some(1.0)] {
            let e = given.unwrap_or(law.restitution(3.0));
            let after = stand.hit_with(&law, &stand.stunned(3.0), 0.0, given);
            let (cue, object) = (after.first.velocity.x, after.second.velocity.x);
            let title = format!("J4 head-on, e {e}");
            let expected = 1.5 * (1.0 - e);
            let title_cue = format!("{title}: cue ball");
            let row = if expected == 0.0 {
                Row::zero(&title_cue, &name, cue, 1e-14, "m/s")
            } else {
                Row::closed(&title_cue, &name, expected, cue, "m/s")
            };
            rows.push(row.by(HEAD_ON));
            let expected = 1.5 * (1.0 + e);
            let title = format!("{title}: object ball");
            rows.push(Row::closed(&title, &name, expected, object, "m/s").by(HEAD_ON));
        }
    }
    rows
}

/// H11: up to a million to one.
fn unequal() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, law) in ball_ball_laws() {
        for ratio in [1e-6, 0.5, 1e6] {
            let first = Ball {
                mass: ratio * Ball::POOL.mass,
                ..Ball::POOL
            };
            let second = Ball::POOL;
            let (m_1, m_2, v) = (first.mass, second.mass, 2.0);
            let e = law.restitution(v);
            let mut before = State::at_rest(DVec3::Y * first.radius);
            before.velocity.x = v;
            let rest = State::at_rest(before.position + 2.0 * first.radius * DVec3::X);
            let contact = PairContact::between(&before, &rest);
            let after = law.collide((&first, &before), (&second, &rest), &contact);
            let title = format!("J4 head-on, masses {ratio:e} : 1");
            let expected = [
                (m_1 - e * m_2) / (m_1 + m_2) * v,
                (1.0 + e) * m_1 / (m_1 + m_2) * v,
            ];
            let ours = [after.first.velocity.x, after.second.velocity.x];
            for (i, ball) in ["cue ball", "object ball"].into_iter().enumerate() {
                let title = format!("{title}: {ball}");
                rows.push(Row::closed(&title, &name, expected[i], ours[i], "m/s").by(HEAD_ON));
            }
        }
    }
    rows
}
