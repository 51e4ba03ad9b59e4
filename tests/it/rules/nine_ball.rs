//! 9-ball, WPA 2025.

use masse::game::rules::{
    Area, Call, Choice, Foul, Game, GameState, NineBall, Note, Over, Reason, Verdict,
};
use masse::physics::ball::Motion;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

use super::story::{Story, lay, place, start};

fn rack(rules: NineBall) -> (GameState, Scene) {
    start(Game::NineBall(rules), Preset::NineFoot)
}

fn drive_four(story: Story) -> Story {
    story
        .cushion("1", 0)
        .cushion("2", 0)
        .cushion("3", 5)
        .cushion("4", 10)
}

const FEW: [(&str, f64, f64); 4] = [
    ("cue", 0.0, 0.0),
    ("3", 0.5, 0.0),
    ("5", 0.5, 0.3),
    ("9", 0.8, -0.3),
];

/// Player 1 after a legal break: a push out is possible.
fn broken() -> (GameState, Scene) {
    let (state, scene) = rack(NineBall::default());
    let (verdict, mut table) =
        drive_four(Story::of(&scene).meet("cue", "1")).play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.next_player()),
        ([].as_slice(), 1)
    );
    lay(&mut table, &FEW);
    (verdict.next, table)
}

/// Player 0, after that.
fn later() -> (GameState, Scene) {
    let (state, scene) = broken();
    let verdict = Story::of(&scene)
        .meet("cue", "3")
        .cushion("3", 0)
        .judge(&state, &Call::Nothing);
    assert_eq!(verdict.next_player(), 0);
    (verdict.next, scene)
}

fn won_by(verdict: &Verdict) -> Option<usize> {
    verdict.next.standing.over.and_then(|over| over.winner)
}

fn in_play(scene: &Scene, name: &str) -> bool {
    scene.balls[scene.ball_named(name).expect("the ball")]
        .state
        .motion
        .in_play()
}

#[test]
fn the_rack_has_the_9_on_the_foot_spot_or_the_1() {
    let (state, scene) = rack(NineBall::default());
    let foot = scene.table.foot_spot();
    assert!(place(&scene, "9").distance(foot) < 1e-12);
    assert!(
        scene
            .balls
            .iter()
            .skip(1)
            .all(|ball| ball.name == "1" || place(&scene, "1").x < ball.state.position.x)
    );
    let on = state.targets(&scene);
    assert_eq!(
        (on.first, on.is_break),
        (vec![scene.ball_named("1").expect("a 1")], true)
    );
    assert_eq!(on.in_hand, Some(Area::behind_head_string(&scene.table)));
    let old = NineBall {
        nine_on_foot_spot: false,
        ..NineBall::default()
    };
    let (_, scene) = rack(old);
    assert_eq!(place(&scene, "1"), foot);
    let middle = place(&scene, "9");
    let radius = scene.balls[0].ball.radius;
    assert!((middle.x - foot.x - 2.0 * radius * 3.0_f64.sqrt()).abs() < 1e-9 && middle.y == 0.0);
}

#[test]
fn the_break_meets_the_1_first_and_pots_or_drives_four() {
    let (state, scene) = rack(NineBall::default());
    let fouls = |story: Story| story.judge(&state, &Call::Nothing).fouls;
    assert_eq!(fouls(drive_four(Story::of(&scene).meet("cue", "1"))), []);
    assert_eq!(fouls(Story::of(&scene).meet("cue", "1").pot("4", 0)), []);
    let wrong = fouls(drive_four(Story::of(&scene).meet("cue", "2")));
    assert!(
        matches!(wrong.as_slice(), [Foul::WrongBall { .. }]),
        "{wrong:?}"
    );
    let weak = Story::of(&scene)
        .meet("cue", "1")
        .cushion("1", 0)
        .cushion("2", 0)
        .cushion("3", 0);
    let verdict = weak.judge(&state, &Call::Nothing);
    assert_eq!(
        verdict.fouls,
        [Foul::WeakBreak {
            driven: 3,
            needed: 4
        }]
    );
    assert_eq!(
        verdict.next.standing.in_hand,
        Some(Area::anywhere(&scene.table))
    );
    assert!(
        !verdict.next.targets(&scene).may_push_out,
        "no push out after a foul"
    );
}

