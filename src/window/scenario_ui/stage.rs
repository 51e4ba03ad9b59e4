//! The scenario that lies on the table: what must happen in it, what did, and how near the player came.

use std::time::Duration;

use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::equip::OpenScene;
use crate::game::practice::{Practice, PracticeCommand};
use crate::game::studio::StudioCommand;
use crate::game::target;
use crate::physics::cue::Shot;
use crate::physics::record::EndReason;
use crate::physics::scene::{Rack, Scene};
use crate::scenarios::expect::{self, Outcome, Standing};
use crate::scenarios::file::Scenario;
use crate::scenarios::library;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, BallName};
use crate::sim::messages::{LoadScene, Struck};
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::sim::recorder::Recorder;

use super::tricks::tricks;

/// How often expectations are looked at while balls move.
const LOOK: Duration = Duration::from_millis(100);

/// Speed of the cue in m/s that somebody who tries is offered.
const TRY_SPEED: f64 = 2.5;

/// How far in m a ball may lie from where the scenario wants it, for a stroke to count as a try.
const SAME: f64 = 1e-6;

/// Whose turn it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Nobody has played yet.
    Waiting,
    /// The program shows it.
    Shown,
    /// The player tries it from where it begins.
    Tried,
    /// The player plays from another layout; nothing is scored.
    Free,
}

/// A scenario on the table.
#[derive(Clone, Debug)]
pub struct OnTable {
    /// What the library calls it, or its file, or its shared text.
    pub name: String,
    /// The scenario.
    pub scenario: Scenario,
    /// Whose turn it is.
    pub turn: Turn,
    /// What became of the expectations so far; empty before the first stroke.
    pub marks: Vec<(Outcome, Standing)>,
    /// Whether the balls rest after the shot.
    pub is_over: bool,
    /// How near the last try came, 0 to 100.
    pub score: Option<u32>,
    /// How near the best try came.
    pub best: Option<u32>,
    /// Tries so far.
    pub tries: u32,
    /// Whether the next stroke is the program's.
    is_next_shown: bool,
}

impl OnTable {
    fn new(name: &str, scenario: Scenario) -> Self {
        Self {
            name: name.to_owned(),
            scenario,
            turn: Turn::Waiting,
            marks: Vec::new(),
            is_over: false,
            score: None,
            best: None,
            tries: 0,
            is_next_shown: false,
        }
    }

    fn begin(&mut self, turn: Turn) {
        self.turn = turn;
        self.marks.clear();
        self.is_over = false;
        self.score = None;
        self.is_next_shown = turn == Turn::Shown && self.scenario.scene.shot.is_some();
    }

    /// Whether a table is that of the scenario before anything happened.
    fn begins_so(&self, scene: &Scene) -> bool {
        let wanted = &self.scenario.scene;
        wanted.table == scene.table
            && wanted.balls.len() == scene.balls.len()
            && wanted.balls.iter().zip(&scene.balls).all(|(wanted, ball)| {
                let apart = wanted.state.position.distance(ball.state.position);
                wanted.name == ball.name && apart < SAME
            })
    }

    /// The stroke as the scenario plays it; none if its balls move by themselves.
    fn aim(&self) -> Option<Aim> {
        let planned = self.scenario.scene.shot?;
        Some(Aim {
            ball: planned.ball,
            shot: planned.shot,
            wish: planned.shot.elevation,
            draw_back: 0.0,
        })
    }
}

/// The scenario on the table, if there is one.
#[derive(Resource, Debug, Default)]
pub struct Stage {
    on: Option<OnTable>,
    /// Whether the next scene that is laid out is this one.
    is_announced: bool,
    /// Whether its first camera is still to be taken.
    is_opened: bool,
    /// The aim when it lies there.
    next_aim: Option<Aim>,
}

impl Stage {
    /// The scenario on the table.
    #[must_use]
    pub fn on_table(&self) -> Option<&OnTable> {
        self.on.as_ref()
    }

    /// Whether a scenario has been opened since this was asked last.
    pub(super) fn take_opened(&mut self) -> bool {
        std::mem::take(&mut self.is_opened)
    }
}

/// What is asked of trick shots.
#[derive(Message, Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ask {
    /// Lay out a trick shot by its place in the list.
    LayOut(usize),
    /// Lay out one so many places on.
    Neighbour(i32),
    /// Play what lies on the table from its beginning.
    Play,
    /// Lay it out, with the cue somewhere.
    Try,
    /// It is a plain table again.
    Forget,
}

/// A scenario is on the table from the beginning, and is played at once.
pub(in crate::window) fn begin(world: &mut World, scenario: Scenario) {
    let mut on = OnTable::new("", scenario);
    on.begin(Turn::Shown);
    let mut stage = world.resource_mut::<Stage>();
    stage.is_opened = true;
    stage.on = Some(on);
    stage.is_announced = true;
}

/// Takes down which scene is opened; others lay it out, and tell if it is no good.
pub(super) fn open(mut asked: MessageReader<OpenScene>, mut stage: ResMut<Stage>) {
    let Some(OpenScene { name, play }) = asked.read().last() else {
        return;
    };
    let Ok(scenario) = library::open(name) else {
        return;
    };
    let mut on = OnTable::new(name, scenario);
    stage.next_aim = None;
    if *play {
        on.begin(Turn::Shown);
    } else {
        stage.next_aim = on.aim();
    }
    stage.is_announced = true;
    stage.is_opened = true;
    stage.on = Some(on);
}

