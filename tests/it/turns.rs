//! Matches at the table: the world plays what the match says, and the match hears what the world did.

use std::time::Duration;

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use glam::DVec2;
use masse::game::GamePlugin;
use masse::game::aim::Aim;
use masse::game::equip::{Equip, Told};
use masse::game::matches::{Breaks, Mind, Phase, Player, Setup, Store};
use masse::game::practice::{self, PracticeCommand};
use masse::game::replay::Replay;
use masse::game::rules::{Game, GameState};
use masse::game::turns::{MatchStore, TurnCommand, TurnNews, Turns};
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use masse::scenarios::preset;
use masse::sim::SimPlugin;
use masse::sim::clock::Clock;
use masse::sim::messages::{LoadScene, Strike};
use masse::sim::playfield::{Playfield, lay_out};
use masse::sim::stepping;

/// A table that somebody plays at; every frame takes a quarter of a second.
fn table() -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(
            250,
        )));
    app.finish();
    app.cleanup();
    lay_out(app.world_mut(), &practice::opening());
    app.update();
    app
}

fn person(name: &str) -> Player {
    Player {
        name: name.to_owned(),
        mind: Mind::Person,
    }
}

fn computer(level: &str) -> Player {
    Player {
        name: level.to_owned(),
        mind: Mind::Computer {
            level: level.to_owned(),
        },
    }
}

fn setup(game: &str, players: [Player; 2]) -> Setup {
    Setup {
        game: Game::named(game).expect("a game"),
        players: players.into(),
        race: 1,
        breaks: Breaks::Alternate,
        first: 0,
        seed: 11,
        undo: true,
    }
}

fn begin(app: &mut App, setup: Setup) {
    app.world_mut().write_message(TurnCommand::Begin {
        setup: Box::new(setup),
        like: Box::new(practice::opening()),
    });
    app.update();
    app.update();
}

fn turns(app: &App) -> &Turns {
    app.world().resource::<Turns>()
}

fn ask(app: &mut App, command: TurnCommand) {
    app.world_mut().write_message(command);
    app.update();
    app.update();
}

/// Strikes and waits until the referee has spoken.
fn strike(app: &mut App, shot: Shot) {
    let ball = app.world().resource::<Aim>().ball;
    app.world_mut().write_message(Strike { ball, shot });
    app.update();
    for _ in 0..400 {
        if !app.world().resource::<Clock>().moving {
            break;
        }
        app.update();
    }
    app.update();
}

fn refusals(app: &mut App) -> Vec<String> {
    let mut news = app.world_mut().resource_mut::<Messages<TurnNews>>();
    let news = news.drain();
    news.filter_map(|news| match news {
        TurnNews::Refused(refused) => Some(refused.to_string()),
        TurnNews::Failed(why) => Some(why.english),
        _ => None,
    })
    .collect()
}

fn lies(scene: &Scene) -> Vec<glam::DVec3> {
    scene.balls.iter().map(|ball| ball.state.position).collect()
}

#[test]
fn two_computers_play_a_rack_and_every_shot_can_be_played_again() {
    let mut app = table();
    begin(
        &mut app,
        setup("9-ball", [computer("Bea"), computer("Pip")]),
    );
    let mut frames = 0;
    while !matches!(turns(&app).phase(), Some(Phase::Over { .. })) {
        app.update();
        std::thread::sleep(Duration::from_micros(200));
        frames += 1;
        assert!(frames < 60_000, "no end: {:?}", refusals(&mut app));
    }
    let game = turns(&app).game().expect("it is still there");
    assert!(game.ends()[0].over.winner.is_some());
    assert!(!game.shots().is_empty());
    for (index, shot) in game.shots().iter().enumerate() {
        let scene = game.replay(index).expect("it was played");
        let record = solve(&scene, Limits::default()).expect("it was played");
        let verdict = shot.before.judge(&scene, &record, &shot.call);
        assert_eq!(verdict.fouls, shot.fouls, "shot {index}");
        assert_eq!(verdict.pocketed, shot.pocketed, "shot {index}");
    }
    // What the match holds is what lies on the table.
    let table = game.table();
    assert_eq!(lies(&stepping::scene(&mut app)), lies(&table));
}

