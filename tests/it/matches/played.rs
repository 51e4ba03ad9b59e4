//! The course of a match: what is refused, who breaks, who wins, what can be taken back.

use glam::DVec2;
use masse::game::matches::{Breaks, Match, Phase, Refused, Setup};
use masse::game::rules::{
    Call, Choice, EightBall, FreePractice, Game, NineBall, Reason, ThreeCushion,
};
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::record::Record;

use super::{Hand, begin, like, player, setup};

fn eight() -> Game {
    Game::EightBall(EightBall::default())
}

fn nine() -> Game {
    Game::NineBall(NineBall::default())
}

/// Plays this stroke.
fn strike(game: &mut Match, shot: Shot) -> Record {
    let record = solve(&game.scene_with(shot), Limits::default()).expect("the shot is played");
    game.played(shot, &record, 1.5).expect("a stroke is due");
    record
}

#[test]
fn what_does_not_fit_the_game_is_refused() {
    let with = |change: fn(&mut Setup)| {
        let mut setup = setup(&eight(), 3, 1);
        change(&mut setup);
        Match::new(setup, &like(&eight()))
            .expect_err("it does not fit")
            .to_string()
    };
    let one = with(|setup| setup.players.truncate(1));
    assert_eq!(one, "players: 1 players, 8-ball is for 2 to 2");
    assert_eq!(
        with(|setup| setup.race = 0),
        "race: 0 racks, at least 1 is needed"
    );
    let first = with(|setup| setup.first = 2);
    assert_eq!(first, "first: there is no player number 2, there are 2");
    let carom = like(&Game::ThreeCushion(ThreeCushion::default()));
    let error = Match::new(setup(&eight(), 1, 1), &carom).expect_err("no pockets");
    assert!(error.to_string().starts_with("table: 0 pockets"), "{error}");
    let error = Match::new(
        setup(&Game::ThreeCushion(ThreeCushion::default()), 1, 1),
        &like(&eight()),
    );
    assert!(matches!(error, Err(Refused::Table { pockets: 6, .. })));
}

#[test]
fn inputs_out_of_turn_are_refused_and_change_nothing() {
    let mut game = begin(&eight(), 3, 1);
    let before = game.clone();
    assert!(matches!(
        game.choose(Choice::Accept),
        Err(Refused::NotNow { .. })
    ));
    assert!(matches!(game.next_rack(), Err(Refused::NotNow { .. })));
    assert!(
        matches!(game.undo(0), Err(Refused::NotNow { .. })),
        "no undo was agreed on"
    );
    assert!(matches!(
        game.call(Call::PushOut),
        Err(Refused::Call { .. })
    ));
    assert!(matches!(
        game.call(Call::Pot {
            ball: 99,
            pocket: 0
        }),
        Err(Refused::Call { .. })
    ));
    assert!(matches!(
        game.call(Call::Pot { ball: 1, pocket: 6 }),
        Err(Refused::Call { .. })
    ));
    assert!(matches!(
        game.call(Call::Nominate { ball: 1 }),
        Err(Refused::Call { .. })
    ));
    for at in [
        DVec2::new(0.0, 0.0),
        DVec2::new(-1.3, 0.0),
        DVec2::new(f64::NAN, 0.0),
    ] {
        assert!(matches!(game.place(at), Err(Refused::Place { .. })), "{at}");
    }
    assert!(matches!(
        game.lay(1, DVec2::ZERO),
        Err(Refused::NotNow { .. })
    ));
    let shot = Shot {
        speed: f64::NAN,
        ..Shot::default()
    };
    assert!(matches!(
        game.played(shot, &Record::default(), 0.0),
        Err(Refused::Scene(_))
    ));
    assert!(matches!(
        game.played(Shot::default(), &Record::default(), 0.0),
        Err(Refused::Record {
            given: 0,
            count: 16
        })
    ));
    assert!(matches!(
        game.played(Shot::default(), &Record::default(), -1.0),
        Err(Refused::Thought { .. })
    ));
    assert_eq!(game, before);
}

#[test]
fn the_cue_ball_is_placed_in_the_area_and_plays_from_there() {
    let mut game = begin(&eight(), 1, 1);
    let at = DVec2::new(-0.9, 0.25);
    game.place(at).expect("behind the head string");
    let scene = game.scene_with(Shot::default());
    let cue = scene.balls[game.targets().cue].state.position;
    assert_eq!((cue.x, cue.z), (at.x, at.y));
    strike(
        &mut game,
        Shot {
            speed: 0.5,
            heading: 3.1,
            ..Shot::default()
        },
    );
    let replay = game.replay(0).expect("one shot");
    assert_eq!(replay, scene.clone_with(&replay));
}

trait CloneWith {
    fn clone_with(&self, other: &Self) -> Self;
}

impl CloneWith for masse::physics::scene::Scene {
    /// This scene with the stroke of another.
    fn clone_with(&self, other: &Self) -> Self {
        Self {
            shot: other.shot,
            ..self.clone()
        }
    }
}

#[test]
fn at_snooker_the_cue_ball_in_hand_stays_in_the_d() {
    let mut game = begin(&Game::named("snooker").expect("snooker"), 1, 1);
    let baulk = game.table().table.baulk_spot();
    game.place(baulk - DVec2::new(0.1, 0.1))
        .expect("inside the D");
    for outside in [DVec2::new(0.01, 0.0), DVec2::new(-0.21, 0.21)] {
        let refused = game.place(baulk + outside);
        assert!(matches!(
            refused,
            Err(Refused::Place {
                why: masse::game::matches::NoPlace::Outside,
                ..
            })
        ));
    }
}

