//! What the shot that is being aimed will do, to the end: the very function that plays it, so what is shown is what
//! happens, bit for bit.

use crate::physics::cue::Shot;
use crate::physics::exact::{Limits, SolveError, solve};
use crate::physics::record::Record;
use crate::physics::scene::{PlannedShot, Scene, Solver};

/// Events after which a preview is cut: far more than any shot has.
const EVENTS: u64 = 20_000;

/// The whole shot from this table: squirt, english, elevation, every ball.
///
/// # Errors
/// [`SolveError`] if the table cannot be played, or its motion law has no closed form.
pub fn preview(table: &Scene, ball: usize, shot: &Shot) -> Result<Record, SolveError> {
    let scene = Scene {
        shot: Some(PlannedShot { ball, shot: *shot }),
        solver: Solver::Exact,
        ..table.clone()
    };
    solve(&scene, Limits { events: EVENTS })
}

/// The last preview, and what it was made for: aiming at the same thing twice costs nothing.
#[derive(Clone, Debug, Default)]
pub struct Cached {
    made_for: Option<(Scene, usize, Shot)>,
    record: Option<Record>,
}

impl Cached {
    /// The preview of this shot; `None` if there is none to be had.
    pub fn of(&mut self, table: Scene, ball: usize, shot: &Shot) -> Option<&Record> {
        let known = self
            .made_for
            .as_ref()
            .is_some_and(|(t, b, s)| *b == ball && s == shot && *t == table);
        if !known {
            self.record = preview(&table, ball, shot).ok();
            self.made_for = Some((table, ball, *shot));
        }
        self.record.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::laws::Laws;
    use crate::physics::scene::Rack;
    use crate::physics::table::Preset;
    use crate::sim::stepping::run_to_rest;

    #[test]
    fn what_it_shows_is_what_happens() {
        let mut table = Scene::new(Preset::NineFoot.table(), Laws::default());
        Rack::NineBall.place(&mut table, Ball::POOL, 0.0, 5);
        let shot = Shot {
            speed: 7.0,
            side: 0.2,
            elevation: 0.2,
            ..Shot::default()
        };
        let shown = preview(&table, 0, &shot).expect("a rack can be played");
        table.shot = Some(PlannedShot { ball: 0, shot });
        let (happened, _) = run_to_rest(&table);
        assert_eq!(shown.end, happened.end);
        assert_eq!(shown.paths, happened.paths);
        assert!(shown.events.len() > 20);
    }

    #[test]
    fn a_table_without_a_closed_form_has_none() {
        let mut table = Scene::new(Preset::NineFoot.table(), Laws::coursework());
        table.place("cue", Ball::POOL, 0.0, 0.0);
        assert!(preview(&table, 0, &Shot::default()).is_err());
        assert!(Cached::default().of(table, 0, &Shot::default()).is_none());
    }
}
