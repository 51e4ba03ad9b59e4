//! Practice on an open table: rack again, retry the last shot, undo, place balls by hand.
//!
//! Commands are obeyed at the start of a fixed tick. Going back brings back the balls and the table; laws, cue and solver
//! stay as they are now, so that the same shot can be tried under other laws.

use bevy::prelude::*;
use glam::DVec2;

use crate::game::aim::Aim;
use crate::game::history::History;
use crate::game::turns::Turns;
use crate::game::{placing, racking, target};
use crate::physics::ball::Motion;
use crate::physics::cue::Shot;
use crate::physics::equipment::Equipment;
use crate::physics::laws::Laws;
use crate::physics::scene::{Rack, Scene};
use crate::physics::table::Preset;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Velocity};
use crate::sim::messages::{AtRest, Failed, LoadScene, Strike, Struck};
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::sim::recorder::Recorder;

/// Speed of the cue in m/s that a new rack is offered.
pub const BREAK_SPEED: f64 = 8.0;

/// What the player asks of the open table.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub enum PracticeCommand {
    /// Back to just before the last shot, aimed as it was.
    Retry,
    /// Back by one step: a shot, a ball placed by hand, a new rack.
    Undo,
    /// Does again what was undone last.
    Redo,
    /// Racks again on the same table.
    Rack(Rack),
    /// Racks again on another table.
    Table(Preset),
    /// Puts a ball down on the free spot nearest to x, z in m. Ignored while balls move.
    PlaceBall {
        /// Index of the ball in the scene.
        ball: usize,
        /// Wished place of its centre, m.
        x: f64,
        /// Wished place of its centre, m.
        z: f64,
    },
    /// Brings the cue ball back to the head spot, or the free spot nearest to it, and lets the player move it. Ignored
    /// while balls move.
    CueBallInHand,
}

/// Where practice stands.
#[derive(Resource, Clone, Debug, PartialEq)]
pub struct Practice {
    /// The rack last asked for.
    pub rack: Rack,
    /// Whether dragging moves balls instead of the aim.
    pub placing: bool,
    /// The ball that was taken last to be placed, by its index in the scene.
    pub chosen: Option<usize>,
    /// What can be undone.
    pub history: History,
    /// Whether the aim already suits the scene that is about to be laid out.
    pub(super) is_aimed: bool,
    /// Order of the balls in the next rack.
    seed: u64,
    /// The shot being played; gone when it is over.
    playing: Option<Shot>,
}

impl Default for Practice {
    fn default() -> Self {
        Self {
            rack: Rack::EightBall,
            placing: false,
            chosen: None,
            history: History::default(),
            is_aimed: false,
            seed: 1,
            playing: None,
        }
    }
}