#[test]
fn breaks_go_in_turn_or_to_winner_or_loser() {
    for (breaks, expected) in [
        (Breaks::Alternate, [0, 1, 0, 1]),
        (Breaks::Winner, [0, 1, 1, 1]),
        (Breaks::Loser, [0, 0, 0, 0]),
    ] {
        let mut agreed = setup(&nine(), 10, 3);
        agreed.breaks = breaks;
        let mut game = Match::new(agreed, &like(&nine())).expect("it fits");
        for breaker in expected {
            assert_eq!(game.state().standing.breaker, breaker, "{breaks:?}");
            assert!(game.targets().is_break);
            // Player 0 gives up every rack.
            while game.state().standing.turn != 0 {
                strike(
                    &mut game,
                    Shot {
                        speed: 0.3,
                        heading: 3.0,
                        ..Shot::default()
                    },
                );
                if game.phase() == Phase::Choose {
                    game.choose(Choice::Accept).expect("offered");
                }
            }
            game.concede().expect("the rack is on");
            assert_eq!(game.phase(), Phase::RackOver);
            game.next_rack().expect("the rack is over");
        }
        assert_eq!(game.racks_won(), [0, 4]);
    }
}

#[test]
fn the_race_ends_the_match() {
    let mut game = begin(&nine(), 2, 3);
    game.concede().expect("the rack is on");
    assert_eq!(game.ends()[0].over.reason, Reason::Conceded);
    game.next_rack().expect("one more to win");
    assert_eq!(game.state().standing.turn, 1);
    game.concede().expect("the rack is on");
    game.next_rack().expect("one all");
    assert_eq!((game.racks_won(), game.rack()), (vec![1, 1], 2));
    game.concede().expect("the rack is on");
    assert_eq!(game.phase(), Phase::Over { winner: Some(1) });
    assert!(game.next_rack().is_err() && game.concede().is_err());
    let shot = Shot::default();
    assert!(game.played(shot, &Record::default(), 0.0).is_err());
}

#[test]
fn racks_of_a_match_differ_and_come_again_with_the_seed() {
    let order = |seed: u64| {
        let mut game = begin(&nine(), 9, seed);
        let mut orders = vec![game.table()];
        for _ in 0..3 {
            game.concede().expect("the rack is on");
            game.next_rack().expect("not over yet");
            orders.push(game.table());
        }
        orders
    };
    let one = order(5);
    assert_eq!(one, order(5));
    assert_ne!(one, order(6));
    for (index, scene) in one.iter().enumerate() {
        assert!(one[..index].iter().all(|other| other != scene));
        let names: Vec<&str> = scene.balls.iter().map(|ball| ball.name.as_str()).collect();
        assert_eq!(
            names,
            ["cue", "1", "2", "3", "4", "5", "6", "7", "8", "9"],
            "a ball keeps its index"
        );
    }
}

#[test]
fn more_than_two_take_turns() {
    let mut agreed = setup(&nine(), 1, 3);
    agreed.players.push(player("Third"));
    let mut game = Match::new(agreed, &like(&nine())).expect("9-ball is for more than two");
    let mut seen = [0; 3];
    let mut hand = Hand::new(1);
    for _ in 0..60 {
        seen[game.state().standing.turn] += 1;
        hand.play(&mut game);
        if game.phase() != Phase::Play && game.phase() != Phase::Choose {
            break;
        }
    }
    assert!(seen.iter().all(|turns| *turns > 0), "{seen:?}");
}

#[test]
fn practice_takes_back_any_number_of_shots_and_lays_balls_anywhere() {
    let game = Game::FreePractice(FreePractice::default());
    let mut played = begin(&game, 1, 1);
    let mut hand = Hand::new(3);
    let mut past = Vec::new();
    for _ in 0..25 {
        past.push(played.clone());
        hand.play(&mut played);
    }
    for back in [1, 3, 7] {
        let mut copy = played.clone();
        copy.undo(back).expect("practice");
        let kept = &past[25 - back];
        assert_eq!(copy.shots(), kept.shots());
        assert_eq!((copy.state(), copy.ends()), (kept.state(), kept.ends()));
        let replayed = played.replay(25 - back).expect("played");
        assert_eq!(copy.table().balls, replayed.balls);
        assert_eq!(copy.statistics(), kept.statistics());
    }
    let mut copy = played.clone();
    copy.undo(25).expect("all of them");
    assert_eq!((copy.shots().len(), copy.state()), (0, past[0].state()));
    assert_eq!(
        copy.undo(1),
        Err(Refused::TooFar {
            asked: 1,
            played: 0
        })
    );
    let mut copy = past[0].clone();
    copy.lay(3, DVec2::new(0.0, 0.4)).expect("practice");
    assert_eq!(copy.table().balls[3].state.position.z, 0.4);
    assert!(matches!(
        copy.lay(2, DVec2::new(0.0, 0.41)),
        Err(Refused::Place { .. })
    ));
    assert!(matches!(
        copy.lay(99, DVec2::ZERO),
        Err(Refused::Place { .. })
    ));
}

#[test]
fn undo_goes_back_over_the_end_of_a_rack_where_it_was_agreed_on() {
    let mut agreed = setup(&nine(), 50, 3);
    agreed.undo = true;
    let mut game = Match::new(agreed, &like(&nine())).expect("it fits");
    let mut hand = Hand::new(5);
    while game.rack() < 2 {
        hand.play(&mut game);
        if game.phase() == Phase::RackOver {
            game.next_rack().expect("the rack is over");
        }
    }
    hand.play(&mut game);
    let in_second = game.shots().iter().filter(|shot| shot.rack == 2).count();
    game.undo(in_second + 1).expect("it was agreed on");
    assert_eq!((game.rack(), game.ends().len()), (1, 1));
    assert_eq!(game.phase(), Phase::Play);
    hand.play(&mut game);
}
