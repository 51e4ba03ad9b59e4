//! 10-ball, WPA 2025.

use masse::game::rules::ten_ball::{Calls, EarlyTen};
use masse::game::rules::{Call, Choice, Game, GameState, Note, Over, Reason, TenBall};
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

use super::story::{Story, lay, place, pot, start};

fn later(rules: TenBall, balls: &[(&str, f64, f64)]) -> (GameState, Scene) {
    let (state, scene) = start(Game::TenBall(rules), Preset::NineFoot);
    let (verdict, mut table) = Story::of(&scene)
        .meet("cue", "1")
        .pot("4", 0)
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.next_player()),
        ([].as_slice(), 0)
    );
    lay(&mut table, balls);
    (verdict.next, table)
}

const FEW: [(&str, f64, f64); 4] = [
    ("cue", 0.0, 0.0),
    ("3", 0.5, 0.0),
    ("5", 0.5, 0.3),
    ("10", 0.8, -0.3),
];

fn won(scene: &Scene) -> Over {
    let ball = scene.ball_named("10").expect("a 10");
    Over {
        winner: Some(0),
        reason: Reason::WinningBall { ball },
    }
}

#[test]
fn the_rack_has_the_1_at_the_apex_the_10_in_the_middle_2_and_3_at_the_back_corners() {
    for seed in 0..10 {
        let like = Scene::new(
            Preset::NineFoot.table(),
            masse::physics::laws::Laws::default(),
        );
        let (state, scene) = GameState::start(Game::TenBall(TenBall::default()), 2, 0, &like, seed);
        assert_eq!(scene.balls.len(), 11);
        assert_eq!(place(&scene, "1"), scene.table.foot_spot());
        let radius = scene.balls[0].ball.radius;
        let row = |name: &str| {
            ((place(&scene, name).x - place(&scene, "1").x) / (radius * 3.0_f64.sqrt())).round()
        };
        assert_eq!((row("10"), row("2"), row("3")), (2.0, 3.0, 3.0));
        assert!(place(&scene, "10").y.abs() < 1e-12);
        assert!((place(&scene, "2").y + place(&scene, "3").y).abs() < 1e-12);
        assert!((place(&scene, "2").y.abs() - 3.0 * radius).abs() < 1e-9);
        assert!(state.targets(&scene).is_break);
    }
}

#[test]
fn the_10_on_the_break_is_spotted_and_does_not_win() {
    let (state, scene) = start(Game::TenBall(TenBall::default()), Preset::NineFoot);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "1")
        .pot("10", 0)
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.next.standing.over, verdict.next_player()),
        (None, 0)
    );
    assert!(
        table.balls[table.ball_named("10").expect("a 10")]
            .state
            .motion
            .in_play()
    );
}

#[test]
fn the_lowest_ball_is_met_first_and_pots_are_called() {
    let (state, scene) = later(TenBall::default(), &FEW);
    assert_eq!(
        state.targets(&scene).first,
        [scene.ball_named("3").expect("a 3")]
    );
    let combination = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "5")
        .pot("5", 0);
    assert_eq!(
        combination
            .judge(&state, &pot(&scene, "5", 0))
            .next_player(),
        0
    );
    assert!(
        Story::of(&scene)
            .meet("cue", "5")
            .pot("5", 0)
            .judge(&state, &pot(&scene, "5", 0))
            .is_foul()
    );
}

#[test]
fn a_ball_in_an_uncalled_pocket_stays_down_and_the_table_may_be_handed_back() {
    let (state, scene) = later(TenBall::default(), &FEW);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 0)
        .play(&state, &pot(&scene, "3", 1));
    assert!(
        !table.balls[table.ball_named("3").expect("a 3")]
            .state
            .motion
            .in_play()
    );
    assert_eq!(verdict.next_player(), 1);
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::HandBack]
    );
    let back = verdict
        .next
        .choose(&table, Choice::HandBack)
        .expect("offered");
    assert_eq!(back.next_player(), 0);
    // The 10 falling uncalled comes back.
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "10")
        .pot("10", 0)
        .play(&state, &pot(&scene, "3", 1));
    assert_eq!(verdict.next.standing.over, None);
    assert!(
        table.balls[table.ball_named("10").expect("a 10")]
            .state
            .motion
            .in_play()
    );
}

#[test]
fn the_10_wins_only_when_called() {
    let (state, scene) = later(TenBall::default(), &FEW);
    let story = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "10")
        .pot("10", 0);
    assert_eq!(
        story
            .judge(&state, &pot(&scene, "10", 0))
            .next
            .standing
            .over,
        Some(won(&scene))
    );
    assert_eq!(story.judge(&state, &Call::Nothing).next.standing.over, None);
    let spotted = TenBall {
        early_ten: EarlyTen::Spotted,
        ..TenBall::default()
    };
    let (state, scene) = later(spotted.clone(), &FEW);
    let (verdict, table) = story.play(&state, &pot(&scene, "10", 0));
    assert_eq!(
        (verdict.next.standing.over, verdict.next_player()),
        (None, 0)
    );
    assert!(
        table.balls[table.ball_named("10").expect("a 10")]
            .state
            .motion
            .in_play()
    );
    let (state, scene) = later(spotted, &[("cue", 0.0, 0.0), ("10", 0.8, 0.0)]);
    let last = Story::of(&scene).meet("cue", "10").pot("10", 0);
    assert_eq!(
        last.judge(&state, &pot(&scene, "10", 0)).next.standing.over,
        Some(won(&scene))
    );
}

#[test]
fn where_only_the_10_is_called_any_other_pot_continues() {
    let rules = TenBall {
        calls: Calls::TenOnly,
        ..TenBall::default()
    };
    let (state, scene) = later(rules, &FEW);
    let kiss = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "5")
        .pot("5", 0);
    assert_eq!(kiss.judge(&state, &Call::Nothing).next_player(), 0);
    let slop = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "10")
        .pot("10", 0);
    assert_eq!(slop.judge(&state, &Call::Nothing).next.standing.over, None);
}

#[test]
fn three_fouls_in_a_row_lose() {
    let (mut state, scene) = later(TenBall::default(), &FEW);
    state.standing.fouls[0] = 2;
    let verdict = Story::of(&scene).judge(&state, &Call::Nothing);
    let reason = Reason::ThreeFouls;
    assert_eq!(
        verdict.next.standing.over,
        Some(Over {
            winner: Some(1),
            reason
        })
    );
    let safe = Story::of(&scene)
        .meet("cue", "3")
        .cushion("3", 0)
        .judge(&state, &Call::Safety);
    assert_eq!((safe.next.standing.fouls[0], safe.next_player()), (0, 1));
    let potted = Story::of(&scene)
        .meet("cue", "3")
        .pot("3", 0)
        .judge(&state, &Call::Safety);
    assert_eq!(potted.notes, [Note::Safety]);
}
