//! The same stroke by other laws, to be shown beside the table: the model of the coursework report beside real physics,
//! and the other way round.
//!
//! Both begin with the same positions, velocities and spins: those that the cue left behind, for the coursework knows no
//! cue. The twin is played at once, beside the game, and looked up by the time of the shot or of its replay.

use bevy::prelude::*;
use bevy::tasks::futures_lite::future;
use bevy::tasks::{AsyncComputeTaskPool, Task, block_on};

use crate::game::replay::Replay;
use crate::game::view::{Beside, View};
use crate::physics::ball::State;
use crate::physics::laws::Laws;
use crate::physics::record::{Event, EventKind, Record};
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::sim::clock::Clock;
use crate::sim::play::play;
use crate::sim::recorder::Recorder;

/// Which laws the twin has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TwinLaws {
    /// The complete model of the coursework report.
    #[default]
    Coursework,
    /// Pool as it is played.
    Real,
}

impl TwinLaws {
    /// The laws that are to be seen beside those of a scene.
    #[must_use]
    pub fn beside(laws: &Laws) -> Self {
        if laws.motion.is_closed_form() {
            Self::Coursework
        } else {
            Self::Real
        }
    }
}

/// The same balls in the same states under the other laws.
#[must_use]
pub fn twin_of(before: &Scene, events: &[Event]) -> Scene {
    let mut scene = before.clone();
    scene.shot = None;
    let struck = events
        .first()
        .filter(|event| matches!(event.kind, EventKind::Strike { .. }));
    if let Some(event) = struck
        && let Some(ball) = scene.balls.get_mut(event.first.ball)
    {
        ball.state = event.first.after;
    }
    match TwinLaws::beside(&before.laws) {
        TwinLaws::Coursework => {
            scene.laws = Laws::coursework();
            scene.solver = Solver::Stepped(Stepped::default());
            // The coursework knows no height.
            for ball in &mut scene.balls {
                ball.state.velocity.y = 0.0;
            }
        }
        TwinLaws::Real => {
            scene.laws = Laws::default();
            scene.solver = Solver::Exact;
        }
    }
    scene
}

/// The twin of the last stroke.
#[derive(Resource, Default)]
pub struct Twin {
    /// Which laws it has.
    pub laws: TwinLaws,
    /// What it does; nothing while it is worked out, or if nothing has been struck.
    pub record: Option<Record>,
    /// Why it cannot be played.
    pub failed: Option<String>,
    /// The time that is shown, s.
    pub time: f64,
    /// What is played.
    of: Option<Scene>,
    work: Option<Task<Result<Record, String>>>,
}

impl Twin {
    /// The state of a ball at the time that is shown; none while there is no twin.
    #[must_use]
    pub fn state(&self, ball: usize) -> Option<State> {
        let record = self.record.as_ref()?;
        (ball < record.paths.len()).then(|| record.state_at(ball, self.time))
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Twin>().add_systems(
        FixedPostUpdate,
        (begin, take, keep_time)
            .chain()
            .run_if(|view: Res<View>| view.beside == Beside::Laws),
    );
}

/// Begins to play the twin of a new stroke.
fn begin(mut twin: ResMut<Twin>, recorder: Res<Recorder>) {
    let before = recorder.before.as_ref();
    let Some(before) = before.filter(|before| !before.solver.is_crowd()) else {
        return;
    };
    twin.laws = TwinLaws::beside(&before.laws);
    let moves = |ball: &crate::physics::scene::SceneBall| !ball.state.motion.is_still();
    if recorder.events.is_empty() && !before.balls.iter().any(moves) {
        twin.clear();
        return;
    }
    let scene = twin_of(before, &recorder.events);
    if twin.of.as_ref() == Some(&scene) {
        return;
    }
    twin.clear();
    twin.of = Some(scene.clone());
    let work = async move { play(&scene).map_err(|error| error.to_string()) };
    twin.work = Some(AsyncComputeTaskPool::get().spawn(work));
}

impl Twin {
    fn clear(&mut self) {
        if self.of.is_some() {
            *self = Self {
                laws: self.laws,
                ..Self::default()
            };
        }
    }
}

/// Takes what has been worked out.
fn take(mut twin: ResMut<Twin>) {
    let Some(work) = &mut twin.work else { return };
    let Some(done) = block_on(future::poll_once(work)) else {
        return;
    };
    twin.work = None;
    match done {
        Ok(record) => twin.record = Some(record),
        Err(reason) => twin.failed = Some(reason),
    }
}

/// Follows the time of the shot, or of its replay, once a tick as the balls of the table do. When the table has come to rest the twin goes on to its own end.
pub fn keep_time(
    mut twin: ResMut<Twin>,
    mut replay: ResMut<Replay>,
    clock: Res<Clock>,
    time: Res<Time>,
) {
    let end = twin.record.as_ref().map_or(0.0, |record| record.end_time);
    twin.time = if let Some(playback) = &mut replay.bypass_change_detection().0 {
        // Whichever rests last, its end can be seen.
        playback.record.end_time = playback.record.end_time.max(end);
        playback.time
    } else if clock.moving {
        clock.time()
    } else {
        (twin.time + time.delta_secs_f64()).min(end.max(clock.time()))
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::cue::Shot;
    use crate::physics::scene::PlannedShot;
    use crate::physics::table::Preset;

    fn struck(laws: Laws) -> (Scene, Record) {
        let mut scene = Scene::new(Preset::NineFoot.table(), laws);
        let cue = scene.place("cue", Ball::POOL, -0.6, 0.1);
        scene.place("1", Ball::POOL, 0.3, 0.1);
        scene.shot = Some(PlannedShot {
            ball: cue,
            shot: Shot {
                speed: 2.0,
                side: 0.3,
                height: -0.3,
                ..Shot::default()
            },
        });
        let record = play(&scene).expect("it can be played");
        (scene, record)
    }

    #[test]
    fn a_twin_begins_as_the_cue_left_the_balls_and_then_goes_its_own_way() {
        let (scene, record) = struck(Laws::default());
        let before = Scene {
            shot: None,
            ..scene
        };
        let twin = twin_of(&before, &record.events);
        assert_eq!(twin.balls[0].state, record.events[0].first.after);
        assert_eq!(twin.balls[1], before.balls[1]);
        assert_eq!(twin.laws, Laws::coursework());
        let other = play(&twin).expect("the coursework plays it");
        let (a, b) = (record.state_at(0, 0.3), other.state_at(0, 0.3));
        assert!(a.position.distance(b.position) > 1e-3, "{a:?} {b:?}");
        // And back again: the twin of the coursework is real.
        let back = twin_of(&twin, &[]);
        assert_eq!(back.laws, Laws::default());
        assert_eq!(back.solver, Solver::Exact);
        let real = play(&back).expect("real physics plays it");
        let end = real.end[1].position.distance(record.end[1].position);
        assert!(end < 1e-9, "{end}");
    }
}
