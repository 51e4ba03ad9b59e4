//! H15: no impact wins energy. H16: a mirror, another direction, other units, a moving observer and time run backwards
//! change nothing. Of the laws over random impacts, as the exact judges have them, and of whole shots by both solvers.

use glam::DVec3;

use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::Friction;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::report::judge::exact::{random_balls, random_cushions};
use crate::report::judge::hard::{By, Claim, Hard, Rows, put, smooth, worst};
use crate::report::judge::stand::{Stand, room, rough};
use crate::sim::play::Stopped;

/// The rows of the exact judges whose names begin like this.
fn of_laws(case: &'static str) -> impl Iterator<Item = Hard> {
    let rows = random_balls().into_iter().chain(random_cushions());
    rows.filter(move |row| row.name.starts_with(case))
        .map(move |row| {
            let what = row.name[case.len()..].trim().to_owned();
            Claim::new(
                case,
                format!("{what}, {}", row.law),
                "laws",
                format!("less than {:.0e}", row.tolerance),
            )
            .error(row.error, row.tolerance, format!("{:.0e}", row.error))
        })
}

/// Seven balls that meet within a second, the first of which moves and spins; nothing touches yet.
fn shot(laws: Laws, turn: f64, mirror: bool) -> Scene {
    let mut scene = room(laws);
    let (sin, cos) = (libm::sin(turn), libm::cos(turn));
    let side = if mirror { -1.0 } else { 1.0 };
    let frame = |x: f64, z: f64| {
        let z = side * z;
        DVec3::new(cos * x + sin * z, 0.0, cos * z - sin * x)
    };
    let velocity = frame(3.0, 0.2);
    // Spin is an axial vector.
    let level = frame(-20.0 * side, 15.0 * side);
    let spin = DVec3::new(level.x, side * 40.0, level.z);
    let start = frame(-0.4, -0.05);
    put(&mut scene, "cue", start.x, start.z, velocity, spin);
    for (i, (x, z)) in [
        (0.0, 0.0),
        (0.11, 0.05),
        (0.12, -0.06),
        (0.25, 0.1),
        (0.24, -0.12),
        (0.3, 0.0),
    ]
    .into_iter()
    .enumerate()
    {
        let place = frame(x, z);
        put(
            &mut scene,
            &(i + 1).to_string(),
            place.x,
            place.z,
            DVec3::ZERO,
            DVec3::ZERO,
        );
    }
    scene.time_limit = 1.0;
    scene
}

/// Rough balls on cloth.
fn cloth() -> Laws {
    Laws {
        ball_ball: rough(0.95, Friction::Constant(0.06)),
        motion: MotionLaw::Coulomb(Stand::POOL.cloth),
        ..Laws::default()
    }
}

pub(super) fn energy() -> Rows {
    let mut rows: Vec<Hard> = of_laws("H15").collect();
    for by in By::BOTH {
        let (_, seen) = by.audit(&shot(cloth(), 0.3, false))?;
        let claim = Claim::new(
            "H15",
            "a shot at 3 m/s with english among six balls",
            by.name(),
            "wins nothing at any event",
        );
        rows.push(claim.error(
            seen.energy,
            1e-13,
            format!("{:.0e} of it, {} events", seen.energy, seen.events),
        ));
    }
    Ok(rows)
}

pub(super) fn frames() -> Rows {
    let mut rows: Vec<Hard> = of_laws("H16").collect();
    for by in By::BOTH {
        let plain = by.play(&shot(cloth(), 0.0, false))?;
        let flip = |v: DVec3| DVec3::new(v.x, v.y, -v.z);
        let image = by.play(&shot(cloth(), 0.0, true))?;
        rows.push(told(
            "a shot in the mirror",
            by,
            apart(&plain, &image, flip),
            &plain,
            1e-12,
        ));
        let (sin, cos) = (libm::sin(1.9), libm::cos(1.9));
        let back = |v: DVec3| DVec3::new(cos * v.x - sin * v.z, v.y, sin * v.x + cos * v.z);
        let image = by.play(&shot(cloth(), 1.9, false))?;
        rows.push(told(
            "a shot turned by 1.9 rad",
            by,
            apart(&plain, &image, back),
            &plain,
            1e-10,
        ));
        rows.push(units(by, &plain)?);
        rows.push(moving(by)?);
        rows.push(backwards(by)?);
    }
    Ok(rows)
}

fn told(scene: &str, by: By, error: f64, record: &Record, tolerance: f64) -> Hard {
    let claim = Claim::new("H16", scene, by.name(), "the same shot");
    claim.error(
        error,
        tolerance,
        format!("{:.0e} m apart after {} events", error, record.events.len()),
    )
}

/// How far apart in m the ends of two shots are, the second seen through `back`; NaN if their events differ in number.
fn apart(one: &Record, two: &Record, back: impl Fn(DVec3) -> DVec3) -> f64 {
    if one.events.len() != two.events.len() {
        return f64::NAN;
    }
    let places = one.end.iter().zip(&two.end);
    worst(places.map(|(one, two)| (one.position - back(two.position)).length()))
}

/// The same shot with lengths 3.7 times the number, times 1.9 times, masses 0.3 times.
fn units(by: By, plain: &Record) -> Result<Hard, Stopped> {
    let (length, time, mass) = (3.7, 1.9, 0.3);
    let mut scene = shot(cloth(), 0.0, false);
    let MotionLaw::Coulomb(cloth) = &mut scene.laws.motion else {
        unreachable!("the shot is on cloth");
    };
    cloth.gravity *= length / (time * time);
    cloth.spin_deceleration /= time * time;
    for ball in &mut scene.balls {
        ball.ball.mass *= mass;
        ball.ball.radius *= length;
        ball.state.position *= length;
        ball.state.velocity *= length / time;
        ball.state.angular_velocity /= time;
    }
    scene.time_limit *= time;
    let scaled = by.play(&scene)?;
    let error = apart(plain, &scaled, |v| v / length);
    Ok(told("a shot in other units", by, error, plain, 1e-10))
}

/// No cloth: the same shot seen from a train.
fn moving(by: By) -> Result<Hard, Stopped> {
    let train = DVec3::new(-0.7, 0.0, 1.3);
    let laws = Laws {
        ball_ball: cloth().ball_ball,
        ..smooth(1.0, 1.0)
    };
    let mut scene = shot(laws, 0.0, false);
    let plain = by.play(&scene)?;
    for ball in &mut scene.balls {
        ball.state.velocity += train;
    }
    let seen = by.play(&scene)?;
    let error = apart(&plain, &seen, |v| v - plain.end_time * train);
    Ok(told(
        "a shot without cloth, seen from a train",
        by,
        error,
        &plain,
        1e-10,
    ))
}

/// Nothing lost: with all velocities turned round the balls come back to where they began.
fn backwards(by: By) -> Result<Hard, Stopped> {
    let start = shot(smooth(1.0, 1.0), 0.0, false);
    let there = by.play(&start)?;
    let mut scene = start.clone();
    for (ball, end) in scene.balls.iter_mut().zip(&there.end) {
        ball.state.position = end.position;
        ball.state.velocity = -end.velocity;
    }
    scene.time_limit = there.end_time;
    let back = by.play(&scene)?;
    let places = back.end.iter().zip(&start.balls);
    let error = worst(places.map(|(end, ball)| (end.position - ball.state.position).length()));
    Ok(told(
        "a shot without loss, and back in time",
        by,
        error,
        &there,
        1e-9,
    ))
}
