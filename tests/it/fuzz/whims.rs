//! Players who ask for anything at any time: at an open table and in a match, with frames of any length.

use std::time::Duration;

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use masse::game::GamePlugin;
use masse::game::equip::Equip;
use masse::game::matches::{Breaks, Setup};
use masse::game::practice::{self, PracticeCommand};
use masse::game::replay::ReplayCommand;
use masse::game::rules::{Call, Choice, Game};
use masse::game::turns::{TurnCommand, Turns};
use masse::physics::cue::Shot;
use masse::physics::laws::cluster::DEEP;
use masse::physics::scene::{Rack, Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::scenarios::{library, preset};
use masse::sim::SimPlugin;
use masse::sim::clock::Clock;
use masse::sim::messages::{Failed, LoadScene, Strike};
use masse::sim::playfield::lay_out;
use masse::sim::stepping;

use super::attack;
use crate::matches::player;

/// What a player may come upon.
#[derive(Clone, Debug)]
enum Whim {
    /// Strike this ball, aimed at another or not.
    Strike(Index, Shot),
    Practice(PracticeCommand),
    /// Put a ball down here, as shares of the table.
    Put(Index, f64, f64),
    Replay(ReplayCommand),
    Begin(Index, u64),
    Turn(TurnCommand),
    /// Take the choice of this number, offered or not.
    Choose(Index),
    Call(Index, Index, u8),
    Open(Index, bool),
    Equip(Index, bool),
    /// Let so many frames of so many seconds go by.
    Wait(u8, f64),
}

fn shot() -> impl Strategy<Value = Shot> {
    let english = || prop_oneof![Just(0.0), -0.6..0.6_f64];
    let speed = prop_oneof![4 => 0.0..8.0_f64, 1 => Just(0.0), 1 => 8.0..20.0_f64];
    let elevation = prop_oneof![3 => Just(0.0), 1 => 0.0..1.5_f64];
    (-4.0..4.0_f64, elevation, english(), english(), speed).prop_map(
        |(heading, elevation, side, height, speed)| Shot {
            heading,
            elevation,
            side,
            height,
            speed,
        },
    )
}

fn whim() -> impl Strategy<Value = Whim> {
    let place = || prop_oneof![6 => -0.7..0.7_f64, 1 => select(vec![f64::NAN, f64::INFINITY, -1e300, 0.0, 0.5])];
    let practice = prop_oneof![
        3 => Just(PracticeCommand::Undo),
        2 => Just(PracticeCommand::Redo),
        2 => Just(PracticeCommand::Retry),
        1 => Just(PracticeCommand::CueBallInHand),
        1 => select(Rack::ALL.to_vec()).prop_map(PracticeCommand::Rack),
        1 => select(Preset::NAMED.to_vec()).prop_map(PracticeCommand::Table),
    ];
    let replay = prop_oneof![
        2 => Just(ReplayCommand::Start),
        1 => Just(ReplayCommand::Stop),
        1 => Just(ReplayCommand::TogglePlay),
        1 => Just(ReplayCommand::ToggleLoop),
        1 => place().prop_map(ReplayCommand::Seek),
        1 => place().prop_map(|rate| ReplayCommand::Rate(8.0 * rate)),
        1 => any::<bool>().prop_map(ReplayCommand::StepEvent),
    ];
    let turn = prop_oneof![
        2 => Just(TurnCommand::Undo),
        2 => Just(TurnCommand::NextRack),
        1 => Just(TurnCommand::Concede),
        1 => Just(TurnCommand::Leave),
        1 => Just(TurnCommand::Resume),
        1 => Just(TurnCommand::Hurry),
        1 => (0..5_usize).prop_map(TurnCommand::Watch),
    ];
    // A frame of ten seconds is a machine that slept; one of nothing, a clock that stood or went back.
    let length = select(vec![0.0, 1e-6, 0.016, 0.25, 0.25, 0.25, 10.0]);
    prop_oneof![
        6 => (any::<Index>(), shot()).prop_map(|(ball, shot)| Whim::Strike(ball, shot)),
        3 => practice.prop_map(Whim::Practice),
        3 => (any::<Index>(), place(), place()).prop_map(|(ball, x, z)| Whim::Put(ball, x, z)),
        2 => replay.prop_map(Whim::Replay),
        2 => (any::<Index>(), any::<u64>()).prop_map(|(game, seed)| Whim::Begin(game, seed)),
        3 => turn.prop_map(Whim::Turn),
        2 => any::<Index>().prop_map(Whim::Choose),
        2 => (any::<Index>(), any::<Index>(), 0..5_u8).prop_map(|(a, b, kind)| Whim::Call(a, b, kind)),
        1 => (any::<Index>(), any::<bool>()).prop_map(|(scene, steps)| Whim::Open(scene, steps)),
        1 => (any::<Index>(), any::<bool>()).prop_map(|(name, rack)| Whim::Equip(name, rack)),
        8 => (1..60_u8, length).prop_map(|(frames, length)| Whim::Wait(frames, length)),
    ]
}

fn setup(game: Game, seed: u64) -> Setup {
    let players = 2.clamp(
        *game.rules().players().start(),
        *game.rules().players().end(),
    );
    Setup {
        game,
        players: (0..players).map(|i| player(&i.to_string())).collect(),
        race: 2,
        breaks: Breaks::Alternate,
        first: 0,
        seed,
        undo: seed.is_multiple_of(2),
    }
}

/// A table that somebody plays at.
pub(crate) fn table() -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin));
    app.finish();
    app.cleanup();
    lay_out(app.world_mut(), &practice::opening());
    frame(&mut app, 0.016);
    app
}