/// Does what is asked.
#[expect(
    clippy::too_many_arguments,
    reason = "what a scene replaces, and with what"
)]
pub(super) fn obey(
    mut asked: MessageReader<Ask>,
    mut stage: ResMut<Stage>,
    mut practice: ResMut<Practice>,
    mut open: MessageWriter<OpenScene>,
    mut load: MessageWriter<LoadScene>,
    aim: Res<Aim>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    let stage = &mut *stage;
    for ask in asked.read() {
        let known = || {
            let name = &stage.on.as_ref()?.name;
            tricks().iter().position(|trick| trick.name == name)
        };
        let place = match *ask {
            Ask::LayOut(place) => Some(place),
            Ask::Neighbour(step) => Some(known().map_or(0, |at| {
                let step = step.rem_euclid(i32::try_from(tricks().len()).unwrap_or(1));
                (at + step.unsigned_abs() as usize) % tricks().len()
            })),
            _ => None,
        };
        if let Some(trick) = place.and_then(|place| tricks().get(place)) {
            open.write(OpenScene {
                name: trick.name.to_owned(),
                play: false,
            });
            continue;
        }
        if *ask == Ask::Forget {
            stage.on = None;
            continue;
        }
        let Some(on) = &mut stage.on else { continue };
        let scene = if *ask == Ask::Play {
            on.begin(Turn::Shown);
            stage.next_aim = None;
            on.scenario.scene.clone()
        } else {
            on.begin(Turn::Waiting);
            let scene = on.scenario.laid_out();
            stage.next_aim = Some(to_try(&scene, on.aim()));
            scene
        };
        stage.is_announced = true;
        practice.history.laid(snapshot(&playfield, &balls), *aim);
        load.write(LoadScene(scene));
    }
}

/// A stroke that gives nothing away: level, through the middle, at the nearest ball.
fn to_try(scene: &Scene, shown: Option<Aim>) -> Aim {
    let ball = shown.map_or_else(|| scene.ball_named("cue").unwrap_or(0), |aim| aim.ball);
    Aim {
        ball,
        shot: Shot {
            speed: TRY_SPEED,
            heading: target::heading(scene, ball, Rack::EightBall).unwrap_or(0.0),
            ..Shot::default()
        },
        wish: 0.0,
        draw_back: 0.0,
    }
}

/// Sees scenes come and go, and strokes.
#[expect(clippy::too_many_arguments, reason = "whatever can change the table")]
pub(super) fn watch(
    mut stage: ResMut<Stage>,
    mut aim: ResMut<Aim>,
    mut struck: MessageReader<Struck>,
    mut commands: MessageReader<PracticeCommand>,
    mut built: MessageReader<StudioCommand>,
    new: Query<(), Added<BallIndex>>,
    names: Query<&BallName>,
    playfield: Res<Playfield>,
    recorder: Res<Recorder>,
) {
    let goes_on = commands.read().fold(false, |goes_on, command| {
        use PracticeCommand::{Redo, Retry, Undo};
        goes_on | matches!(command, Retry | Undo | Redo)
    }) | (built.read().count() > 0);
    let strokes = struck.read().count();
    let stage = &mut *stage;
    if !new.is_empty() {
        if std::mem::take(&mut stage.is_announced) {
            if let Some(next) = stage.next_aim.take() {
                *aim = next;
            }
        } else if let Some(on) = &mut stage.on {
            let wanted = &on.scenario.scene;
            let is_there = |name: &str| names.iter().any(|other| other.0 == name);
            let some = wanted
                .balls
                .iter()
                .filter(|ball| is_there(&ball.name))
                .count();
            if goes_on && wanted.table == playfield.table && 2 * some >= wanted.balls.len() {
                on.begin(Turn::Waiting);
            } else {
                stage.on = None;
            }
        }
    }
    let Some(on) = &mut stage.on else { return };
    if strokes == 0 || std::mem::take(&mut on.is_next_shown) {
        return;
    }
    let begins_so = recorder
        .before
        .as_ref()
        .is_some_and(|before| on.begins_so(before));
    on.begin(if begins_so { Turn::Tried } else { Turn::Free });
    on.tries += u32::from(begins_so);
}

/// Judges the shot so far, and in the end.
pub(super) fn judge(
    mut stage: ResMut<Stage>,
    recorder: Res<Recorder>,
    clock: Res<Clock>,
    time: Res<Time<Real>>,
    mut last: Local<Duration>,
) {
    let is_announced = stage.is_announced;
    let Some(on) = &mut stage.bypass_change_detection().on else {
        return;
    };
    let is_over = !clock.moving;
    let waits = is_announced || on.turn == Turn::Waiting || on.is_over;
    if waits || (!is_over && time.elapsed() < *last + LOOK) {
        return;
    }
    *last = time.elapsed();
    let Some(before) = &recorder.before else {
        return;
    };
    if recorder.paths.is_empty() {
        // A crowd is not written down.
        return;
    }
    // As for a run without a window, the end is when the last ball comes to rest, not the end of the tick.
    let end = match recorder.events.last() {
        Some(event) if is_over => event.time,
        _ => clock.time(),
    };
    let record = recorder.record(end, is_over.then_some(EndReason::Rest));
    on.marks = expect::standings(before, &record, &on.scenario.expect, is_over);
    on.is_over = is_over;
    if is_over && on.turn == Turn::Tried && !on.marks.is_empty() {
        let outcomes: Vec<Outcome> = on
            .marks
            .iter()
            .map(|(outcome, _)| outcome.clone())
            .collect();
        let score = expect::score(&outcomes);
        on.score = Some(score);
        on.best = on.best.max(Some(score));
    }
}
