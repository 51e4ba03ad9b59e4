//! Two balls. H7: equal motions never meet. H11: masses that differ by a million. H13: how fast an error grows.

use glam::DVec3;

use crate::physics::laws::Laws;
use crate::physics::record::{EventKind, Record};
use crate::physics::scene::{Rack, Scene};
use crate::physics::table::Preset;
use crate::report::judge::hard::{By, Claim, Hard, Rows, put, smooth, worst};
use crate::report::judge::stand::{Stand, room};
use crate::sim::play::Stopped;

pub(super) fn equal_motions() -> Rows {
    let mut rows = Vec::new();
    let ball = Stand::POOL.ball;
    let r = ball.radius;
    for by in By::BOTH {
        for (name, laws) in [("cloth", Laws::default()), ("no cloth", smooth(1.0, 1.0))] {
            let mut scene = room(laws);
            let rolls = ball.rolling_spin(DVec3::X);
            put(&mut scene, "a", 0.0, 0.0, DVec3::X * 2.0, DVec3::ZERO);
            put(&mut scene, "b", 0.0, 2.0 * r, DVec3::X * 2.0, DVec3::ZERO);
            put(&mut scene, "c", 0.0, 1.0, DVec3::X, rolls);
            put(&mut scene, "d", 2.0 * r, 1.0, DVec3::X, rolls);
            put(&mut scene, "e", 0.0, -1.0, DVec3::ZERO, DVec3::ZERO);
            put(&mut scene, "f", 2.0 * r, -1.0, DVec3::ZERO, DVec3::ZERO);
            scene.time_limit = 15.0;
            let record = by.play(&scene)?;
            let met = |kind: EventKind| kind == EventKind::BallBall;
            let hits = record.events.iter().filter(|event| met(event.kind)).count();
            let sound = record
                .end
                .iter()
                .all(crate::physics::ball::State::is_finite);
            let claim = Claim::new(
                "H7",
                format!("sliding twins, rolling twins, twins at rest, {name}"),
                by.name(),
                "never meet",
            );
            rows.push(claim.fact(hits == 0 && sound, format!("{hits} hits")));
        }
    }
    Ok(rows)
}

/// States of both after the first hit.
fn after_hit(record: &Record) -> [DVec3; 2] {
    let hit = record
        .events
        .iter()
        .find(|event| event.kind == EventKind::BallBall);
    [0, 1].map(|ball| {
        hit.and_then(|hit| hit.participants().find(|one| one.ball == ball))
            .map_or(DVec3::NAN, |one| one.after.velocity)
    })
}

pub(super) fn masses() -> Rows {
    let mut rows = Vec::new();
    for by in By::BOTH {
        for (one, two) in [(1.0, 1e-6), (1e-6, 1.0), (1e3, 1e-3)] {
            let mut scene = room(smooth(0.9, 1.0));
            put(&mut scene, "cue", -0.6, 0.0, DVec3::X * 2.0, DVec3::ZERO);
            put(&mut scene, "1", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
            scene.balls[0].ball.mass = one;
            scene.balls[1].ball.mass = two;
            scene.time_limit = 0.5;
            let [first, second] = after_hit(&by.play(&scene)?).map(|v| v.x);
            let must = [
                2.0 * (one - 0.9 * two) / (one + two),
                2.0 * 1.9 * one / (one + two),
            ];
            let error = worst([
                (first / must[0] - 1.0).abs(),
                (second / must[1] - 1.0).abs(),
            ]);
            let momentum = ((one * first + two * second) / (2.0 * one) - 1.0).abs();
            let claim = Claim::new(
                "H11",
                format!("{one:e} kg at 2 m/s into {two:e} kg, e 0.9"),
                by.name(),
                format!("{:.6} and {:.6e} m/s; momentum to 1e-15", must[0], must[1]),
            );
            rows.push(claim.error(
                if momentum <= 1e-15 { error } else { f64::NAN },
                1e-12,
                format!("{first:.6} and {second:.6e} m/s; momentum {momentum:.0e}"),
            ));
        }
    }
    Ok(rows)
}

pub(super) fn chaos() -> Rows {
    let mut rows = Vec::new();
    for by in By::BOTH {
        for distance in [0.2, 0.5, 1.0] {
            rows.push(nudged(by, distance)?);
        }
        rows.push(nudged_break(by)?);
    }
    Ok(rows)
}

/// A straight hit over d: the direction error of the object ball is d/(2R) − 1 times that of the cue ball.
fn nudged(by: By, distance: f64) -> Result<Hard, Stopped> {
    let nudge = 1e-9;
    let mut scene = room(smooth(1.0, 1.0));
    put(
        &mut scene,
        "cue",
        -distance,
        0.0,
        DVec3::new(1.0, 0.0, nudge),
        DVec3::ZERO,
    );
    put(&mut scene, "1", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
    scene.time_limit = 2.0;
    let [_, object] = after_hit(&by.play(&scene)?);
    let growth = -object.z / object.x / nudge;
    let must = distance / (2.0 * Stand::POOL.ball.radius) - 1.0;
    let claim = Claim::new(
        "H13",
        format!("direction error of a straight hit over {distance} m"),
        by.name(),
        format!("grows {must:.6} times"),
    );
    Ok(claim.error(
        (growth / must - 1.0).abs(),
        1e-6,
        format!("{growth:.6} times"),
    ))
}

/// Two breaks whose cue balls differ by 1e-13 rad: how far apart the balls are after 20, 60 and 100 events. So long the
/// digits of f64 last; beyond some 100 events a break is one of the possible ones.
fn nudged_break(by: By) -> Result<Hard, Stopped> {
    let scene = |nudge: f64| {
        let mut scene = Scene::new(Preset::Carom.table(), smooth(0.95, 0.9));
        Rack::EightBall.place(&mut scene, Stand::POOL.ball, 1e-4, 1);
        scene.balls[0].state.velocity = DVec3::new(9.0, 0.0, 0.03 + 9.0 * nudge);
        scene.time_limit = 10.0;
        scene
    };
    let [one, two] = [by.play(&scene(0.0))?, by.play(&scene(1e-13))?];
    let apart = |after: usize| {
        let Some(event) = one.events.get(after) else {
            return f64::NAN;
        };
        let place = |record: &Record, ball: usize| record.state_at(ball, event.time).position;
        worst((0..one.paths.len()).map(|ball| (place(&one, ball) - place(&two, ball)).length()))
    };
    let [early, late, last] = [apart(20), apart(60), apart(100)];
    let claim = Claim::new(
        "H13",
        "break of 15 balls at 9 m/s, the cue ball nudged by 1e-13 rad",
        by.name(),
        "grows; less than 1e-6 m after 60 events",
    );
    Ok(claim.fact(
        late < 1e-6 && late > early && last > late,
        format!("{early:.0e} m after 20 events, {late:.0e} after 60, {last:.0e} after 100"),
    ))
}
