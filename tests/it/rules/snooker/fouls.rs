//! Fouls at snooker, and what they cost.

use masse::game::rules::snooker::BallOn;
use masse::game::rules::{Area, Call, Choice, Foul};
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::scene::PlannedShot;

use super::{cost, frame, nominate, whole};
use crate::rules::story::{Story, place};

#[test]
fn a_foul_costs_the_dearest_of_ball_on_and_ball_fouled_with_between_4_and_7() {
    let (state, scene) = frame(BallOn::Red, &whole());
    for (name, points) in [
        ("yellow", 4),
        ("brown", 4),
        ("blue", 5),
        ("pink", 6),
        ("black", 7),
    ] {
        assert_eq!(
            cost(&Story::of(&scene).meet("cue", name), &state, &Call::Nothing),
            points,
            "{name} first"
        );
        let potted = Story::of(&scene).meet("cue", "red 1").pot(name, 5);
        assert_eq!(
            cost(&potted, &state, &Call::Nothing),
            points,
            "{name} potted"
        );
        let off = Story::of(&scene).meet("cue", "red 1").off(name);
        assert_eq!(
            cost(&off, &state, &Call::Nothing),
            points,
            "{name} off the table"
        );
    }
    assert_eq!(
        cost(&Story::of(&scene), &state, &Call::Nothing),
        4,
        "a miss"
    );
    assert_eq!(
        cost(
            &Story::of(&scene).meet("cue", "red 1").pot("cue", 0),
            &state,
            &Call::Nothing
        ),
        4,
        "in-off"
    );
    let (state, scene) = frame(BallOn::Colour, &whole());
    let pink = nominate(&scene, "pink");
    assert_eq!(
        cost(&Story::of(&scene), &state, &pink),
        6,
        "a miss at the pink"
    );
    assert_eq!(
        cost(&Story::of(&scene).meet("cue", "red 1"), &state, &pink),
        6,
        "a red for the pink"
    );
    assert_eq!(
        cost(&Story::of(&scene).meet("cue", "black"), &state, &pink),
        7,
        "the black for the pink"
    );
    assert_eq!(
        cost(
            &Story::of(&scene).meet("cue", "pink").pot("red 1", 0),
            &state,
            &pink
        ),
        6
    );
    // Of several fouls only the dearest counts.
    let many = Story::of(&scene)
        .meet("cue", "blue")
        .pot("black", 0)
        .pot("cue", 1)
        .off("red 1");
    assert_eq!(cost(&many, &state, &pink), 7);
}

#[test]
fn colours_of_a_foul_come_back_and_reds_do_not() {
    let (state, scene) = frame(BallOn::Red, &whole());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "black")
        .pot("black", 5)
        .pot("red 1", 0)
        .off("blue")
        .play(&state, &Call::Nothing);
    assert_eq!(place(&table, "black"), place(&scene, "black"));
    assert_eq!(place(&table, "blue"), place(&scene, "blue"));
    assert!(
        !table.balls[table.ball_named("red 1").expect("a red")]
            .state
            .motion
            .in_play()
    );
    assert_eq!(
        verdict.next.standing.choices[..2],
        [Choice::Accept, Choice::HandBack]
    );
}

#[test]
fn two_balls_at_once_are_a_foul_unless_both_are_on() {
    let (state, scene) = frame(BallOn::Red, &whole());
    let together = Story::of(&scene)
        .meet("cue", "red 1")
        .also_meet("cue", "pink");
    assert_eq!(cost(&together, &state, &Call::Nothing), 6);
    let verdict = together.judge(&state, &Call::Nothing);
    assert!(matches!(verdict.fouls.as_slice(), [Foul::Together { .. }]));
    let reds = Story::of(&scene)
        .meet("cue", "red 1")
        .also_meet("cue", "red 2");
    assert_eq!(reds.judge(&state, &Call::Nothing).fouls, []);
}

#[test]
fn after_an_in_off_the_cue_ball_is_played_from_the_d() {
    let (state, scene) = frame(BallOn::Red, &whole());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "red 1")
        .pot("cue", 0)
        .play(&state, &Call::Nothing);
    let area = Area::in_d(&scene.table);
    assert_eq!(verdict.next.standing.in_hand, Some(area));
    assert!(area.is_legal(&table, 0, place(&table, "cue")));
    let back = verdict
        .next
        .choose(&table, Choice::HandBack)
        .expect("offered");
    assert_eq!(
        (back.next_player(), back.next.standing.in_hand),
        (0, Some(area))
    );
}

