//! 8-ball, WPA 2025.

mod breaking;

use masse::game::rules::eight_ball::Phase;
use masse::game::rules::{
    Area, Call, EightBall, EightFirst, Foul, Game, GameState, Note, Over, Reason, TableChange,
};
use masse::physics::ball::Motion;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

use crate::rules::story::{Story, lay, pot, start};

fn rack() -> (GameState, Scene) {
    start(Game::EightBall(EightBall::default()), Preset::NineFoot)
}

/// Four balls to cushions.
fn drive_four(story: Story) -> Story {
    story
        .cushion("1", 0)
        .cushion("2", 0)
        .cushion("3", 5)
        .cushion("9", 10)
}

/// Player 1 at an open table with these balls.
fn open(balls: &[(&str, f64, f64)]) -> (GameState, Scene) {
    let (state, scene) = rack();
    let (verdict, mut scene) =
        drive_four(Story::of(&scene).meet("cue", "1")).play(&state, &Call::Nothing);
    assert_eq!(verdict.fouls, []);
    assert_eq!(verdict.next_player(), 1);
    lay(&mut scene, balls);
    (verdict.next, scene)
}

/// Player 1 has the solids, and is at the table with these balls.
fn solids(balls: &[(&str, f64, f64)]) -> (GameState, Scene) {
    let (state, mut scene) = open(&[("cue", 0.0, 0.0), ("1", 0.5, 0.0), ("8", 0.9, 0.3)]);
    let story = Story::of(&scene).meet("cue", "1").pot("1", 5);
    let verdict = story.judge(&state, &pot(&scene, "1", 5));
    assert_eq!(
        verdict.notes,
        [Note::Group {
            player: 1,
            solids: true
        }]
    );
    lay(&mut scene, balls);
    (verdict.next, scene)
}

const FEW: [(&str, f64, f64); 6] = [
    ("cue", 0.0, 0.0),
    ("2", 0.5, 0.0),
    ("3", 0.5, 0.3),
    ("9", 0.8, -0.3),
    ("10", -0.8, -0.3),
    ("8", 0.9, 0.3),
];

fn lost(verdict: &masse::game::rules::Verdict, scene: &Scene) {
    let ball = scene.ball_named("8").expect("there is an 8");
    let reason = Reason::LosingBall { ball };
    assert_eq!(
        verdict.next.standing.over,
        Some(Over {
            winner: Some(0),
            reason
        })
    );
}

#[test]
fn an_open_table_is_closed_by_the_first_called_pot() {
    let (state, scene) = open(&FEW);
    let story = Story::of(&scene).meet("cue", "9").pot("9", 4);
    let verdict = story.judge(&state, &pot(&scene, "9", 4));
    assert_eq!(
        verdict.notes,
        [Note::Group {
            player: 1,
            solids: false
        }]
    );
    assert_eq!((verdict.next_player(), verdict.made.len()), (1, 1));
    // What falls on the break, or uncalled, fixes nothing.
    let verdict = story.judge(&state, &pot(&scene, "9", 5));
    let nine = scene.ball_named("9").expect("a 9");
    assert_eq!(verdict.notes, [Note::NotCalled { balls: vec![nine] }]);
    assert_eq!(verdict.next_player(), 0);
    assert_eq!(verdict.next.targets(&scene).first.len(), 4);
    // A solid first for a stripe is fine.
    let combination = Story::of(&scene)
        .meet("cue", "2")
        .meet("2", "9")
        .pot("9", 4);
    assert_eq!(
        combination
            .judge(&state, &pot(&scene, "9", 4))
            .next_player(),
        1
    );
}