pub(crate) fn frame(app: &mut App, length: f64) {
    app.insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs_f64(
        length,
    )));
    app.update();
}

/// A scene of the library that is no crowd, or none.
fn scene_of(index: &Index, steps: bool) -> Option<Scene> {
    let built_in = index.get(library::BUILT_IN);
    let mut scene = built_in.scenario().ok()?.scene;
    if scene.solver.is_crowd() {
        return None;
    }
    if steps {
        scene.solver = Solver::Stepped(Stepped::default());
    }
    Some(scene)
}

/// Does as asked; what is not allowed now is for the game to refuse.
fn ask(app: &mut App, whim: &Whim) {
    let scene = stepping::scene(app);
    let (balls, half) = (scene.balls.len(), [scene.table.length, scene.table.width]);
    // One in so many asks for a ball that is not there.
    let ball = |index: &Index| index.index(balls + 1);
    let world = app.world_mut();
    match whim {
        Whim::Strike(index, shot) => {
            let ball = ball(index);
            world.write_message(Strike { ball, shot: *shot });
        }
        Whim::Practice(command) => {
            world.write_message(*command);
        }
        Whim::Put(index, x, z) => {
            let (ball, x, z) = (ball(index), x * half[0], z * half[1]);
            world.write_message(PracticeCommand::PlaceBall { ball, x, z });
        }
        Whim::Replay(command) => {
            world.write_message(*command);
        }
        Whim::Begin(index, seed) => {
            let game = index.get(&Game::all()).clone();
            world.write_message(TurnCommand::Begin {
                setup: Box::new(setup(game, *seed)),
                like: Box::new(scene),
            });
        }
        Whim::Turn(command) => {
            world.write_message(command.clone());
        }
        Whim::Choose(index) => {
            let turns = world.resource::<Turns>();
            let offered = turns
                .game()
                .map(|game| game.state().standing.choices.clone())
                .unwrap_or_default();
            let all = offered.into_iter().chain([
                Choice::Accept,
                Choice::InHand,
                Choice::PutBack,
                Choice::TheyBreak,
            ]);
            let choice = *index.get(&all.collect::<Vec<_>>());
            world.write_message(TurnCommand::Choose(choice));
        }
        Whim::Call(a, b, kind) => {
            let (ball, pocket) = (ball(a), b.index(7));
            world.write_message(TurnCommand::Call(match kind {
                0 => Call::Nothing,
                1 => Call::Nominate { ball },
                2 => Call::Safety,
                3 => Call::PushOut,
                _ => Call::Pot { ball, pocket },
            }));
        }
        Whim::Open(index, steps) => {
            if let Some(scene) = scene_of(index, *steps) {
                world.write_message(LoadScene(scene));
            }
        }
        Whim::Equip(index, rack) => {
            let preset = index.get(preset::BUILT_IN).preset();
            let preset = preset.expect("it is built in");
            world.write_message(Equip {
                equipment: preset.equipment,
                rack: *rack,
            });
        }
        Whim::Wait(..) => {}
    }
    let (frames, length) = match whim {
        Whim::Wait(frames, length) => (*frames, *length),
        _ => (2, 0.016),
    };
    for _ in 0..frames {
        frame(app, length);
    }
}

/// What must hold whatever was asked for.
fn check(app: &mut App) -> Result<(), String> {
    let failed = app
        .world_mut()
        .resource_mut::<Messages<Failed>>()
        .drain()
        .last();
    if let Some(failed) = failed {
        return Err(format!("at {} s: {}", failed.time, failed.reason));
    }
    let scene = stepping::scene(app);
    if scene.balls.is_empty() {
        return Err("no ball is left".to_owned());
    }
    for (one, ball) in scene.balls.iter().enumerate() {
        let state = &ball.state;
        if !state.is_finite() {
            return Err(format!("ball {} is nowhere: {state:?}", ball.name));
        }
        for other in &scene.balls[..one] {
            let reach = ball.ball.radius + other.ball.radius;
            let distance = state.position.distance(other.state.position);
            if state.motion.in_play() && other.state.motion.in_play() && reach - distance > DEEP {
                let deep = reach - distance;
                return Err(format!("{} is {deep} m in {}", ball.name, other.name));
            }
        }
    }
    // A table at rest can be played on.
    if app.world().resource::<Clock>().moving {
        return Ok(());
    }
    scene.check().map_err(|error| error.to_string())
}

#[test]
fn whatever_players_ask_for_the_table_can_be_played_on() {
    attack(40, &prop::collection::vec(whim(), 1..40), |whims| {
        let mut app = table();
        for (place, whim) in whims.iter().enumerate() {
            ask(&mut app, whim);
            check(&mut app).map_err(|error| format!("after {place}, {whim:?}: {error}"))?;
        }
        Ok(())
    });
}
