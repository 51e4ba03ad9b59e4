//! Replay of the last shot: pause, scrub, slow motion, event by event, backwards, in a loop.
//!
//! A replay looks states up in the [`Record`] and writes them to the balls, so whatever draws the table draws the replay.
//! When it stops, the balls go back to where the shot left them.

use bevy::prelude::*;

use crate::game::practice::{PracticeCommand, obey};
use crate::physics::ball::State;
use crate::physics::record::Record;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Velocity};
use crate::sim::messages::{LoadScene, Strike};
use crate::sim::recorder::Recorder;

/// What the viewer asks of the replay.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub enum ReplayCommand {
    /// Show the last shot from its beginning.
    Start,
    /// Back to the table as the shot left it.
    Stop,
    /// Hold or go on.
    TogglePlay,
    /// Go to this time of the shot, s.
    Seek(f64),
    /// Seconds of the shot shown in a second; below zero backwards.
    Rate(f64),
    /// Go to the next event, or with `false` to the one before.
    StepEvent(bool),
    /// Begin again at the end, or not.
    ToggleLoop,
}

/// A shot being shown again.
#[derive(Clone, Debug)]
pub struct Playback {
    /// What is shown.
    pub record: Record,
    /// Time of the shot shown now, s.
    pub time: f64,
    /// Seconds of the shot in a second of the viewer; below zero backwards.
    pub rate: f64,
    /// Whether time goes on by itself.
    pub playing: bool,
    /// Whether the end leads to the beginning.
    pub looping: bool,
}

impl Playback {
    /// Moves on by this many seconds of the viewer, and stops or begins again at either end.
    fn advance(&mut self, seconds: f64) {
        if !self.playing {
            return;
        }
        let end = self.record.end_time;
        let time = self.time + self.rate * seconds;
        let over = time < 0.0 || time > end;
        if over && self.looping && end > 0.0 {
            self.time = time.rem_euclid(end);
        } else {
            self.time = time.clamp(0.0, end);
            self.playing = !over;
        }
    }

    /// Time of the nearest event after (or before) the present time.
    fn neighbour_event(&self, forward: bool) -> f64 {
        let mut times = self.record.events.iter().map(|event| event.time);
        let next = if forward {
            times.find(|time| *time > self.time)
        } else {
            times.rfind(|time| *time < self.time)
        };
        next.unwrap_or(if forward { self.record.end_time } else { 0.0 })
    }
}

/// The replay, if one is on.
#[derive(Resource, Clone, Debug, Default)]
pub struct Replay(pub Option<Playback>);

impl Replay {
    /// Whether the balls show a replay and not the table.
    #[must_use]
    pub fn is_active(&self) -> bool {
        self.0.is_some()
    }

