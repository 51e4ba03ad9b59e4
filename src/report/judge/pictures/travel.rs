//! How far a cue ball draws back or follows after a square hit, against the offset and the speed of the cue.

use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::Friction;
use crate::physics::scene::{PlannedShot, Scene, Solver, Stepped};
use crate::report::chart::{Axis, Chart, Ink, Panel, Series};
use crate::report::judge::pictures::curve_ink;
use crate::report::judge::stand::{Stand, room, rough};
use crate::sim::play::{Stopped, play};

/// The object ball lies this far in front of the cue ball, gap between them in m.
const APART: f64 = 0.6;

/// Heights of the tip in R against which travel is drawn, and the speeds of the cue in m/s of its curves.
const HEIGHTS: (f64, f64) = (-0.5, 0.5);
const SPEEDS: [f64; 3] = [1.0, 2.0, 3.0];

/// Speeds of the cue in m/s against which travel is drawn, and the heights of the tip in R of its curves.
const RISING: (f64, f64) = (0.05, 4.0);
const TIPS: [f64; 4] = [-0.4, -0.2, 0.0, 0.4];

pub(super) fn chart() -> Result<Chart, Stopped> {
    let real = Laws {
        motion: Stand::POOL.motion(),
        ball_ball: rough(0.95, Friction::MARLOW),
        ..Laws::default()
    };
    let mut by_height = Vec::new();
    for (i, speed) in SPEEDS.into_iter().enumerate() {
        let shot = |height: f64| stroke(height, speed);
        let colour = curve_ink(i).colour;
        let points = travels(&real, HEIGHTS, 80, &shot)?;
        by_height.push(Series::new(
            &format!("cue at {speed} m/s"),
            Ink::line(colour),
            points,
        ));
        let points = travels(&Laws::coursework(), HEIGHTS, 40, &shot)?;
        by_height.push(Series::new(
            &format!("coursework, {speed} m/s"),
            Ink::dashed(colour),
            points,
        ));
    }
    let mut by_speed = Vec::new();
    for (i, height) in TIPS.into_iter().enumerate() {
        let shot = |speed: f64| stroke(height, speed);
        let side = if height < 0.0 { "below" } else { "above" };
        let tip = format!("tip {} R {side}", height.abs());
        let colour = curve_ink(i).colour;
        let points = travels(&real, RISING, 80, &shot)?;
        by_speed.push(Series::new(
            &format!("{tip} the centre"),
            Ink::line(colour),
            points,
        ));
        let points = travels(&Laws::coursework(), RISING, 20, &shot)?;
        by_speed.push(Series::new(
            &format!("coursework, {tip}"),
            Ink::dashed(colour),
            points,
        ));
    }
    Ok(Chart {
        title: "Travel of the cue ball after a square hit, object ball 0.6 m ahead; no measured distances could be had"
            .to_owned(),
        panels: vec![
            Panel {
                title: "against the height of the tip".to_owned(),
                x: Axis::linear("tip above the centre, R", HEIGHTS.0, HEIGHTS.1),
                y: Axis::linear("travel of the cue ball, m", -4.0, 8.0),
                series: by_height,
            },
            Panel {
                title: "against the speed of the cue".to_owned(),
                x: Axis::linear("speed of the cue, m/s", 0.0, RISING.1),
                y: Axis::linear("travel of the cue ball, m", -4.0, 8.0),
                series: by_speed,
            },
        ],
        columns: 2,
    })
}

fn stroke(height: f64, speed: f64) -> Shot {
    Shot {
        height,
        speed,
        ..Shot::default()
    }
}

/// Travel in m of the cue ball after the hit, behind the hit below 0, for shots that vary over this range: each on its own
/// lane of one room.
fn travels(
    laws: &Laws,
    (from, to): (f64, f64),
    steps: u32,
    shot: &dyn Fn(f64) -> Shot,
) -> Result<Vec<(f64, f64)>, Stopped> {
    let ball = Stand::POOL.ball;
    let mut scene = room(*laws);
    scene.cue = Cue::default();
    if !laws.motion.is_closed_form() {
        scene.solver = Solver::Stepped(Stepped::default());
        // A model that never ends: in this time it does.
        scene.time_limit = 30.0;
    }
    let values: Vec<f64> = (0..=steps)
        .map(|step| from + (to - from) * f64::from(step) / f64::from(steps))
        .collect();
    for (lane, value) in values.iter().enumerate() {
        let z = lane as f64 - 0.5 * f64::from(steps);
        let cue = scene.place(&format!("cue {lane}"), ball, 0.0, z);
        scene.place(&lane.to_string(), ball, APART + 2.0 * ball.radius, z);
        strike(&mut scene, cue, shot(*value));
    }
    let record = play(&scene)?;
    let met = |cue: usize| {
        record.events.iter().any(|event| {
            event.second.is_some()
                && event
                    .participants()
                    .any(|participant| participant.ball == cue)
        })
    };
    Ok(values
        .into_iter()
        .enumerate()
        .map(|(lane, value)| {
            let travel = record.end[2 * lane].position.x - APART;
            (value, if met(2 * lane) { travel } else { f64::NAN })
        })
        .collect())
}

/// Gives a ball of the scene what this stroke gives it.
fn strike(scene: &mut Scene, ball: usize, shot: Shot) {
    scene.balls[ball].state = scene.struck(&PlannedShot { ball, shot }).state;
}