#[test]
fn a_stroke_is_judged_in_turn_and_vetoed_out_of_turn() {
    let mut app = table();
    begin(&mut app, setup("8-ball", [person("Ada"), person("Bob")]));
    assert!(turns(&app).may_strike());
    let racked = lies(&turns(&app).game().expect("a match").table());
    let soft = Shot {
        speed: 0.5,
        ..Shot::default()
    };
    let ball = app.world().resource::<Aim>().ball;
    app.world_mut().write_message(Strike {
        ball: ball + 1,
        shot: soft,
    });
    app.update();
    assert!(!app.world().resource::<Clock>().moving, "not the cue ball");
    strike(&mut app, soft);
    let said = turns(&app).said().expect("the referee spoke").clone();
    assert_eq!(said.0, 0, "the first player broke");
    assert_eq!(turns(&app).game().expect("a match").shots().len(), 1);
    assert_ne!(lies(&stepping::scene(&mut app)), racked);
    // After a break that soft the other player has something to choose first.
    assert_eq!(turns(&app).phase(), Some(Phase::Choose));
    assert!(!turns(&app).may_strike());
    app.world_mut().write_message(Strike {
        ball,
        shot: Shot {
            speed: 3.0,
            ..Shot::default()
        },
    });
    app.update();
    assert!(!app.world().resource::<Clock>().moving, "there is a choice");
    assert_eq!(turns(&app).game().expect("a match").shots().len(), 1);
}

#[test]
fn going_back_brings_back_the_table_of_the_last_own_stroke() {
    let mut app = table();
    begin(&mut app, setup("8-ball", [person("Ada"), person("Bob")]));
    let racked = lies(&stepping::scene(&mut app));
    let shot = app.world().resource::<Aim>().shot;
    strike(&mut app, shot);
    assert_ne!(lies(&stepping::scene(&mut app)), racked);
    app.world_mut().write_message(PracticeCommand::Undo);
    app.update();
    app.update();
    assert_eq!(lies(&stepping::scene(&mut app)), racked);
    assert!(turns(&app).game().expect("a match").shots().is_empty());
    assert_eq!(refusals(&mut app), Vec::<String>::new());
}

#[test]
fn only_a_cue_ball_in_hand_is_put_down_and_only_where_it_may_lie() {
    let mut app = table();
    begin(&mut app, setup("9-ball", [person("Ada"), person("Bob")]));
    let state: GameState = turns(&app).game().expect("a match").state().clone();
    let area = state.standing.in_hand.expect("the break is from in hand");
    let at = DVec2::new(0.4, 0.1);
    assert!(!area.allows(at));
    let cue = app.world().resource::<Aim>().ball;
    let put = |ball| PracticeCommand::PlaceBall {
        ball,
        x: at.x,
        z: at.y,
    };
    app.world_mut().write_message(put(cue));
    app.update();
    let lies = stepping::scene(&mut app).balls[cue].state.position;
    assert!(area.allows(DVec2::new(lies.x, lies.z)), "{lies}");
    assert!((lies.z - at.y).abs() < 1e-9, "as near as it may: {lies}");
    assert_eq!(refusals(&mut app), Vec::<String>::new());
    app.world_mut().write_message(put(cue + 1));
    app.update();
    assert_eq!(refusals(&mut app).len(), 1);
}

#[test]
fn a_match_saves_itself_and_goes_on_where_it_was() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::in_folder(folder.path());
    let mut app = table();
    app.insert_resource(MatchStore(Some(store.clone())));
    begin(&mut app, setup("9-ball", [person("Ada"), person("Bob")]));
    let shot = app.world().resource::<Aim>().shot;
    strike(&mut app, shot);
    let played = turns(&app).game().expect("a match").clone();
    assert_eq!(played.shots().len(), 1);
    // Whoever ends the program waits for the last save.
    app.world_mut().write_message(AppExit::Success);
    app.update();

    let mut fresh = table();
    ask(&mut fresh, TurnCommand::Resume);
    assert_eq!(refusals(&mut fresh).len(), 1, "nothing is saved here");
    fresh.insert_resource(MatchStore(Some(store)));
    ask(&mut fresh, TurnCommand::Resume);
    assert_eq!(turns(&fresh).game(), Some(&played));
    assert_eq!(lies(&stepping::scene(&mut fresh)), lies(&played.table()));
}

#[test]
fn a_folder_that_cannot_be_written_is_told_of_once_and_loses_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("matches");
    std::fs::write(&place, "a file where the folder should be").expect("the test may write");
    let mut app = table();
    app.insert_resource(MatchStore(Some(Store::in_folder(&place))));
    let mut agreed = setup("9-ball", [person("Ada"), person("Bob")]);
    agreed.race = 2;
    begin(&mut app, agreed);
    let told = |app: &mut App, command| {
        app.world_mut().write_message(command);
        // A save may still be under way.
        for _ in 0..200 {
            std::thread::sleep(Duration::from_millis(5));
            app.update();
            let mut news = app.world_mut().resource_mut::<Messages<TurnNews>>();
            let news: Vec<TurnNews> = news.drain().collect();
            let again = news.iter().any(|news| matches!(news, TurnNews::SavedAgain));
            let unsaved = news
                .iter()
                .any(|news| matches!(news, TurnNews::NotSaved(_)));
            if again || unsaved {
                return Some(again);
            }
        }
        None
    };
    let failed = told(&mut app, TurnCommand::Concede);
    assert_eq!(failed, Some(false), "it cannot be saved");
    assert_eq!(turns(&app).game().map(|game| game.ends().len()), Some(1));
    std::fs::remove_file(&place).expect("the test may remove");
    let again = told(&mut app, TurnCommand::NextRack);
    assert_eq!(again, Some(true), "it can be saved again");
    let saved = Store::in_folder(&place).load("autosave").expect("whole");
    assert_eq!(Some(&saved), turns(&app).game());
}