impl Practice {
    /// Moves on to another order of the balls in a rack.
    pub(super) fn next_seed(&mut self) -> u64 {
        self.seed += 1;
        self.seed
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Practice>()
        .init_resource::<Turns>()
        .add_message::<PracticeCommand>()
        .add_systems(PostStartup, begin)
        .add_systems(
            FixedUpdate,
            (
                (
                    obey.run_if(on_message::<PracticeCommand>),
                    take_up.run_if(on_message::<LoadScene>),
                )
                    .chain()
                    .before(SimSystems::Strike),
                (
                    keep.run_if(on_message::<Struck>),
                    settle.run_if(on_message::<AtRest>),
                    recover
                        .run_if(on_message::<Failed>)
                        .run_if(|turns: Res<Turns>| !turns.is_on()),
                )
                    .chain()
                    .in_set(SimSystems::Judge),
            ),
        );
}

/// A table racked for the opening: what the program starts with.
#[must_use]
pub fn opening() -> Scene {
    racking::racked(
        &Scene::new(Preset::NineFoot.table(), Laws::default()),
        Preset::NineFoot.table(),
        Rack::EightBall,
        1,
    )
}

/// Points the cue at the table the program starts with.
fn begin(
    playfield: Res<Playfield>,
    balls: BallQuery,
    practice: Res<Practice>,
    mut aim: ResMut<Aim>,
    mut commands: MessageWriter<PracticeCommand>,
) {
    if balls.is_empty() {
        commands.write(PracticeCommand::Rack(practice.rack));
        return;
    }
    if playfield.solver.is_crowd() {
        return;
    }
    let scene = snapshot(&playfield, &balls);
    aim.set_speed(BREAK_SPEED);
    aim_at_next(&mut aim, &scene, practice.rack);
}

pub(super) fn aim_at_next(aim: &mut Aim, scene: &Scene, rack: Rack) {
    aim.ball = scene.ball_named("cue").unwrap_or(0);
    if let Some(heading) = target::heading(scene, aim.ball, rack) {
        aim.set_heading(heading);
    }
}

/// What a ball is put down with.
pub(super) type Placed<'w, 's> = Query<
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

/// Does what the player asked for.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
pub(super) fn obey(
    mut commands: MessageReader<PracticeCommand>,
    mut practice: ResMut<Practice>,
    mut aim: ResMut<Aim>,
    mut load: MessageWriter<LoadScene>,
    clock: Res<Clock>,
    playfield: Res<Playfield>,
    turns: Res<Turns>,
    mut balls: ParamSet<(BallQuery, Placed)>,
) {
    if turns.is_on() {
        // They were for the match.
        commands.clear();
        return;
    }
    let mut scene = snapshot(&playfield, &balls.p0());
    let mut still = !clock.moving;
    let mut reload = false;
    let mut moved = Vec::new();
    let practice = &mut *practice;
    for command in commands.read() {
        match *command {
            PracticeCommand::Retry | PracticeCommand::Undo | PracticeCommand::Redo => {
                let past = match command {
                    PracticeCommand::Retry => practice.history.retry(),
                    PracticeCommand::Redo => practice.history.redo(&scene, *aim),
                    _ => practice.history.undo(&scene, *aim),
                };
                let Some(past) = past else { continue };
                *aim = past.aim;
                practice.is_aimed = true;
                scene = Scene {
                    laws: scene.laws,
                    cue: scene.cue,
                    solver: scene.solver,
                    ..past.scene
                };
                (reload, still) = (true, true);
            }
            PracticeCommand::Rack(_) | PracticeCommand::Table(_) => {
                if !scene.balls.is_empty() {
                    practice.history.laid(scene.clone(), *aim);
                    practice.next_seed();
                }
                if scene.solver.is_crowd() {
                    // Nobody racks among thousands of balls.
                    scene = opening();
                }
                let mut table = scene.table.clone();
                match *command {
                    PracticeCommand::Rack(rack) => practice.rack = rack,
                    PracticeCommand::Table(preset) => table = preset.table(),
                    _ => {}
                }
                let equipment = Equipment {
                    table,
                    ..racking::of_scene(&scene)
                };
                scene = racking::playable(&equipment, scene.solver, practice.rack, practice.seed);
                aim.set_tip(0.0, 0.0);
                aim.set_elevation(0.0);
                aim.set_speed(BREAK_SPEED);
                aim_at_next(&mut aim, &scene, practice.rack);
                (reload, still) = (true, true);
            }
            PracticeCommand::PlaceBall { ball, x, z } if still => {
                let before = scene.clone();
                if placing::place(&mut scene, ball, DVec2::new(x, z)) {
                    practice.history.placed(ball, &before, *aim);
                    moved.push(ball);
                }
            }
            PracticeCommand::CueBallInHand if still => {
                let before = scene.clone();
                let head = scene.table.head_spot();
                if placing::place(&mut scene, aim.ball, head) {
                    practice.history.placed(aim.ball, &before, *aim);
                    moved.push(aim.ball);
                    practice.placing = true;
                }
            }
            PracticeCommand::PlaceBall { .. } | PracticeCommand::CueBallInHand => {}
        }
    }
    if reload {
        practice.playing = None;
        aim.draw_back = 0.0;
        load.write(LoadScene(scene));
    } else {
        for ball in moved {
            put_down(&mut balls.p1(), &scene, ball);
        }
    }
}

/// A shot that the solver could not follow is taken back.
fn recover(mut failed: MessageReader<Failed>, mut commands: MessageWriter<PracticeCommand>) {
    if failed.read().count() > 0 {
        commands.write(PracticeCommand::Retry);
    }
}

/// Writes the place of one ball of a scene to the world, at rest. The record of the last shot stays.
pub(super) fn put_down(balls: &mut Placed, scene: &Scene, ball: usize) {
    for (index, mut position, mut velocity, spin, mut motion) in balls.iter_mut() {
        if index.0 == ball {
            position.0 = scene.balls[ball].state.position;
            velocity.0 = default();
            motion.0 = Motion::Rest;
            if let Some(mut spin) = spin {
                spin.0 = default();
            }
        }
    }
}

/// Takes up the cue for a scene that anybody lays out: its own shot if it plans one.
pub(super) fn take_up(
    mut scenes: MessageReader<LoadScene>,
    mut practice: ResMut<Practice>,
    mut aim: ResMut<Aim>,
) {
    let Some(LoadScene(scene)) = scenes.read().last() else {
        return;
    };
    if std::mem::take(&mut practice.is_aimed) {
        return;
    }
    aim.ball = scene.ball_named("cue").unwrap_or(0);
    if let Some(planned) = scene.shot {
        aim.ball = planned.ball;
        aim.shot = planned.shot;
        aim.wish = planned.shot.elevation;
    }
}

/// Keeps the table as it was before the stroke.
fn keep(
    mut strikes: MessageReader<Strike>,
    mut practice: ResMut<Practice>,
    recorder: Res<Recorder>,
    aim: Res<Aim>,
) {
    let shot = strikes.read().last().map_or(aim.shot, |strike| strike.shot);
    practice.playing = Some(shot);
    practice.placing = false;
    if let Some(before) = &recorder.before {
        let struck = Aim {
            shot,
            draw_back: 0.0,
            ..*aim
        };
        practice.history.shot(before.clone(), struck);
    }
}

/// After a shot: a pocketed cue ball comes back to the head spot, and the cue points at the next ball unless the player
/// has aimed meanwhile.
pub(super) fn settle(
    mut practice: ResMut<Practice>,
    mut aim: ResMut<Aim>,
    playfield: Res<Playfield>,
    mut balls: ParamSet<(BallQuery, Placed)>,
) {
    let Some(shot) = practice.playing.take() else {
        return;
    };
    let mut scene = snapshot(&playfield, &balls.p0());
    let cue_ball = aim.ball;
    let pocketed = scene
        .balls
        .get(cue_ball)
        .is_some_and(|ball| !ball.state.motion.in_play());
    let head = scene.table.head_spot();
    if pocketed && placing::place(&mut scene, cue_ball, head) {
        put_down(&mut balls.p1(), &scene, cue_ball);
    }
    if aim.shot.heading.to_bits() == shot.heading.to_bits()
        && let Some(heading) = target::heading(&scene, cue_ball, practice.rack)
    {
        aim.set_heading(heading);
    }
}
