//! Trick shots and the studio in the window: a shot is chosen, shown, tried and scored; a layout is built and saved.

use bevy::prelude::*;
use bevy_egui::egui;
use masse::game::aim::Aim;
use masse::game::equip::OpenScene;
use masse::game::practice::{Practice, PracticeCommand};
use masse::game::studio::StudioCommand;
use masse::physics::scene::Rack;
use masse::scenarios::expect::Standing;
use masse::scenarios::file;
use masse::scenarios::library;
use masse::scenarios::own::Own;
use masse::sim::clock::Clock;
use masse::sim::components::BallIndex;
use masse::sim::messages::Strike;
use masse::window::page::{PageId, Screen};
use masse::window::{OnTable, OwnScenes, Stage, Turn};

use super::{
    app, choose, focused_place, for_input, page, press, screen, settle, step, tab_to, until,
};

fn on(app: &App) -> Option<&OnTable> {
    app.world().resource::<Stage>().on_table()
}

fn moving(app: &App) -> bool {
    app.world().resource::<Clock>().moving
}

fn balls(app: &mut App) -> usize {
    let world = app.world_mut();
    world.query::<&BallIndex>().iter(world).count()
}

/// The shot lies on the table and nothing moves.
fn laid_out(app: &mut App, name: &str) {
    until(app, name, |app| {
        on(app).is_some_and(|on| on.name == name && on.turn == Turn::Waiting)
            && !moving(app)
            && app.world().resource::<Messages<OpenScene>>().is_empty()
    });
    settle(app);
}

#[test]
fn a_trick_shot_is_chosen_shown_and_scored_when_the_player_tries() {
    let mut app = app();
    press(&mut app, KeyCode::Escape);
    choose(&mut app, "Trick shots");
    assert_eq!(page(&app), Some(PageId("tricks")));
    choose(&mut app, "Stop shot");
    assert_eq!(screen(&app), Screen::Table);
    laid_out(&mut app, "stop-shot");
    let scenario = library::open("stop-shot").expect("it is built in");
    let planned = scenario.scene.shot.expect("it has a shot");
    let aimed = app.world().resource::<Aim>().shot;
    // The butt of the cue may be raised where there is no room for it.
    assert_eq!(
        (aimed.heading, aimed.side, aimed.height, aimed.speed),
        (
            planned.shot.heading,
            planned.shot.side,
            planned.shot.height,
            planned.shot.speed
        )
    );

    // Shown: everything is met in the end, and nothing is scored.
    press(&mut app, KeyCode::F5);
    until(&mut app, "the end of the show", |app| {
        on(app).is_some_and(|on| on.is_over)
    });
    let shown = on(&app).expect("it is there").clone();
    assert_eq!(
        (shown.turn, shown.score, shown.tries),
        (Turn::Shown, None, 0)
    );
    assert_eq!(shown.marks.len(), scenario.expect.len());
    for (outcome, standing) in &shown.marks {
        assert_eq!(*standing, Standing::Met, "{}", outcome.sentence());
    }

    // A bad try misses; the same stroke as shown is full.
    press(&mut app, KeyCode::F6);
    laid_out(&mut app, "stop-shot");
    assert_ne!(app.world().resource::<Aim>().shot, planned.shot);
    let strike = |app: &mut App, turn: f64| {
        let mut shot = planned.shot;
        shot.heading += turn;
        app.world_mut().write_message(Strike {
            ball: planned.ball,
            shot,
        });
        until(app, "a try", |app| {
            on(app).is_some_and(|on| on.is_over && on.turn == Turn::Tried)
        });
        on(app).expect("it is there").clone()
    };
    let bad = strike(&mut app, 0.5);
    assert_eq!(bad.tries, 1);
    let low = bad.score.expect("it is scored");
    assert!(low < 90, "{low}");
    assert!(
        bad.marks
            .iter()
            .any(|(_, standing)| *standing == Standing::Missed)
    );
    app.world_mut().write_message(PracticeCommand::Retry);
    laid_out(&mut app, "stop-shot");
    let good = strike(&mut app, 0.0);
    assert_eq!(
        (good.score, good.best, good.tries),
        (Some(100), Some(100), 2)
    );

    // From where the balls lie now nothing is scored.
    app.world_mut().write_message(Strike {
        ball: planned.ball,
        shot: planned.shot,
    });
    until(&mut app, "a stroke from elsewhere", |app| {
        on(app).is_some_and(|on| on.turn == Turn::Free && on.is_over)
    });
    assert_eq!(on(&app).expect("it is there").score, None);

    // To the next one and back, and a new rack is no trick shot.
    press(&mut app, KeyCode::F4);
    laid_out(&mut app, "stun-shot");
    press(&mut app, KeyCode::F3);
    laid_out(&mut app, "stop-shot");
    app.world_mut()
        .write_message(PracticeCommand::Rack(Rack::NineBall));
    until(&mut app, "a rack", |app| on(app).is_none());
}

/// A click of the pointer.
fn click(app: &mut App, at: egui::Pos2) {
    for pressed in [true, false] {
        for_input(app, |input| {
            input.events.push(egui::Event::PointerMoved(at));
            input.events.push(egui::Event::PointerButton {
                pos: at,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: egui::Modifiers::NONE,
            });
        });
        step(app);
    }
    step(app);
}

/// Clicks on what is called so.
fn push(app: &mut App, name: &str) {
    assert!(tab_to(app, name), "{name} is not reached");
    let at = focused_place(app).center();
    click(app, at);
}

#[test]
fn a_layout_is_built_saved_and_opened_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let own = Own::in_folder(folder.path());
    let mut app = app();
    app.world_mut()
        .insert_resource(OwnScenes(Some(own.clone())));
    until(&mut app, "rest", |app| !moving(app));
    press(&mut app, KeyCode::F2);
    assert!(app.world().resource::<Practice>().placing);
    step(&mut app);
    app.world_mut()
        .write_message(StudioCommand::Add("9".to_owned()));
    until(&mut app, "another ball", |app| balls(app) == 4);
    let chosen = app.world().resource::<Practice>().chosen;
    assert_eq!(chosen, Some(3), "what is added is chosen");
    push(&mut app, "Touch rail");
    until(&mut app, "a step", |app| {
        app.world().resource::<Practice>().history.len() == 2
    });
    app.world_mut().resource_mut::<masse::window::Studio>().name = "mine".to_owned();
    app.world_mut()
        .resource_mut::<masse::window::Studio>()
        .title = "My own".to_owned();
    step(&mut app);
    push(&mut app, "Save");
    until(&mut app, "a file", |_| own.names() == ["mine"]);
    let path = own.path("mine").expect("a good name");
    let saved = file::read(&path).expect("it is good");
    assert_eq!(
        (saved.title.as_str(), saved.scene.balls.len()),
        ("My own", 4)
    );
    let shot = app.world().resource::<Aim>().shot;
    assert_eq!(saved.scene.shot.map(|planned| planned.shot), Some(shot));

    app.world_mut()
        .write_message(PracticeCommand::Rack(Rack::EightBall));
    until(&mut app, "a rack", |app| balls(app) == 16);
    let name = path.display().to_string();
    app.world_mut().write_message(OpenScene {
        name: name.clone(),
        play: false,
    });
    until(&mut app, "the layout", |app| balls(app) == 4);
    laid_out(&mut app, &name);
    assert_eq!(app.world().resource::<Aim>().shot, shot);
}
