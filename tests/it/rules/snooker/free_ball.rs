//! The free ball.

use masse::game::rules::snooker::BallOn;
use masse::game::rules::{Call, Choice, Foul, Game, Note, Snooker};
use masse::physics::scene::Scene;

use super::{frame, nominate, rules, whole};
use crate::rules::story::Story;

/// The cue ball behind the black, seen from the only red; other colours out of the way.
const SNOOKERED: [(&str, f64, f64); 4] = [
    ("cue", 0.0, 0.0),
    ("black", 0.1, 0.0),
    ("red 1", 0.8, 0.0),
    ("blue", -0.5, 0.6),
];

fn free(on: BallOn, balls: &[(&str, f64, f64)]) -> (masse::game::rules::GameState, Scene) {
    let (mut state, scene) = frame(on, balls);
    state.game = Game::Snooker(Snooker {
        on,
        free_ball: true,
        ..Snooker::default()
    });
    (state, scene)
}

#[test]
fn a_foul_that_leaves_the_next_player_snookered_gives_a_free_ball() {
    let (state, scene) = frame(BallOn::Red, &SNOOKERED);
    let verdict = Story::of(&scene)
        .cushion("cue", 0)
        .judge(&state, &Call::Nothing);
    assert!(verdict.notes.contains(&Note::FreeBall));
    let next = verdict
        .next
        .choose(&scene, Choice::Accept)
        .expect("offered")
        .next;
    let on = next.targets(&scene);
    assert_eq!(
        (on.free_ball, on.first.len()),
        (true, 3),
        "any ball may be nominated"
    );
    let back = verdict
        .next
        .choose(&scene, Choice::HandBack)
        .expect("offered");
    assert_eq!(
        (back.next_player(), back.next.targets(&scene).free_ball),
        (0, false)
    );
}

#[test]
fn half_a_view_is_a_snooker_and_a_whole_view_of_one_red_is_not() {
    let given = |balls: &[(&str, f64, f64)]| {
        let (state, scene) = frame(BallOn::Red, balls);
        Story::of(&scene)
            .judge(&state, &Call::Nothing)
            .notes
            .contains(&Note::FreeBall)
    };
    let mut balls = SNOOKERED.to_vec();
    assert!(given(&balls));
    // The black stands so far aside that only one edge of the red can be hit.
    balls[1].2 = 0.03;
    assert!(given(&balls));
    balls[1].2 = 0.2;
    assert!(!given(&balls));
    balls[1].2 = 0.0;
    balls.push(("red 2", 0.0, 0.8));
    assert!(!given(&balls), "another red is in full view");
    // A red in the way of a red is no snooker.
    let reds = [("cue", 0.0, 0.0), ("red 1", 0.1, 0.0), ("red 2", 0.8, 0.0)];
    assert!(!given(&reds));
}

#[test]
fn from_the_d_one_is_snookered_only_if_no_place_in_it_is_open() {
    let (state, scene) = frame(BallOn::Red, &SNOOKERED);
    let verdict = Story::of(&scene)
        .pot("cue", 0)
        .judge(&state, &Call::Nothing);
    assert!(
        !verdict.notes.contains(&Note::FreeBall),
        "the D sees round the black"
    );
}

#[test]
fn a_free_ball_scores_as_the_ball_on_and_comes_back() {
    let (state, scene) = free(BallOn::Red, &whole());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "black")
        .pot("black", 5)
        .play(&state, &nominate(&scene, "black"));
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.points.as_slice()),
        ([].as_slice(), [1, 0].as_slice())
    );
    assert!(
        table.balls[table.ball_named("black").expect("a black")]
            .state
            .motion
            .in_play()
    );
    assert_eq!(rules(&verdict.next).on, BallOn::Colour);
    // A red potted with it counts too.
    let both = Story::of(&scene)
        .meet("cue", "black")
        .meet("black", "red 1")
        .pot("red 1", 5)
        .pot("black", 4);
    assert_eq!(
        both.judge(&state, &nominate(&scene, "black")).points,
        [2, 0]
    );
    let colours: Vec<_> = whole()
        .into_iter()
        .filter(|ball| !ball.0.starts_with("red"))
        .collect();
    let (state, scene) = free(BallOn::Sequence { value: 4 }, &colours);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "pink")
        .pot("pink", 5)
        .play(&state, &nominate(&scene, "pink"));
    assert_eq!(verdict.points, [4, 0]);
    assert!(
        table.balls[table.ball_named("pink").expect("a pink")]
            .state
            .motion
            .in_play()
    );
    // Free ball and ball on together: only the ball on counts, and stays down.
    let both = Story::of(&scene)
        .meet("cue", "pink")
        .also_meet("cue", "brown")
        .pot("pink", 5)
        .pot("brown", 4);
    let (verdict, table) = both.play(&state, &nominate(&scene, "pink"));
    assert_eq!(verdict.points, [4, 0]);
    assert!(
        !table.balls[table.ball_named("brown").expect("a brown")]
            .state
            .motion
            .in_play()
    );
    // Fouled with, it costs what the ball on costs.
    let wrong = Story::of(&scene)
        .meet("cue", "blue")
        .judge(&state, &nominate(&scene, "pink"));
    assert_eq!(wrong.points, [0, 5]);
}

#[test]
fn to_leave_the_opponent_snookered_behind_the_free_ball_is_a_foul() {
    let (state, scene) = free(BallOn::Red, &SNOOKERED);
    let black = scene.ball_named("black").expect("a black");
    let story = Story::of(&scene).meet("cue", "black");
    let verdict = story.judge(&state, &nominate(&scene, "black"));
    assert_eq!(
        verdict.fouls,
        [Foul::SnookeredBehindFreeBall { ball: black }]
    );
    let verdict = Story::of(&scene)
        .meet("cue", "black")
        .go("black", 0.1, 0.5)
        .judge(&state, &nominate(&scene, "black"));
    assert_eq!(verdict.fouls, [], "the way is open");
    // With only pink and black left it is allowed.
    let last = [("cue", 0.0, 0.0), ("black", 0.1, 0.0), ("pink", 0.8, 0.0)];
    let (state, scene) = free(BallOn::Sequence { value: 6 }, &last);
    assert_eq!(
        Story::of(&scene)
            .meet("cue", "black")
            .judge(&state, &nominate(&scene, "black"))
            .fouls,
        []
    );
}
