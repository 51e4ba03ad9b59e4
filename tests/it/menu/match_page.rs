//! A match is agreed on, begun, watched and left with keys alone.

use masse::game::aim::Aim;
use masse::game::matches::{Breaks, Mind, Player, Setup};
use masse::game::practice::{self, Practice};
use masse::game::rules::{Call, Game};
use masse::game::turns::{TurnCommand, Turns};
use masse::sim::clock::Clock;
use masse::sim::stepping;

use super::*;

fn turns(app: &App) -> &Turns {
    app.world().resource::<Turns>()
}

#[test]
fn a_match_is_begun_with_keys_alone() {
    let mut app = app();
    press(&mut app, KeyCode::Escape);
    choose(&mut app, "New match");
    assert_eq!(page(&app), Some(PageId("match")));
    choose(&mut app, "9-ball");
    choose(&mut app, "Rosa");
    choose(&mut app, "Begin");
    assert_eq!(screen(&app), Screen::Table);
    stepping::step(&mut app, 2);
    let game = turns(&app).game().expect("it has begun");
    assert_eq!(game.setup().game.rules().code().name, "9-ball");
    // The first Rosa is that of the first player, who breaks.
    assert_eq!(turns(&app).level(), Some("Rosa"));
    assert!(!turns(&app).may_strike());
    step(&mut app);

    press(&mut app, KeyCode::Escape);
    choose(&mut app, "The match");
    assert_eq!(page(&app), Some(PageId("match-report")));
    press(&mut app, KeyCode::Escape);
    press(&mut app, KeyCode::Escape);
    assert_eq!(screen(&app), Screen::Table);
    app.world_mut().write_message(TurnCommand::Leave);
    stepping::step(&mut app, 2);
    assert!(!turns(&app).is_on());
}

/// Two people at a game, without the menu.
fn between_people(app: &mut App, game: &str) {
    let person = |name: &str| Player {
        name: name.to_owned(),
        mind: Mind::Person,
    };
    let setup = Setup {
        game: Game::named(game).expect("a game"),
        players: vec![person("Ada"), person("Bob")],
        race: 2,
        breaks: Breaks::Alternate,
        first: 0,
        seed: 3,
        undo: true,
    };
    app.world_mut().write_message(TurnCommand::Begin {
        setup: Box::new(setup),
        like: Box::new(practice::opening()),
    });
    stepping::step(app, 2);
    step(app);
}

fn is_placing(app: &App) -> bool {
    app.world().resource::<Practice>().placing
}

fn is_moving(app: &App) -> bool {
    app.world().resource::<Clock>().moving
}

/// Presses a key and waits until it has come to something, and the balls rest again.
fn strike(app: &mut App) {
    press(app, KeyCode::Space);
    for wanted in [true, false] {
        for _ in 0..4000 {
            if is_moving(app) == wanted {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(2));
            step(app);
            if !wanted {
                stepping::step(app, 10);
            }
        }
        assert_eq!(is_moving(app), wanted);
    }
    stepping::step(app, 2);
    // Frames with ticks of their own: what the referee says is told in them.
    for _ in 0..20 {
        std::thread::sleep(std::time::Duration::from_millis(5));
        step(app);
    }
}

fn cue_ball(app: &App) -> glam::DVec3 {
    let game = turns(app).game().expect("a match");
    let table = game.table();
    table.balls[game.state().cue_ball(&table)].state.position
}

#[test]
fn a_cue_ball_in_hand_is_placed_and_put_down_with_keys_alone() {
    let mut app = app();
    between_people(&mut app, "9-ball");
    assert!(!is_placing(&app), "a break may be played at once");
    let before = cue_ball(&app);
    press(&mut app, KeyCode::KeyB);
    assert!(is_placing(&app));
    press(&mut app, KeyCode::ArrowRight);
    press(&mut app, KeyCode::ArrowRight);
    stepping::step(&mut app, 2);
    let moved = cue_ball(&app);
    assert!(moved != before, "{before}");
    // What strikes only puts it down; then it strikes.
    press(&mut app, KeyCode::Space);
    step(&mut app);
    assert!(!is_placing(&app) && !is_moving(&app));
    assert_eq!(turns(&app).game().expect("a match").shots().len(), 0);

    // A break that misses everything: a foul, and the other player has the cue ball in hand.
    app.world_mut()
        .resource_mut::<Aim>()
        .set_heading(std::f64::consts::PI);
    app.world_mut().resource_mut::<Aim>().set_speed(1.0);
    strike(&mut app);
    assert_eq!(turns(&app).player(), Some(1));
    assert!(is_placing(&app), "Bob places it first");
    press(&mut app, KeyCode::Period);
    assert!(!is_placing(&app), "who aims has put it down");
    press(&mut app, KeyCode::KeyB);
    assert!(is_placing(&app));
    press(&mut app, KeyCode::Escape);
    assert!(!is_placing(&app));
    assert_eq!(screen(&app), Screen::Table);

    // Nothing is in hand after a stroke without a foul; then it stays where it lies.
    strike(&mut app);
    let in_hand = turns(&app)
        .game()
        .expect("a match")
        .state()
        .standing
        .in_hand;
    press(&mut app, KeyCode::KeyB);
    assert_eq!(is_placing(&app), in_hand.is_some());
    // A key that racks again does not leave the match.
    press(&mut app, KeyCode::KeyN);
    stepping::step(&mut app, 2);
    assert!(turns(&app).is_on());
}

#[test]
fn what_is_aimed_at_is_called_with_a_key_and_the_match_is_left_with_keys() {
    let mut app = app();
    between_people(&mut app, "14.1");
    let called = |app: &App| turns(app).game().expect("a match").called();
    assert_eq!(called(&app), Call::Nothing);
    let mut seen = Vec::new();
    for _ in 0..6 {
        press(&mut app, KeyCode::Enter);
        stepping::step(&mut app, 2);
        assert!(matches!(called(&app), Call::Pot { .. }));
        assert!(!seen.contains(&called(&app)));
        seen.push(called(&app));
    }
    press(&mut app, KeyCode::Enter);
    stepping::step(&mut app, 2);
    assert_eq!(called(&app), seen[0], "after the last pocket the first");

    press(&mut app, KeyCode::Escape);
    choose(&mut app, "The match");
    choose(&mut app, "Leave the match");
    stepping::step(&mut app, 2);
    assert!(!turns(&app).is_on());
    assert_eq!(screen(&app), Screen::Table);
}
