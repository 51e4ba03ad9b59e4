//! Straight pool.

use glam::DVec2;
use masse::game::rules::{
    Area, Call, Choice, Foul, Game, GameState, Note, Over, Reason, StraightPool, TableChange,
};
use masse::physics::scene::{Rack, Scene};
use masse::physics::table::Preset;

use super::story::{Story, lay, place, pot, start};

fn rack() -> (GameState, Scene) {
    start(
        Game::StraightPool(StraightPool::default()),
        Preset::NineFoot,
    )
}

fn opened(story: Story) -> Story {
    story.cushion("cue", 0).cushion("1", 0).cushion("2", 5)
}

/// Player 1 after a good opening break, with these balls.
fn later(balls: &[(&str, f64, f64)]) -> (GameState, Scene) {
    let (state, scene) = rack();
    let (verdict, mut table) =
        opened(Story::of(&scene).meet("cue", "1")).play(&state, &Call::Nothing);
    assert_eq!(
        (
            verdict.fouls.as_slice(),
            verdict.points,
            verdict.next.standing.turn
        ),
        ([].as_slice(), vec![0, 0], 1)
    );
    lay(&mut table, balls);
    (verdict.next, table)
}

const FEW: [(&str, f64, f64); 4] = [
    ("cue", -0.3, 0.0),
    ("3", 0.0, 0.0),
    ("5", 0.0, 0.3),
    ("9", 0.3, -0.3),
];

#[test]
fn the_opening_break_calls_or_drives_cue_ball_and_two_balls() {
    let (state, scene) = rack();
    assert_eq!(scene.balls.len(), 16);
    let called = Story::of(&scene)
        .meet("cue", "1")
        .pot("7", 4)
        .judge(&state, &pot(&scene, "7", 4));
    assert_eq!(
        (called.points.as_slice(), called.next_player()),
        ([1, 0].as_slice(), 0)
    );
    let one = Story::of(&scene)
        .meet("cue", "1")
        .cushion("cue", 0)
        .cushion("1", 0);
    let without_cue = Story::of(&scene)
        .meet("cue", "1")
        .cushion("1", 0)
        .cushion("2", 0)
        .cushion("3", 0);
    for weak in [one, without_cue] {
        let verdict = weak.judge(&state, &Call::Safety);
        assert!(matches!(
            verdict.fouls[0],
            Foul::WeakBreak { needed: 3, .. }
        ));
        assert_eq!(
            (verdict.points.as_slice(), verdict.next_player()),
            ([-2, 0].as_slice(), 1)
        );
        assert_eq!(
            verdict.next.standing.choices,
            [Choice::Accept, Choice::TheyBreak]
        );
        assert_eq!(
            verdict.next.standing.fouls,
            [0, 0],
            "it does not count among fouls in a row"
        );
        let again = verdict
            .next
            .choose(&scene, Choice::TheyBreak)
            .expect("offered");
        assert_eq!((again.next_player(), again.table), (0, TableChange::Rerack));
        assert!(again.next.targets(&scene).is_break);
    }
    let scratch = opened(Story::of(&scene).meet("cue", "1"))
        .pot("cue", 0)
        .judge(&state, &Call::Safety);
    assert_eq!(scratch.points, [-1, 0]);
    assert_eq!(
        scratch.next.standing.in_hand,
        Some(Area::behind_head_string(&scene.table))
    );
}

#[test]
fn a_called_ball_makes_a_point_and_so_does_what_falls_with_it() {
    let (state, scene) = later(&FEW);
    let two = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 4)
        .pot("5", 2)
        .judge(&state, &pot(&scene, "3", 4));
    assert_eq!(
        (two.points.as_slice(), two.next_player(), two.made.len()),
        ([0, 2].as_slice(), 1, 2)
    );
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .pot("5", 2)
        .play(&state, &pot(&scene, "3", 4));
    assert_eq!(
        (verdict.points.as_slice(), verdict.next_player()),
        ([0, 0].as_slice(), 0)
    );
    assert_eq!(
        place(&table, "5"),
        scene.table.foot_spot(),
        "an uncalled ball comes back"
    );
}

#[test]
fn a_foul_costs_a_point_and_leaves_the_cue_ball() {
    let (state, scene) = later(&FEW);
    let verdict = Story::of(&scene)
        .meet("cue", "3")
        .judge(&state, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.points.as_slice()),
        ([Foul::NoCushion].as_slice(), [0, -1].as_slice())
    );
    assert_eq!(
        (verdict.next_player(), verdict.next.standing.in_hand),
        (0, None)
    );
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 4)
        .pot("cue", 2)
        .play(&state, &pot(&scene, "3", 4));
    assert_eq!(verdict.points, [0, -1]);
    assert_eq!(
        verdict.next.standing.in_hand,
        Some(Area::behind_head_string(&scene.table))
    );
    assert_eq!(place(&table, "3"), scene.table.foot_spot());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .cushion("3", 0)
        .off("5")
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.points.as_slice(), place(&table, "5")),
        ([0, -1].as_slice(), scene.table.foot_spot())
    );
}

