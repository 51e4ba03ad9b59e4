//! How far a cue ball draws back or follows after a square hit, against the offset and the speed of the cue.

use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::Friction;
use crate::physics::scene::{PlannedShot, Solver, Stepped};
use crate::report::chart::{Axis, Chart, Ink, Panel, Series};
use crate::report::judge::pictures::law_ink;
use crate::report::judge::stand::{Stand, Stopped, play, rough};

/// The object ball lies this far in front of the cue ball, gap between them in m.
const APART: f64 = 0.6;

/// Travel of the cue ball in m after a square hit; behind the hit is below 0.
fn travel(laws: &Laws, height: f64, speed: f64, solver: Solver) -> Result<f64, Stopped> {
    let stand = Stand::POOL;
    let mut scene = crate::report::judge::stand::room(*laws);
    scene.solver = solver;
    scene.cue = Cue::default();
    scene.time_limit = 60.0;
    let reach = APART + 2.0 * stand.ball.radius;
    scene.place("cue", stand.ball, 0.0, 0.0);
    scene.place("1", stand.ball, reach, 0.0);
    let shot = Shot {
        height,
        speed,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    let record = play(&scene)?;
    let hit = record.events.iter().any(|event| event.second.is_some());
    Ok(if hit {
        record.end[0].position.x - APART
    } else {
        f64::NAN
    })
}

pub(super) fn chart() -> Result<Chart, Stopped> {
    let real = Laws {
        motion: Stand::POOL.motion(),
        ball_ball: rough(0.95, Friction::MARLOW),
        ..Laws::default()
    };
    let stepped = Solver::Stepped(Stepped {
        grid: None,
        ..Stepped::default()
    });
    let mut by_height = Vec::new();
    let mut by_speed = Vec::new();
    for (i, speed) in [1.0, 2.0, 3.0].into_iter().enumerate() {
        let heights = |step: i32| f64::from(step) * 0.0125;
        let line = |laws: &Laws, solver, steps: &[i32]| -> Result<Vec<(f64, f64)>, Stopped> {
            let point =
                |step: &i32| Ok((heights(*step), travel(laws, heights(*step), speed, solver)?));
            steps.iter().map(point).collect()
        };
        let fine: Vec<i32> = (-40..=40).collect();
        let coarse: Vec<i32> = (-10..=10).map(|step| 4 * step).collect();
        let label = format!("cue at {speed} m/s");
        by_height.push(Series::new(
            &label,
            law_ink(i),
            line(&real, Solver::Exact, &fine)?,
        ));
        let ink = Ink::dashed(law_ink(i).colour);
        let label = format!("coursework, {speed} m/s");
        by_height.push(Series::new(
            &label,
            ink,
            line(&Laws::coursework(), stepped, &coarse)?,
        ));
    }
    for (i, height) in [-0.4, -0.2, 0.0, 0.4].into_iter().enumerate() {
        let line = |laws: &Laws, solver, steps: i32| -> Result<Vec<(f64, f64)>, Stopped> {
            let speed = |step: i32| 4.0 * f64::from(step) / f64::from(steps);
            (1..=steps)
                .map(|step| Ok((speed(step), travel(laws, height, speed(step), solver)?)))
                .collect()
        };
        let label = format!("tip {height} R above the centre");
        by_speed.push(Series::new(
            &label,
            law_ink(i),
            line(&real, Solver::Exact, 80)?,
        ));
        let label = format!("coursework, tip {height} R");
        let ink = Ink::dashed(law_ink(i).colour);
        by_speed.push(Series::new(
            &label,
            ink,
            line(&Laws::coursework(), stepped, 16)?,
        ));
    }
    Ok(Chart {
        title: "Travel of the cue ball after a square hit, object ball 0.6 m ahead; no measured distances could be had"
            .to_owned(),
        panels: vec![
            Panel {
                title: "against the height of the tip".to_owned(),
                x: Axis::linear("tip above the centre, R", -0.5, 0.5),
                y: Axis::linear("travel of the cue ball, m", -4.0, 8.0),
                series: by_height,
            },
            Panel {
                title: "against the speed of the cue".to_owned(),
                x: Axis::linear("speed of the cue, m/s", 0.0, 4.0),
                y: Axis::linear("travel of the cue ball, m", -4.0, 8.0),
                series: by_speed,
            },
        ],
        columns: 2,
    })
}