#[test]
fn the_8_first_on_an_open_table_is_what_the_switch_says() {
    let (state, scene) = open(&FEW);
    let story = Story::of(&scene).meet("cue", "8").cushion("8", 0);
    let verdict = story.judge(&state, &Call::Nothing);
    assert!(
        matches!(verdict.fouls.as_slice(), [Foul::WrongBall { .. }]),
        "{:?}",
        verdict.fouls
    );
    let mut lenient = state;
    lenient.game = Game::EightBall(EightBall {
        eight_first_on_open: EightFirst::Legal,
        phase: Phase::Open,
        ..EightBall::default()
    });
    assert_eq!(story.judge(&lenient, &Call::Nothing).fouls, []);
    assert!(
        lenient
            .targets(&scene)
            .first
            .contains(&scene.ball_named("8").expect("an 8"))
    );
}

#[test]
fn the_8_first_may_be_legal_without_scoring() {
    let (mut state, scene) = open(&FEW);
    let story = Story::of(&scene)
        .meet("cue", "8")
        .meet("8", "9")
        .pot("9", 4);
    for (eight_first_on_open, next, foul) in [
        (EightFirst::Foul, 0, true),
        (EightFirst::NoScore, 0, false),
        (EightFirst::Legal, 1, false),
    ] {
        state.game = Game::EightBall(EightBall {
            eight_first_on_open,
            phase: Phase::Open,
            ..EightBall::default()
        });
        let verdict = story.judge(&state, &pot(&scene, "9", 4));
        assert_eq!((verdict.next_player(), verdict.is_foul()), (next, foul));
    }
}

#[test]
fn later_the_own_group_is_met_first_and_then_the_8() {
    let (state, scene) = solids(&FEW);
    let verdict = Story::of(&scene)
        .meet("cue", "9")
        .cushion("9", 0)
        .judge(&state, &Call::Nothing);
    let sentence = verdict.fouls[0].sentence(&scene);
    assert_eq!(
        sentence,
        "Wrong ball first: the cue ball met the 9 first, on was the 2 or the 3."
    );
    assert_eq!(
        verdict.next.standing.in_hand,
        Some(Area::anywhere(&scene.table))
    );
    // Both at once: the player is given the right one.
    let both = Story::of(&scene)
        .meet("cue", "9")
        .also_meet("cue", "2")
        .cushion("2", 0);
    assert_eq!(both.judge(&state, &Call::Nothing).fouls, []);
    let (state, scene) = solids(&[("cue", 0.0, 0.0), ("9", 0.5, 0.0), ("8", 0.9, 0.3)]);
    let on = state.targets(&scene);
    assert_eq!(
        (on.first.len(), on.pot[0]),
        (1, scene.ball_named("8").expect("an 8"))
    );
}

#[test]
fn obvious_shots_need_no_call_but_banks_kisses_and_combinations_do() {
    let (state, scene) = solids(&FEW);
    let turn = |story: Story| story.judge(&state, &Call::Nothing).next_player();
    assert_eq!(turn(Story::of(&scene).meet("cue", "2").pot("2", 4)), 1);
    assert_eq!(
        turn(
            Story::of(&scene)
                .meet("cue", "2")
                .cushion("2", 0)
                .pot("2", 4)
        ),
        0,
        "bank"
    );
    assert_eq!(
        turn(
            Story::of(&scene)
                .meet("cue", "3")
                .meet("3", "2")
                .pot("2", 4)
        ),
        0,
        "combination"
    );
    assert_eq!(
        turn(
            Story::of(&scene)
                .meet("cue", "2")
                .meet("2", "9")
                .pot("2", 4)
        ),
        0,
        "kiss"
    );
    assert_eq!(
        turn(
            Story::of(&scene)
                .cushion("cue", 0)
                .meet("cue", "2")
                .pot("2", 4)
        ),
        0,
        "kick"
    );
    // Called, each of them counts; details of cushions are never called.
    let bank = Story::of(&scene)
        .meet("cue", "2")
        .cushion("2", 0)
        .pot("2", 4);
    assert_eq!(bank.judge(&state, &pot(&scene, "2", 4)).next_player(), 1);
}