#[test]
fn a_shot_of_the_match_is_shown_again_and_the_table_comes_back() {
    let mut app = table();
    begin(&mut app, setup("9-ball", [person("Ada"), person("Bob")]));
    for _ in 0..2 {
        while turns(&app).phase() == Some(Phase::Choose) {
            let choice = turns(&app)
                .game()
                .expect("a match")
                .state()
                .standing
                .choices[0];
            ask(&mut app, TurnCommand::Choose(choice));
        }
        let shot = app.world().resource::<Aim>().shot;
        strike(&mut app, shot);
    }
    let lay = lies(&stepping::scene(&mut app));
    ask(&mut app, TurnCommand::Watch(0));
    assert!(app.world().resource::<Replay>().is_active());
    assert_ne!(lies(&stepping::scene(&mut app)), lay);
    app.world_mut()
        .write_message(masse::game::replay::ReplayCommand::Stop);
    app.update();
    app.update();
    assert_eq!(lies(&stepping::scene(&mut app)), lay);
}

#[test]
fn what_cannot_be_played_is_refused_and_the_table_stays() {
    let mut app = table();
    let before = lies(&stepping::scene(&mut app));
    let without_pockets = Scene::new(
        Preset::Box {
            length: 2.0,
            width: 1.0,
        }
        .table(),
        Laws::default(),
    );
    app.world_mut().write_message(TurnCommand::Begin {
        setup: Box::new(setup("9-ball", [person("Ada"), person("Bob")])),
        like: Box::new(without_pockets),
    });
    app.update();
    app.update();
    assert_eq!(refusals(&mut app).len(), 1);
    assert!(!turns(&app).is_on());
    ask(&mut app, TurnCommand::Undo);
    ask(&mut app, TurnCommand::NextRack);
    assert_eq!(refusals(&mut app).len(), 1, "no match is on");
    assert_eq!(lies(&stepping::scene(&mut app)), before);
    begin(
        &mut app,
        setup("9-ball", [computer("Nobody"), person("Bob")]),
    );
    assert_eq!(refusals(&mut app).len(), 1, "no such level");
}

#[test]
fn a_match_is_played_with_what_was_agreed_on() {
    let mut app = table();
    begin(&mut app, setup("9-ball", [person("Ada"), person("Bob")]));
    let agreed = stepping::scene(&mut app);
    let bar_box = preset::open("bar_box").expect("a preset").equipment;
    app.world_mut().write_message(Equip {
        equipment: bar_box.clone(),
        rack: false,
    });
    app.update();
    app.update();
    let mut told = app.world_mut().resource_mut::<Messages<Told>>();
    assert_eq!(told.drain().filter(|told| told.is_failure).count(), 1);
    assert_eq!(stepping::scene(&mut app), agreed);
    // Whoever gets past that plays with the laws of the match all the same.
    app.world_mut().resource_mut::<Playfield>().laws = Laws::ideal();
    let shot = app.world().resource::<Aim>().shot;
    strike(&mut app, shot);
    assert_eq!(app.world().resource::<Playfield>().laws, agreed.laws);
    let game = turns(&app).game().expect("a match").clone();
    assert_eq!(game.shots().len(), 1);
    // Another scene on the table ends it.
    let scene = bar_box.scene();
    app.world_mut().write_message(LoadScene(scene));
    app.update();
    app.update();
    assert!(!turns(&app).is_on());
}

#[test]
fn who_practises_for_points_may_change_the_equipment_and_leaves_for_the_open_table() {
    let mut app = table();
    let mut alone = setup("practice", [person("Ada"), person("Bob")]);
    alone.players.truncate(1);
    begin(&mut app, alone);
    assert!(turns(&app).is_on() && !turns(&app).is_agreed());
    app.world_mut().resource_mut::<Playfield>().laws = Laws::ideal();
    let shot = app.world().resource::<Aim>().shot;
    strike(&mut app, shot);
    assert!(!turns(&app).is_on());
    assert_eq!(app.world().resource::<Playfield>().laws, Laws::ideal());
}
