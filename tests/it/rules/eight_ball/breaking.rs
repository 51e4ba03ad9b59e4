//! The break of 8-ball.

use masse::game::rules::{
    Area, Call, CallNeeded, Choice, EightBall, Foul, Game, GameState, Note, TableChange,
};
use masse::physics::ball::Motion;
use masse::physics::scene::{Rack, Scene};
use masse::physics::table::Preset;

use super::{drive_four, rack};
use crate::rules::story::{Story, lay, place};

#[test]
fn the_break_is_from_behind_the_head_string_at_any_ball() {
    let (state, scene) = rack();
    let on = state.targets(&scene);
    let area = Area::behind_head_string(&scene.table);
    assert_eq!(
        (on.in_hand, on.is_break, on.call_needed),
        (Some(area), true, CallNeeded::No)
    );
    assert_eq!(on.first.len(), 15, "no need to meet the apex first");
    let head = scene.table.head_spot();
    assert!(area.allows(head) && area.allows(head - 0.2) && !area.allows(head + 0.001));
    let from_side = drive_four(Story::of(&scene).meet("cue", "8"));
    assert_eq!(from_side.judge(&state, &Call::Nothing).fouls, []);
}

#[test]
fn the_rack_has_the_8_in_the_middle_and_both_kinds_in_the_back_corners() {
    for seed in 0..20 {
        let like = Scene::new(
            Preset::NineFoot.table(),
            masse::physics::laws::Laws::default(),
        );
        let (_, scene) = GameState::start(Game::EightBall(EightBall::default()), 2, 0, &like, seed);
        let places = Rack::EightBall.places(&scene.table, scene.balls[0].ball.radius);
        let number = |at: usize| {
            let mut numbers = 1..=15_u8;
            numbers.find(|number| place(&scene, &number.to_string()).distance(places[at]) < 1e-9)
        };
        assert_eq!(places[0], scene.table.foot_spot());
        assert_eq!(number(4), Some(8));
        let corners = [number(10), number(14)].map(|number| number.expect("a ball in the corner"));
        assert!((corners[0] < 8) != (corners[1] < 8), "{corners:?}");
    }
}

#[test]
fn a_pot_on_the_break_keeps_the_table_and_leaves_it_open() {
    let (state, scene) = rack();
    let verdict = Story::of(&scene)
        .meet("cue", "1")
        .pot("10", 2)
        .judge(&state, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.next_player()),
        ([].as_slice(), 0)
    );
    assert_eq!(verdict.next.standing.choices, []);
    let on = verdict.next.targets(&scene);
    assert_eq!(on.first.len(), 14, "every ball but the 8");
    assert_eq!(on.call_needed, CallNeeded::BallAndPocket);
}

#[test]
fn an_illegal_break_is_no_foul_and_gives_the_opponent_three_choices() {
    let (state, scene) = rack();
    let story = Story::of(&scene)
        .meet("cue", "1")
        .cushion("1", 0)
        .cushion("2", 0)
        .cushion("3", 5);
    // The same ball at two cushions, and the cue ball, do not make four.
    let story = story.cushion("3", 10).cushion("cue", 0);
    let (verdict, table) = story.play(&state, &Call::Nothing);
    assert_eq!(verdict.fouls, []);
    assert_eq!(verdict.notes, [Note::IllegalBreak { driven: 3 }]);
    assert_eq!(verdict.next_player(), 1);
    let choices = [Choice::Accept, Choice::Break, Choice::TheyBreak];
    assert_eq!(verdict.next.standing.choices, choices);
    let chosen = |choice| verdict.next.choose(&table, choice).expect("offered");
    assert_eq!(chosen(Choice::Accept).next_player(), 1);
    assert_eq!(chosen(Choice::Accept).table, TableChange::Keep);
    for (choice, breaker) in [(Choice::Break, 1), (Choice::TheyBreak, 0)] {
        let again = chosen(choice);
        assert_eq!(
            (again.table, again.next_player()),
            (TableChange::Rerack, breaker)
        );
        let racked = again.table_chosen(&table, &scene);
        let foot = racked.table.foot_spot();
        assert!(
            racked
                .balls
                .iter()
                .any(|ball| place(&racked, &ball.name) == foot)
        );
        assert!(again.next.targets(&racked).is_break);
    }
    assert!(
        verdict.next.choose(&table, Choice::InHand).is_none(),
        "not offered"
    );
}