#[test]
fn a_called_safety_passes_the_turn_and_the_ball_stays_down() {
    let (state, scene) = solids(&FEW);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "2")
        .pot("2", 4)
        .play(&state, &Call::Safety);
    assert_eq!(
        (verdict.next_player(), verdict.notes),
        (0, vec![Note::Safety])
    );
    assert_eq!(
        table.balls[table.ball_named("2").expect("a 2")]
            .state
            .motion,
        Motion::Pocketed
    );
}

#[test]
fn a_foul_gives_ball_in_hand_anywhere_and_never_loses_by_number() {
    let (mut state, scene) = solids(&FEW);
    for _ in 0..8 {
        let verdict = Story::of(&scene)
            .meet("cue", "2")
            .pot("cue", 4)
            .judge(&state, &Call::Nothing);
        assert_eq!(
            verdict.next.standing.in_hand,
            Some(Area::anywhere(&scene.table))
        );
        assert_eq!(verdict.next.standing.over, None, "no rule of three fouls");
        state = verdict.next;
        state.standing.turn = 1;
    }
}

#[test]
fn the_8_wins_when_called_and_loses_in_every_other_way() {
    let (state, scene) = solids(&[("cue", 0.0, 0.0), ("9", 0.5, 0.0), ("8", 0.9, 0.3)]);
    let eight = scene.ball_named("8").expect("an 8");
    let story = Story::of(&scene).meet("cue", "8").pot("8", 5);
    let verdict = story.judge(&state, &pot(&scene, "8", 5));
    let reason = Reason::WinningBall { ball: eight };
    assert_eq!(
        verdict.next.standing.over,
        Some(Over {
            winner: Some(1),
            reason
        })
    );
    assert_eq!(
        story.judge(&state, &Call::Nothing).next.standing.over,
        verdict.next.standing.over
    );
    lost(&story.judge(&state, &pot(&scene, "8", 4)), &scene);
    lost(&story.judge(&state, &Call::Safety), &scene);
    let call = pot(&scene, "8", 5);
    lost(
        &Story::of(&scene)
            .meet("cue", "8")
            .pot("8", 5)
            .pot("cue", 0)
            .judge(&state, &call),
        &scene,
    );
    lost(
        &Story::of(&scene)
            .meet("cue", "8")
            .off("8")
            .judge(&state, &call),
        &scene,
    );
    let (state, scene) = solids(&FEW);
    lost(
        &Story::of(&scene)
            .meet("cue", "2")
            .meet("2", "8")
            .pot("8", 5)
            .judge(&state, &call),
        &scene,
    );
    let last = Story::of(&scene)
        .meet("cue", "2")
        .pot("2", 4)
        .pot("3", 4)
        .pot("8", 5);
    lost(&last.judge(&state, &pot(&scene, "2", 4)), &scene);
}

#[test]
fn a_scratch_at_the_8_that_stays_up_is_only_a_foul() {
    let (state, scene) = solids(&[("cue", 0.0, 0.0), ("9", 0.5, 0.0), ("8", 0.9, 0.3)]);
    let verdict = Story::of(&scene)
        .meet("cue", "8")
        .pot("cue", 0)
        .judge(&state, &pot(&scene, "8", 5));
    assert_eq!(
        (verdict.next.standing.over, verdict.next_player()),
        (None, 0)
    );
}

#[test]
fn a_stalemate_is_warned_of_and_then_the_same_player_breaks_again() {
    let (mut state, scene) = solids(&FEW);
    let mut warnings = 0;
    for turn in 1..200 {
        let name = if state.standing.turn == 1 { "2" } else { "9" };
        let verdict = Story::of(&scene)
            .meet("cue", name)
            .cushion(name, 0)
            .judge(&state, &Call::Safety);
        warnings += usize::from(verdict.notes.contains(&Note::StalemateWarning));
        if verdict.notes.contains(&Note::Stalemate) {
            assert_eq!((warnings, turn), (1, 40));
            assert_eq!(
                (verdict.table, verdict.next_player()),
                (TableChange::Rerack, 0)
            );
            return;
        }
        state = verdict.next;
    }
    panic!("no stalemate");
}