#[test]
fn the_9_wins_on_the_break_too_and_comes_back_on_a_foul() {
    let (state, scene) = rack(NineBall::default());
    let ace = Story::of(&scene).meet("cue", "1").pot("9", 0);
    assert_eq!(won_by(&ace.judge(&state, &Call::Nothing)), Some(0));
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "1")
        .pot("9", 0)
        .pot("cue", 1)
        .play(&state, &Call::Nothing);
    assert_eq!((won_by(&verdict), in_play(&table, "9")), (None, true));
    let (state, scene) = later();
    let combination = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "9")
        .pot("9", 0);
    assert_eq!(
        won_by(&combination.judge(&state, &Call::Nothing)),
        Some(0),
        "no calling"
    );
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "5")
        .pot("9", 0)
        .pot("5", 0)
        .play(&state, &Call::Nothing);
    assert_eq!(
        (won_by(&verdict), in_play(&table, "9"), in_play(&table, "5")),
        (None, true, false)
    );
    assert_eq!(place(&table, "9"), scene.table.foot_spot());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .off("9")
        .play(&state, &Call::Nothing);
    assert_eq!((won_by(&verdict), in_play(&table, "9")), (None, true));
    assert!(!verdict.fouls.is_empty());
}

#[test]
fn a_push_out_must_be_called_and_comes_only_after_the_break() {
    let (state, scene) = broken();
    assert!(state.targets(&scene).may_push_out);
    let nowhere = Story::of(&scene);
    assert!(
        nowhere.judge(&state, &Call::Nothing).is_foul(),
        "not declared"
    );
    let verdict = nowhere.judge(&state, &Call::PushOut);
    assert_eq!(verdict.fouls, []);
    assert_eq!(
        (
            verdict.next_player(),
            verdict.next.standing.choices.as_slice()
        ),
        (0, [Choice::Accept, Choice::HandBack].as_slice())
    );
    let back = verdict
        .next
        .choose(&scene, Choice::HandBack)
        .expect("offered");
    assert_eq!(back.next_player(), 1);
    let on = verdict
        .next
        .choose(&scene, Choice::Accept)
        .expect("offered");
    assert_eq!(on.next_player(), 0);
    assert!(!on.next.targets(&scene).may_push_out);
    let (state, scene) = later();
    assert!(
        Story::of(&scene).judge(&state, &Call::PushOut).is_foul(),
        "too late"
    );
}

#[test]
fn on_a_push_out_other_fouls_count_and_the_9_comes_back() {
    let (state, scene) = broken();
    let verdict = Story::of(&scene)
        .meet("cue", "5")
        .pot("cue", 0)
        .judge(&state, &Call::PushOut);
    assert_eq!(verdict.fouls, [Foul::Scratch { pocket: 0 }]);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "9")
        .pot("9", 0)
        .pot("5", 1)
        .play(&state, &Call::PushOut);
    assert_eq!(
        (won_by(&verdict), in_play(&table, "9"), in_play(&table, "5")),
        (None, true, false)
    );
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::HandBack]
    );
}

#[test]
fn the_lowest_ball_is_met_first_and_any_pot_continues() {
    let (state, scene) = later();
    let on = state.targets(&scene);
    assert_eq!(
        (on.first, on.pot.len()),
        (vec![scene.ball_named("3").expect("a 3")], 3)
    );
    let verdict = Story::of(&scene)
        .meet("cue", "3")
        .meet("3", "5")
        .pot("5", 0)
        .judge(&state, &Call::Nothing);
    assert_eq!(
        (
            verdict.fouls.as_slice(),
            verdict.next_player(),
            verdict.made.len()
        ),
        ([].as_slice(), 0, 1)
    );
    let wrong = Story::of(&scene)
        .meet("cue", "5")
        .pot("5", 0)
        .judge(&state, &Call::Nothing);
    assert_eq!(
        wrong.fouls[0].sentence(&scene),
        "Wrong ball first: the cue ball met the 5 first, on was the 3."
    );
    assert_eq!(
        wrong.next.standing.in_hand,
        Some(Area::anywhere(&scene.table))
    );
}

