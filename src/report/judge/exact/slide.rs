//! J1 and J2: from slide to roll to rest.

use glam::DVec3;

use crate::physics::ball::{Motion, State};
use crate::physics::record::Record;
use crate::physics::scene::{Solver, Stepped};
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, smooth};
use crate::sim::play::Stopped;
use crate::sim::play::play;

const SOURCE: &str = "closed form (Alciatore, TP A.4, TP B.7)";

pub(super) fn rows() -> Result<Vec<Row>, Stopped> {
    let mut rows = stun()?;
    rows.extend(invariants()?);
    Ok(rows)
}

/// J1: a ball that starts at 2 m/s without spin.
fn stun() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let cloth = stand.cloth;
    let (v, mu, g) = (2.0, cloth.sliding, cloth.gravity);
    let (roll, time) = (5.0 / 7.0 * v, 2.0 * v / (7.0 * mu * g));
    let slide = 12.0 * v * v / (49.0 * mu * g);
    let (roll_time, roll_path) = (
        roll / (cloth.rolling * g),
        roll * roll / (2.0 * cloth.rolling * g),
    );
    let mut scene = stand.room(smooth(1.0));
    scene.place("cue", stand.ball, -50.0, 0.0);
    scene.balls[0].state.velocity.x = v;
    let mut rows = Vec::new();
    for (law, solver) in [
        ("Coulomb, exact solver", Solver::Exact),
        (
            "Coulomb, stepped 1/120 s",
            Solver::Stepped(Stepped {
                grid: None,
                ..Stepped::default()
            }),
        ),
    ] {
        scene.solver = solver;
        let record = play(&scene)?;
        let start = scene.balls[0].state.position.x;
        let mut add = |what: &str, expected: f64, ours: f64, unit| {
            rows.push(
                Row::closed(
                    &format!("J1 stun at 2 m/s: {what}"),
                    law,
                    expected,
                    ours,
                    unit,
                )
                .by(SOURCE),
            );
        };
        if let Some((when, state)) = begins(&record, Motion::Rolling) {
            let kept = stand.ball.kinetic_energy(&state) / (0.5 * stand.ball.mass * v * v);
            add("speed when it rolls", roll, state.velocity.x, "m/s");
            add("time of slide", time, when, "s");
            add("path of slide", slide, state.position.x - start, "m");
            add("energy kept", 5.0 / 7.0, kept, "");
        }
        add(
            "whole path",
            slide + roll_path,
            record.end[0].position.x - start,
            "m",
        );
        if let Some((when, _)) = begins(&record, Motion::Rest) {
            add("whole time", time + roll_time, when, "s");
        }
    }
    Ok(rows)
}

/// When, and as what, the first ball begins this kind of motion: on its own, or as it comes down on the slate.
pub(super) fn begins(record: &Record, motion: Motion) -> Option<(f64, State)> {
    record.events.iter().find_map(|event| {
        let ball = event
            .participants()
            .find(|participant| participant.ball == 0)?;
        let begins = ball.after.motion == motion && ball.before.motion != motion;
        begins.then_some((event.time, ball.after))
    })
}

/// J2: what stays while a ball slides, the worst of three slides read off the record at twenty moments each.
fn invariants() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let ball = stand.ball;
    let (mut invariant, mut direction, mut linear, mut work) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for (velocity, spin) in [
        (DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, 30.0, 90.0)),
        (DVec3::new(1.0, 0.0, -3.0), DVec3::new(80.0, -20.0, 40.0)),
        (DVec3::new(0.2, 0.0, 0.1), DVec3::new(-150.0, 60.0, 10.0)),
    ] {
        let mut scene = stand.room(smooth(1.0));
        scene.place("cue", ball, 0.0, 0.0);
        scene.balls[0].state.velocity = velocity;
        scene.balls[0].state.angular_velocity = spin;
        let record = play(&scene)?;
        let Some((end, rolling)) = begins(&record, Motion::Rolling) else {
            continue;
        };
        let start = record.state_at(0, 0.0);
        let roll = |v: DVec3, w: DVec3| 5.0 / 7.0 * v + 2.0 / 7.0 * ball.radius * w.cross(DVec3::Y);
        let first = roll(start.velocity, start.angular_velocity);
        let slip = ball.slip(start.velocity, start.angular_velocity);
        for step in 1..20 {
            let share = f64::from(step) / 20.0;
            let now = record.state_at(0, share * end);
            let here = ball.slip(now.velocity, now.angular_velocity);
            let drift = roll(now.velocity, now.angular_velocity) - first;
            invariant = invariant.max(drift.length() / first.length());
            direction = direction.max(here.cross(slip).length() / slip.length_squared());
            linear = linear.max((here.length() / slip.length() - (1.0 - share)).abs());
        }
        let mut last = rolling;
        last.angular_velocity.y = start.angular_velocity.y;
        let lost = ball.kinetic_energy(&start) - ball.kinetic_energy(&last);
        let expected = ball.mass * slip.length_squared() / 7.0;
        work = work.max((lost / expected - 1.0).abs());
    }
    let law = "Coulomb, exact solver";
    Ok(vec![
        Row::zero(
            "J2 slide: roll invariant, relative drift",
            law,
            invariant,
            1e-13,
            "",
        ),
        Row::zero("J2 slide: turn of the slip", law, direction, 1e-13, ""),
        Row::zero(
            "J2 slide: slip falls linearly, deviation",
            law,
            linear,
            1e-13,
            "",
        ),
        Row::zero(
            "J2 slide: work of friction / (m u²/7) − 1",
            law,
            work,
            1e-12,
            "",
        ),
    ]
    .into_iter()
    .map(|row| row.by(SOURCE))
    .collect())
}
