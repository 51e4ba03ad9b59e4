//! Playing a scene by a method: where the balls are at common times, what touched what, and what it costs.

use std::time::Duration;

use bevy::app::{App, FixedUpdate};
use bevy::ecs::message::Messages;
use bevy::ecs::schedule::SingleThreadedExecutor;
use cpu_time::ProcessTime;

use crate::physics::ball::State;
use crate::physics::exact::{Limits, solve};
use crate::physics::record::{Event, EventKind, Record};
use crate::physics::scene::{Scene, Solver};
use crate::report::speed_and_error::Method;
use crate::sim::messages::Failed;
use crate::sim::play::Stopped;
use crate::sim::recorder::Recorder;
use crate::sim::stepped::crowd::Crowd;
use crate::sim::stepping;

/// Common times a second. Every rate of ticks is a multiple of it.
pub const SAMPLES: u32 = 60;

/// Something that met something, at this time in s: the names of bodies in [`Touch::key`] tell what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// When, s.
    pub time: f64,
    /// Kind of contact and the two bodies, in an order that does not depend on who comes first.
    pub key: (u8, usize, usize),
}

impl Touch {
    /// The contact in an event; `None` for a change of motion and for the stroke.
    #[must_use]
    pub fn of(event: &Event) -> Option<Self> {
        let ball = event.first.ball;
        let other = event.second.map_or(ball, |second| second.ball);
        let key = match event.kind {
            EventKind::BallBall => (0, ball.min(other), ball.max(other)),
            EventKind::Cushion { cushion } => (1, ball, cushion),
            EventKind::Pocketed { pocket } => (2, ball, pocket),
            EventKind::Rim { pocket } => (3, ball, pocket),
            EventKind::Slate => (4, ball, 0),
            EventKind::OffTable => (5, ball, 0),
            EventKind::Strike { .. } | EventKind::Motion { .. } => return None,
        };
        Some(Self {
            time: event.time,
            key,
        })
    }

    /// All contacts in a list of events.
    #[must_use]
    pub fn all(events: &[Event]) -> Vec<Self> {
        events.iter().filter_map(Self::of).collect()
    }
}

/// What a method made of a scene.
#[derive(Clone, Debug, Default)]
pub struct Played {
    /// The states of all balls at 1/60 s, 2/60 s, ...
    pub states: Vec<Vec<State>>,
    /// What touched what, in order of time; `None` where it is not written down.
    pub touches: Option<Vec<Touch>>,
}

/// The time in s of this sample.
#[must_use]
pub fn sample_time(sample: usize) -> f64 {
    (sample + 1) as f64 / f64::from(SAMPLES)
}

/// The same of a record that is there already.
#[must_use]
pub fn sampled(record: &Record, samples: usize) -> Played {
    let balls = record.end.len();
    let at = |time| (0..balls).map(|ball| record.state_at(ball, time)).collect();
    Played {
        states: (0..samples).map(|sample| at(sample_time(sample))).collect(),
        touches: Some(Touch::all(&record.events)),
    }
}

/// Plays this many samples of a scene.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
pub fn play(method: Method, scene: &Scene, samples: usize) -> Result<Played, Stopped> {
    let mut scene = method.prepare(scene);
    let Some(rate) = method.rate() else {
        scene.time_limit = samples as f64 / f64::from(SAMPLES);
        return Ok(sampled(&solve(&scene, Limits::default())?, samples));
    };
    let mut app = app(&scene);
    let mut states = Vec::with_capacity(samples);
    for _ in 0..samples {
        step(&mut app, rate / SAMPLES)?;
        states.push(stepping::states(&mut app));
    }
    let events = &app.world().resource::<Recorder>().events;
    Ok(Played {
        states,
        touches: (!scene.solver.is_crowd()).then(|| Touch::all(events)),
    })
}

/// Processor time of playing this many samples; laying out the balls is not counted for a stepped method.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
pub fn cost(method: Method, scene: &Scene, samples: usize) -> Result<Duration, Stopped> {
    let mut scene = method.prepare(scene);
    let Some(rate) = method.rate() else {
        scene.time_limit = samples as f64 / f64::from(SAMPLES);
        let start = ProcessTime::now();
        std::hint::black_box(solve(&scene, Limits::default())?);
        return Ok(start.elapsed());
    };
    let mut app = app(&scene);
    let start = ProcessTime::now();
    for _ in 0..samples {
        step(&mut app, rate / SAMPLES)?;
    }
    Ok(start.elapsed())
}

/// A table that runs on one thread, so that processor time is what the work costs and not what threads cost.
pub fn app(scene: &Scene) -> App {
    let mut app = stepping::headless_app(scene);
    app.edit_schedule(FixedUpdate, |schedule| {
        schedule.set_executor(SingleThreadedExecutor::new());
    });
    if matches!(scene.solver, Solver::Stepped(stepped) if stepped.crowd) {
        app.world_mut().resource_mut::<Crowd>().threads = Some(1);
    }
    app
}

/// Advances a table by this many ticks.
///
/// # Errors
/// [`Stopped`] if the solver cannot go on.
pub fn step(app: &mut App, ticks: u32) -> Result<(), Stopped> {
    stepping::step(app, ticks);
    let mut failed = app.world_mut().resource_mut::<Messages<Failed>>();
    let last = failed.drain().last();
    last.map_or(Ok(()), |failed| Err(Stopped::Stepped(failed)))
}
