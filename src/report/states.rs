//! A table of every ball at even times, for whoever plots or fits a motion.

use std::io::{self, Write};

use serde::Serialize;

use crate::physics::ball::{Motion, State};
use crate::physics::record::Record;
use crate::physics::scene::Scene;

/// A row: metres, m/s, rad/s; x along the table to the foot, y up, z across.
#[derive(Serialize)]
struct Row<'a> {
    time: f64,
    ball: &'a str,
    x: f64,
    y: f64,
    z: f64,
    vx: f64,
    vy: f64,
    vz: f64,
    wx: f64,
    wy: f64,
    wz: f64,
    motion: Motion,
}

impl<'a> Row<'a> {
    fn of(time: f64, ball: &'a str, state: &State) -> Self {
        let State {
            position,
            velocity,
            angular_velocity,
            motion,
        } = *state;
        Self {
            time,
            ball,
            x: position.x,
            y: position.y,
            z: position.z,
            vx: velocity.x,
            vy: velocity.y,
            vz: velocity.z,
            wx: angular_velocity.x,
            wy: angular_velocity.y,
            wz: angular_velocity.z,
            motion,
        }
    }
}

/// Writes CSV with a row for every ball at 0, `every`, 2 `every`, ... seconds and at the end of the record.
///
/// The states are read off the closed forms of the paths: nothing is interpolated, and the times of the table change
/// nothing. At the time of an event a ball is as it leaves it.
///
/// # Errors
/// What the stream says.
pub fn write(out: impl Write, scene: &Scene, record: &Record, every: f64) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    let mut row = |time: f64| -> io::Result<()> {
        for (i, ball) in scene.balls.iter().enumerate() {
            csv.serialize(Row::of(time, &ball.name, &record.state_at(i, time)))?;
        }
        Ok(())
    };
    // A product, so that no rounding piles up.
    let times = (0_u64..).map(|step| step as f64 * every);
    times
        .take_while(|time| *time < record.end_time)
        .try_for_each(&mut row)?;
    row(record.end_time)?;
    csv.flush()
}