#[test]
fn an_object_ball_off_the_table_is_a_foul_and_stays_off() {
    let (state, scene) = later();
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "3")
        .cushion("3", 0)
        .off("5")
        .play(&state, &Call::Nothing);
    assert_eq!(
        verdict.fouls,
        [Foul::BallOff {
            ball: scene.ball_named("5").expect("a 5")
        }]
    );
    assert_eq!(
        table.balls[table.ball_named("5").expect("a 5")]
            .state
            .motion,
        Motion::OffTable
    );
}

#[test]
fn no_ball_and_no_cushion_are_fouls() {
    let (state, scene) = later();
    let fouls = |story: Story| story.judge(&state, &Call::Nothing).fouls;
    assert_eq!(
        fouls(Story::of(&scene).cushion("cue", 0)),
        [Foul::NoContact]
    );
    // A cushion before the contact does not help; one after it does, whichever ball reaches it.
    assert_eq!(
        fouls(Story::of(&scene).cushion("cue", 0).meet("cue", "3")),
        [Foul::NoCushion]
    );
    for ball in ["cue", "3", "9"] {
        assert_eq!(
            fouls(Story::of(&scene).meet("cue", "3").cushion(ball, 0)),
            []
        );
    }
    assert_eq!(
        fouls(
            Story::of(&scene)
                .meet("cue", "3")
                .cushion("3", 0)
                .off("cue")
        ),
        [Foul::CueBallOff]
    );
}

#[test]
fn three_fouls_in_a_row_lose_with_a_warning_after_the_second() {
    let (mut state, scene) = later();
    for number in 1..=3 {
        assert_eq!(state.standing.turn, 0);
        let verdict = Story::of(&scene).judge(&state, &Call::Nothing);
        let warned = verdict.notes.contains(&Note::TwoFouls { player: 0 });
        assert_eq!(warned, number == 2);
        if number == 3 {
            let over = Over {
                winner: Some(1),
                reason: Reason::ThreeFouls,
            };
            assert_eq!(verdict.next.standing.over, Some(over));
            return;
        }
        let good = Story::of(&scene).meet("cue", "3").cushion("3", 0);
        state = good.judge(&verdict.next, &Call::Nothing).next;
    }
}

#[test]
fn a_good_stroke_between_ends_the_row_of_fouls_and_the_switch_ends_the_rule() {
    let (state, scene) = later();
    let foul = |state: &GameState| Story::of(&scene).judge(state, &Call::Nothing).next;
    let good = |state: &GameState| {
        Story::of(&scene)
            .meet("cue", "3")
            .cushion("3", 0)
            .judge(state, &Call::Nothing)
            .next
    };
    let state = good(&good(&good(&foul(&good(&foul(&state))))));
    assert_eq!(state.standing.fouls, [0, 0]);
    let (mut state, scene) = rack(NineBall {
        three_fouls: false,
        ..NineBall::default()
    });
    for _ in 0..12 {
        state = Story::of(&scene).judge(&state, &Call::Nothing).next;
        assert_eq!(state.standing.over, None);
    }
}

#[test]
fn the_three_point_break_counts_pots_and_balls_that_reach_the_head_string() {
    let (state, scene) = rack(NineBall {
        three_point_break: true,
        ..NineBall::default()
    });
    let string = scene.table.head_spot().x;
    let verdict = drive_four(Story::of(&scene).meet("cue", "1"))
        .pot("4", 0)
        .go("5", string, 0.1)
        .judge(&state, &Call::Nothing);
    assert_eq!(verdict.notes, [Note::ThreePointBreak { points: 2 }]);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.next_player()),
        ([].as_slice(), 1)
    );
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::HandBack]
    );
    let enough = drive_four(Story::of(&scene).meet("cue", "1"))
        .pot("4", 0)
        .go("5", string, 0.1)
        .go("6", string - 0.2, 0.1)
        .go("6", 0.2, 0.1);
    let verdict = enough.judge(&state, &Call::Nothing);
    assert_eq!(
        (verdict.notes.as_slice(), verdict.next_player()),
        ([].as_slice(), 0)
    );
}