#[test]
fn a_touching_ball_must_be_left_where_it_is_and_counts_as_hit() {
    let radius = frame(BallOn::Red, &whole()).1.balls[0].ball.radius;
    let mut balls = whole();
    balls.retain(|ball| ball.0 != "red 1");
    balls.push(("red 1", -0.4 + 2.0 * radius + 1e-6, 0.3));
    let (state, scene) = frame(BallOn::Red, &balls);
    let away = Story::of(&scene).cushion("cue", 0);
    assert_eq!(
        away.judge(&state, &Call::Nothing).fouls,
        [],
        "it counts as hit"
    );
    let other = Story::of(&scene).meet("cue", "black").cushion("cue", 0);
    assert_eq!(other.judge(&state, &Call::Nothing).fouls, []);
    let pushed = Story::of(&scene).also_meet("cue", "red 1");
    let red = scene.ball_named("red 1").expect("a red");
    assert_eq!(
        pushed.judge(&state, &Call::Nothing).fouls,
        [Foul::Push { ball: red }]
    );
    // Met again later, from a cushion, it is no push.
    let again = Story::of(&scene).cushion("cue", 0).meet("cue", "red 1");
    assert_eq!(again.judge(&state, &Call::Nothing).fouls, []);
    // A touching ball that is not on does not help.
    let (state, scene) = frame(BallOn::Sequence { value: 2 }, &balls);
    assert!(
        Story::of(&scene)
            .cushion("cue", 0)
            .judge(&state, &Call::Nothing)
            .is_foul()
    );
}

#[test]
fn a_stroke_into_a_frozen_ball_moves_it_in_a_solved_record() {
    let mut balls = whole();
    let radius = frame(BallOn::Red, &balls).1.balls[0].ball.radius;
    balls.retain(|ball| ball.0 != "red 1");
    balls.push(("red 1", -0.4 + 2.0 * radius, 0.3));
    let (state, mut scene) = frame(BallOn::Red, &balls);
    for (heading, pushed) in [(0.0, true), (std::f64::consts::PI, false)] {
        let shot = Shot {
            heading,
            speed: 1.0,
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = solve(&scene, Limits::default()).expect("the shot is played");
        let verdict = state.judge(&scene, &record, &Call::Nothing);
        let has_push = verdict
            .fouls
            .iter()
            .any(|foul| matches!(foul, Foul::Push { .. }));
        assert_eq!(has_push, pushed, "{:?}", verdict.fouls);
    }
}

#[test]
fn a_solved_jump_over_a_ball_is_a_foul() {
    let (state, mut scene) = frame(
        BallOn::Red,
        &[
            ("cue", -0.635, 0.0),
            ("black", -0.335, 0.0),
            ("red 1", 0.7, 0.0),
        ],
    );
    let jump = Shot {
        elevation: 45.0_f64.to_radians(),
        speed: 3.0,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: jump,
    });
    let record = solve(&scene, Limits::default()).expect("the shot is played");
    let over = scene.ball_named("black").expect("a black");
    let verdict = state.judge(&scene, &record, &Call::Nothing);
    assert_eq!(verdict.fouls, [Foul::Jump { over }]);
    assert_eq!(verdict.points, [0, 7]);
    assert_eq!(
        verdict.fouls[0].sentence(&scene),
        "Jump shot: the cue ball passed over the black."
    );
}

#[test]
fn what_is_no_jump() {
    let (state, scene) = frame(
        BallOn::Red,
        &[
            ("cue", -0.6, 0.0),
            ("red 1", 0.0, 0.0),
            ("black", 0.6, 0.0),
            ("red 2", 1.0, 0.0),
        ],
    );
    let jumps = |story: Story| {
        let fouls = story.judge(&state, &Call::Nothing).fouls;
        fouls.iter().any(|foul| matches!(foul, Foul::Jump { .. }))
    };
    let over = Story::of(&scene).fly("cue", 0.3, 0.0).meet("cue", "red 2");
    assert!(jumps(over), "over a red that is on, too");
    let untouched = Story::of(&scene).fly("cue", 0.3, 0.0);
    assert!(jumps(untouched), "with nothing hit");
    let struck_first = Story::of(&scene)
        .meet("cue", "red 1")
        .go("cue", 0.3, 0.0)
        .fly("cue", 0.9, 0.0);
    assert!(
        !jumps(struck_first),
        "it struck a ball first and then jumped another"
    );
    let beside = Story::of(&scene).fly("cue", 0.3, 0.3).meet("cue", "red 2");
    assert!(!jumps(beside), "past the ball");
    let short = Story::of(&scene).fly("cue", -0.2, 0.0).meet("cue", "red 1");
    assert!(!jumps(short), "it came down before the ball");
    let onto = Story::of(&scene)
        .fly("cue", -0.03, 0.0)
        .meet("cue", "red 1")
        .fly("cue", -0.2, 0.0);
    assert!(!jumps(onto), "it hit the ball from above and came back");
    let beyond = Story::of(&scene)
        .go("cue", -0.06, 0.0)
        .meet("cue", "red 1")
        .fly("cue", 0.3, 0.0);
    assert!(jumps(beyond), "it hit the ball and went over it");
    let by_cushion = Story::of(&scene)
        .go("cue", -0.06, 0.0)
        .meet("cue", "red 1")
        .cushion("cue", 0)
        .fly("cue", 0.3, 0.0);
    assert!(!jumps(by_cushion), "a cushion came between");
    let by_ball = Story::of(&scene)
        .go("cue", -0.06, 0.0)
        .meet("cue", "red 1")
        .meet("cue", "red 2")
        .fly("cue", 0.3, 0.0);
    assert!(!jumps(by_ball), "another ball came between");
}