#[test]
fn three_fouls_in_a_row_cost_fifteen_more_and_a_fresh_rack() {
    let (mut state, scene) = later(&FEW);
    state.standing.fouls[1] = 1;
    let second = Story::of(&scene).judge(&state, &Call::Nothing);
    assert_eq!(second.notes, [Note::TwoFouls { player: 1 }]);
    state.standing.fouls[1] = 2;
    let third = Story::of(&scene).judge(&state, &Call::Nothing);
    assert_eq!(third.points, [0, -16]);
    assert_eq!((third.table, third.next_player()), (TableChange::Rerack, 1));
    assert!(third.next.targets(&scene).is_break);
    assert_eq!(third.next.standing.fouls, [0, 0]);
}

/// Potting the 3 with this cue ball and this last ball left: who lies where afterwards.
fn rerack(cue: DVec2, last: DVec2) -> (GameState, Scene) {
    let (state, scene) = later(&[
        ("cue", cue.x, cue.y),
        ("3", 0.1, 0.5),
        ("9", last.x, last.y),
    ]);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 4)
        .play(&state, &pot(&scene, "3", 4));
    assert_eq!(
        (verdict.next_player(), verdict.notes.as_slice()),
        (1, [Note::Rerack].as_slice())
    );
    table.check().expect("no balls overlap");
    assert!(table.balls.iter().all(|ball| ball.state.motion.in_play()));
    (verdict.next, table)
}

#[test]
fn at_fourteen_the_rack_is_set_again_with_an_empty_apex() {
    let away = DVec2::new(0.1, -0.5);
    let (state, table) = rerack(DVec2::new(-0.1, 0.2), away);
    assert_eq!(
        (place(&table, "9"), place(&table, "cue")),
        (away, DVec2::new(-0.1, 0.2))
    );
    assert_eq!(state.standing.in_hand, None);
    let places = Rack::Straight.places(&table.table, table.balls[0].ball.radius);
    let taken = |spot: &DVec2| {
        let mut names = table.balls.iter().map(|ball| place(&table, &ball.name));
        names.any(|here| here.distance(*spot) < 1e-9)
    };
    assert!(!taken(&places[0]) && places[1..].iter().all(taken));
}

#[test]
fn the_book_says_who_goes_where_when_the_rack_is_in_the_way() {
    let table = Preset::NineFoot.table();
    let (head, center, string) = (
        table.head_spot(),
        DVec2::ZERO,
        Area::behind_head_string(&table),
    );
    let in_rack = table.foot_spot() + DVec2::new(0.06, 0.01);
    let beside = table.foot_spot() + DVec2::new(0.14, -0.01);
    let away = DVec2::new(0.1, -0.5);
    let kitchen = DVec2::new(-0.9, 0.3);
    // The last ball in the rack: to the head spot, or to the centre if the cue ball is there.
    assert_eq!(place(&rerack(away, in_rack).1, "9"), head);
    assert_eq!(place(&rerack(head, in_rack).1, "9"), center);
    // Both in the rack: fifteen balls are racked, and the cue ball is in hand.
    let (state, scene) = rerack(beside, in_rack);
    assert_eq!(state.standing.in_hand, Some(string));
    assert!(
        scene.balls[1..]
            .iter()
            .any(|ball| place(&scene, &ball.name) == table.foot_spot())
    );
    // The cue ball in the rack: in hand, or to the head spot, or to the centre.
    assert_eq!(rerack(in_rack, away).0.standing.in_hand, Some(string));
    assert_eq!(place(&rerack(in_rack, kitchen).1, "cue"), head);
    assert_eq!(place(&rerack(in_rack, head).1, "cue"), center);
}

#[test]
fn both_last_balls_in_one_stroke_bring_back_all_fifteen() {
    let (state, scene) = later(&[("cue", 0.0, 0.0), ("3", 0.1, 0.5), ("9", 0.2, 0.5)]);
    let (_, table) = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 4)
        .pot("9", 4)
        .play(&state, &pot(&scene, "3", 4));
    table.check().expect("no balls overlap");
    assert!(table.balls.iter().all(|ball| ball.state.motion.in_play()));
    assert!(
        table.balls[1..]
            .iter()
            .any(|ball| place(&table, &ball.name) == table.table.foot_spot())
    );
}

#[test]
fn the_number_agreed_on_wins() {
    let (mut state, scene) = later(&FEW);
    state.standing.scores[1] = 99;
    let verdict = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 4)
        .judge(&state, &pot(&scene, "3", 4));
    let over = Over {
        winner: Some(1),
        reason: Reason::Points { needed: 100 },
    };
    assert_eq!(verdict.next.standing.over, Some(over));
}