#[test]
fn the_8_on_a_legal_break_is_spotted_or_the_breaker_breaks_again() {
    let (state, scene) = rack();
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "1")
        .pot("8", 2)
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.next_player(), verdict.next.standing.over),
        (0, None)
    );
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::Break]
    );
    let eight = &table.balls[table.ball_named("8").expect("an 8")];
    assert!(eight.state.motion.in_play());
    let played_on = verdict
        .next
        .choose(&table, Choice::Accept)
        .expect("offered");
    assert_eq!(
        (played_on.next_player(), played_on.table),
        (0, TableChange::Keep)
    );
    let again = verdict.next.choose(&table, Choice::Break).expect("offered");
    assert_eq!((again.next_player(), again.table), (0, TableChange::Rerack));
}

#[test]
fn the_8_on_the_break_with_a_scratch_is_spotted_for_the_opponent() {
    let (state, scene) = rack();
    let story = Story::of(&scene).meet("cue", "1").pot("8", 2).pot("cue", 0);
    let (verdict, table) = story.play(&state, &Call::Nothing);
    assert_eq!(verdict.fouls, [Foul::Scratch { pocket: 0 }]);
    assert_eq!(
        (verdict.next_player(), verdict.next.standing.over),
        (1, None)
    );
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::InHand, Choice::Break]
    );
    assert!(
        table.balls[table.ball_named("8").expect("an 8")]
            .state
            .motion
            .in_play()
    );
    let chosen = verdict
        .next
        .choose(&table, Choice::InHand)
        .expect("offered");
    let area = Area::behind_head_string(&scene.table);
    assert_eq!(chosen.next.standing.in_hand, Some(area));
    let table = chosen.table_chosen(&table, &scene);
    assert!(area.is_legal(&table, 0, place(&table, "cue")));
}

#[test]
fn balls_off_the_table_on_the_break_are_a_foul_that_may_be_accepted() {
    let (state, scene) = rack();
    let (verdict, table) = drive_four(Story::of(&scene).meet("cue", "1"))
        .off("4")
        .play(&state, &Call::Nothing);
    let off = |name: &str| Foul::BallOff {
        ball: scene.ball_named(name).expect("the ball"),
    };
    assert_eq!(verdict.fouls, [off("4")]);
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::InHand]
    );
    assert_eq!(
        table.balls[table.ball_named("4").expect("a 4")]
            .state
            .motion,
        Motion::OffTable
    );
    let (verdict, table) = drive_four(Story::of(&scene).meet("cue", "1"))
        .off("8")
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.clone(), verdict.next.standing.over),
        (vec![off("8")], None)
    );
    assert!(
        table.balls[table.ball_named("8").expect("an 8")]
            .state
            .motion
            .in_play()
    );
}

#[test]
fn another_foul_on_the_break_is_accepted_or_gives_ball_in_hand_behind_the_string() {
    let (state, scene) = rack();
    let area = Area::behind_head_string(&scene.table);
    let (verdict, _) = drive_four(Story::of(&scene).meet("cue", "1"))
        .pot("cue", 3)
        .play(&state, &Call::Nothing);
    assert_eq!(
        verdict.next.standing.in_hand,
        Some(area),
        "a cue ball in a pocket cannot be accepted"
    );
    let on = verdict.next.targets(&scene);
    assert_eq!(on.in_hand, Some(area));
    let verdict = Story::of(&scene)
        .cushion("cue", 0)
        .judge(&state, &Call::Nothing);
    assert_eq!(verdict.fouls, [Foul::NoContact]);
    assert!(verdict.next.standing.choices.contains(&Choice::Accept));
}

#[test]
fn in_hand_behind_the_string_the_first_ball_lies_past_it_or_is_met_on_the_way_back() {
    let (state, scene) = rack();
    let (verdict, mut table) = drive_four(Story::of(&scene).meet("cue", "1"))
        .pot("cue", 3)
        .play(&state, &Call::Nothing);
    lay(
        &mut table,
        &[
            ("cue", -0.9, 0.0),
            ("2", -0.8, 0.3),
            ("3", 0.5, 0.0),
            ("8", 0.9, 0.3),
        ],
    );
    let two = table.ball_named("2").expect("a 2");
    let straight = Story::of(&table).meet("cue", "2").cushion("2", 0);
    assert_eq!(
        straight.judge(&verdict.next, &Call::Nothing).fouls,
        [Foul::BehindString { hit: two }]
    );
    let and_back = Story::of(&table)
        .go("cue", 1.2, 0.0)
        .go("cue", -0.8, 0.2)
        .meet("cue", "2")
        .cushion("2", 0);
    assert_eq!(and_back.judge(&verdict.next, &Call::Nothing).fouls, []);
    let past = Story::of(&table).meet("cue", "3").cushion("3", 0);
    assert_eq!(past.judge(&verdict.next, &Call::Nothing).fouls, []);
}