    fn obey(&mut self, command: ReplayCommand) {
        let Some(playback) = &mut self.0 else { return };
        match command {
            ReplayCommand::Start => {
                playback.time = 0.0;
                playback.playing = true;
            }
            ReplayCommand::TogglePlay => {
                playback.playing = !playback.playing;
                let at_end = if playback.rate < 0.0 {
                    playback.time <= 0.0
                } else {
                    playback.time >= playback.record.end_time
                };
                if playback.playing && at_end {
                    let backwards = playback.rate < 0.0;
                    playback.time = if backwards {
                        playback.record.end_time
                    } else {
                        0.0
                    };
                }
            }
            ReplayCommand::Seek(time) if time.is_finite() => {
                playback.time = time.clamp(0.0, playback.record.end_time);
            }
            ReplayCommand::Rate(rate) if rate.is_finite() => playback.rate = rate,
            ReplayCommand::Stop | ReplayCommand::Seek(_) | ReplayCommand::Rate(_) => {}
            ReplayCommand::StepEvent(forward) => {
                playback.time = playback.neighbour_event(forward);
                playback.playing = false;
            }
            ReplayCommand::ToggleLoop => playback.looping = !playback.looping,
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Replay>()
        .add_message::<ReplayCommand>()
        .add_message::<PracticeCommand>()
        .add_systems(
            FixedUpdate,
            (
                leave.before(obey).before(SimSystems::Strike),
                forget.after(SimSystems::Strike).before(SimSystems::Advance),
                (listen, show).chain().after(SimSystems::Judge),
            ),
        );
}

type Balls<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static mut Position,
        &'static mut Velocity,
        Option<&'static mut AngularVelocity>,
        &'static mut MotionKind,
    ),
>;

/// A stroke, a new scene or a change of the table ends the replay: the table is put back first.
pub(super) fn leave(
    mut replay: ResMut<Replay>,
    mut balls: Balls,
    mut strikes: MessageReader<Strike>,
    mut scenes: MessageReader<LoadScene>,
    mut commands: MessageReader<PracticeCommand>,
) {
    if strikes.read().count() + scenes.read().count() + commands.read().count() > 0 {
        end(&mut replay, &mut balls);
    }
}

/// The same for a scene that was asked for after that in the same tick.
pub(super) fn leave_for_scene(
    mut replay: ResMut<Replay>,
    mut balls: Balls,
    mut scenes: MessageReader<LoadScene>,
) {
    if scenes.read().count() > 0 {
        end(&mut replay, &mut balls);
    }
}

/// Balls that have just been laid out are not those of the replay: there is nothing to put back.
fn forget(mut replay: ResMut<Replay>, new: Query<(), Added<BallIndex>>) {
    if replay.is_active() && !new.is_empty() {
        replay.0 = None;
    }
}

/// Does what the viewer asks.
fn listen(
    mut replay: ResMut<Replay>,
    mut balls: Balls,
    mut commands: MessageReader<ReplayCommand>,
    recorder: Res<Recorder>,
    clock: Res<Clock>,
) {
    for command in commands.read() {
        match command {
            ReplayCommand::Start if !replay.is_active() => {
                if !clock.moving && !recorder.events.is_empty() {
                    replay.0 = Some(Playback {
                        record: recorder.record(clock.time(), None),
                        time: 0.0,
                        rate: 1.0,
                        playing: true,
                        looping: false,
                    });
                }
            }
            ReplayCommand::Stop => end(&mut replay, &mut balls),
            command => replay.obey(*command),
        }
    }
}

/// Moves on by one tick and puts the balls where they were then.
fn show(mut replay: ResMut<Replay>, mut balls: Balls, time: Res<Time>) {
    let Some(playback) = &mut replay.bypass_change_detection().0 else {
        return;
    };
    playback.advance(time.delta_secs_f64());
    let now = playback.time;
    put(
        &mut balls,
        |ball| playback.record.state_at(ball, now),
        playback.record.paths.len(),
    );
}

fn end(replay: &mut Replay, balls: &mut Balls) {
    if let Some(playback) = replay.0.take() {
        put(
            balls,
            |ball| playback.record.end[ball],
            playback.record.end.len(),
        );
    }
}

fn put(balls: &mut Balls, state: impl Fn(usize) -> State, count: usize) {
    for (index, mut position, mut velocity, spin, mut motion) in balls {
        if index.0 >= count {
            continue;
        }
        let state = state(index.0);
        position.set_if_neq(Position(state.position));
        velocity.set_if_neq(Velocity(state.velocity));
        motion.set_if_neq(MotionKind(state.motion));
        if let Some(mut spin) = spin {
            spin.set_if_neq(AngularVelocity(state.angular_velocity));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::cue::Shot;
    use crate::physics::laws::Laws;
    use crate::physics::scene::{PlannedShot, Scene};
    use crate::physics::table::Preset;
    use crate::sim::stepping::{headless_app, scene, states, step};

    fn played() -> App {
        let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
        scene.place("cue", Ball::POOL, -0.6, 0.0);
        scene.place("1", Ball::POOL, 0.3, 0.01);
        scene.shot = Some(PlannedShot {
            ball: 0,
            shot: Shot {
                speed: 1.5,
                ..Shot::default()
            },
        });
        let mut app = headless_app(&scene);
        plugin(&mut app);
        while app.world().resource::<Clock>().moving {
            step(&mut app, 1);
        }
        app
    }

    fn ask(app: &mut App, command: ReplayCommand) {
        app.world_mut().write_message(command);
        step(app, 1);
    }

    #[test]
    fn a_replay_shows_the_past_and_puts_the_table_back() {
        let mut app = played();
        let end = states(&mut app);
        ask(&mut app, ReplayCommand::Start);
        let start = states(&mut app);
        assert!(
            (start[0].position.x + 0.6).abs() < 0.1,
            "{:?}",
            start[0].position
        );
        ask(&mut app, ReplayCommand::StepEvent(true));
        ask(&mut app, ReplayCommand::StepEvent(true));
        assert_ne!(states(&mut app), end);
        ask(&mut app, ReplayCommand::Stop);
        assert_eq!(states(&mut app), end);
        assert!(!app.world().resource::<Replay>().is_active());
    }

    #[test]
    fn it_runs_backwards_and_in_a_loop_within_the_shot() {
        let app = played();
        let recorder = app.world().resource::<Recorder>();
        let record = recorder.record(app.world().resource::<Clock>().time(), None);
        let end = record.end_time;
        let mut playback = Playback {
            record,
            time: 0.5,
            rate: -1.0,
            playing: true,
            looping: false,
        };
        playback.advance(1.0);
        assert!(playback.time == 0.0 && !playback.playing);
        playback.playing = true;
        playback.looping = true;
        playback.advance(0.25);
        assert!((playback.time - (end - 0.25)).abs() < 1e-12);
    }

    #[test]
    fn a_scene_that_is_asked_for_late_in_a_tick_is_laid_out_as_it_is() {
        let mut app = played();
        ask(&mut app, ReplayCommand::Start);
        let mut wanted = scene(&mut app);
        wanted.balls.truncate(1);
        wanted.shot = None;
        wanted.balls[0].state = State::at_rest(glam::DVec3::new(0.3, Ball::POOL.radius, 0.1));
        let asked = wanted.clone();
        let late = move |mut load: MessageWriter<LoadScene>, mut done: Local<bool>| {
            if !std::mem::replace(&mut *done, true) {
                load.write(LoadScene(asked.clone()));
            }
        };
        app.add_systems(FixedUpdate, late.after(leave).before(SimSystems::Strike));
        step(&mut app, 5);
        assert!(!app.world().resource::<Replay>().is_active());
        assert_eq!(scene(&mut app).balls, wanted.balls);
    }

    #[test]
    fn a_stroke_ends_the_replay_and_is_played_from_the_table_as_it_was() {
        let mut app = played();
        let end = states(&mut app);
        ask(&mut app, ReplayCommand::Start);
        app.world_mut().write_message(Strike {
            ball: 0,
            shot: Shot::default(),
        });
        step(&mut app, 1);
        assert!(!app.world().resource::<Replay>().is_active());
        let recorder = app.world().resource::<Recorder>();
        assert_eq!(recorder.events[0].first.before.position, end[0].position);
    }
}
