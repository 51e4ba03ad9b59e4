//! J16: a ball that is dropped on the slate, by the exact solver.

use crate::physics::ball::Motion;
use crate::physics::laws::slate::{Bouncing, SlateLaw};
use crate::report::judge::Row;
use crate::report::judge::exact::slide::begins;
use crate::report::judge::stand::{Stand, smooth};
use crate::sim::play::{Stopped, play};

const SOURCE: &str = "closed form, geometric series";

pub(super) fn rows() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let g = stand.cloth.gravity;
    let mut rows = Vec::new();
    for (height, e) in [(0.1, 0.5), (0.1, 0.9), (0.02, 0.7)] {
        let mut scene = stand.room(smooth(1.0));
        scene.laws.slate = SlateLaw::Bouncing(Bouncing {
            restitution: e,
            friction: 0.2,
            // The series goes on for ever; what comes after a bounce of this speed is 1e-12 of it.
            settle: 1e-12,
        });
        scene.place("cue", stand.ball, 0.0, 0.0);
        scene.balls[0].state.position.y += height;
        let record = play(&scene)?;
        let title = format!("J16 dropped from {height} m, e {e}");
        let mut add = |what: &str, expected: f64, ours: f64, unit| {
            let title = format!("{title}: {what}");
            rows.push(Row::closed(&title, "Bouncing", expected, ours, unit).by(SOURCE));
        };
        let fall = (2.0 * height / g).sqrt();
        let rest = begins(&record, Motion::Rest).map_or(f64::NAN, |(time, _)| time);
        add("time to rest", fall * (1.0 + e) / (1.0 - e), rest, "s");
        // Up and down again after every bounce.
        let bounces = record.events.iter().map(|event| {
            let up = event.first.after.velocity.y.max(0.0);
            up * up / g
        });
        let way = height + bounces.sum::<f64>();
        add(
            "whole way",
            height * (1.0 + e * e) / (1.0 - e * e),
            way,
            "m",
        );
        let top = record.state_at(0, fall * (1.0 + e)).position.y - stand.ball.radius;
        add("height of the second top", height * e * e, top, "m");
    }
    Ok(rows)
}
