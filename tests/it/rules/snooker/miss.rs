//! The miss.

use masse::game::rules::snooker::{BallOn, MissRule};
use masse::game::rules::{Call, Choice, Game, GameState, Note, Over, Reason, Snooker, TableChange};
use masse::physics::scene::Scene;

use super::{frame, rules, whole};
use crate::rules::story::{Story, place};

fn missed(state: &GameState, scene: &Scene) -> bool {
    let verdict = Story::of(scene)
        .cushion("cue", 0)
        .judge(state, &Call::Nothing);
    let offered = verdict.next.standing.choices.contains(&Choice::PutBack);
    let said = verdict
        .notes
        .iter()
        .any(|note| matches!(note, Note::Miss { .. }));
    assert_eq!(offered, said);
    offered
}

#[test]
fn after_a_miss_the_balls_may_be_put_back_for_the_same_stroke() {
    let (state, scene) = frame(BallOn::Colour, &whole());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "red 1")
        .go("cue", 0.2, 0.2)
        .go("red 1", 0.9, 0.3)
        .play(&state, &super::nominate(&scene, "pink"));
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::HandBack, Choice::PutBack]
    );
    let back = verdict
        .next
        .choose(&table, Choice::PutBack)
        .expect("offered");
    assert_eq!((back.table, back.next_player()), (TableChange::PutBack, 0));
    assert_eq!(rules(&back.next).on, BallOn::Colour, "a colour is on again");
    assert_eq!(back.next.standing.scores, [0, 6], "the points stay");
    let again = back.table_chosen(&table, &scene);
    assert_eq!(
        (place(&again, "cue"), place(&again, "red 1")),
        (place(&scene, "cue"), place(&scene, "red 1"))
    );
}

#[test]
fn a_foul_that_hit_the_ball_on_is_no_miss() {
    let (state, scene) = frame(BallOn::Red, &whole());
    let verdict = Story::of(&scene)
        .meet("cue", "red 1")
        .pot("cue", 0)
        .judge(&state, &Call::Nothing);
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::HandBack]
    );
    assert!(missed(&state, &scene));
}

#[test]
fn no_miss_is_called_once_a_side_needs_penalty_points() {
    // Two reds with blacks and six colours are worth 43.
    let (mut state, scene) = frame(BallOn::Red, &whole());
    for (scores, called) in [
        ([43, 0], true),
        ([44, 0], false),
        ([0, 39], true),
        ([0, 40], false),
        ([0, 44], false),
    ] {
        state.standing.scores = scores.to_vec();
        assert_eq!(missed(&state, &scene), called, "{scores:?}");
    }
}

#[test]
fn what_counts_as_a_miss_is_what_the_switch_says() {
    let snookered = [
        ("cue", 0.0, 0.0),
        ("black", 0.1, 0.0),
        ("red 1", 0.8, 0.0),
        ("blue", -0.5, 0.6),
    ];
    for (miss, open, behind) in [
        (MissRule::Always, true, true),
        (MissRule::ClearWay, true, false),
        (MissRule::Never, false, false),
    ] {
        let game = Game::Snooker(Snooker {
            miss,
            ..Snooker::default()
        });
        let (mut state, scene) = frame(BallOn::Red, &whole());
        state.game = game.clone();
        assert_eq!(missed(&state, &scene), open, "{miss:?}");
        let (mut state, scene) = frame(BallOn::Red, &snookered);
        state.game = game;
        assert_eq!(missed(&state, &scene), behind, "{miss:?}");
    }
}

#[test]
fn the_third_miss_with_a_full_ball_in_view_loses_the_frame() {
    let (mut state, scene) = frame(BallOn::Red, &whole());
    for number in 1..=3 {
        let verdict = Story::of(&scene)
            .cushion("cue", 0)
            .judge(&state, &Call::Nothing);
        assert!(verdict.notes.contains(&Note::Miss { in_a_row: number }));
        if number == 3 {
            let over = Over {
                winner: Some(1),
                reason: Reason::ThreeMisses,
            };
            assert_eq!(verdict.next.standing.over, Some(over));
            return;
        }
        state = verdict
            .next
            .choose(&scene, Choice::PutBack)
            .expect("offered")
            .next;
    }
}

#[test]
fn misses_from_different_places_and_from_snookers_do_not_add_up() {
    let (mut state, scene) = frame(BallOn::Red, &whole());
    for _ in 0..2 {
        let verdict = Story::of(&scene)
            .cushion("cue", 0)
            .judge(&state, &Call::Nothing);
        state = verdict
            .next
            .choose(&scene, Choice::PutBack)
            .expect("offered")
            .next;
    }
    let good = Story::of(&scene)
        .meet("cue", "red 1")
        .judge(&state, &Call::Nothing);
    assert_eq!(rules(&good.next).misses, 0);
    let verdict = Story::of(&scene)
        .cushion("cue", 0)
        .judge(&good.next, &Call::Nothing);
    assert!(verdict.notes.contains(&Note::Miss { in_a_row: 1 }));
    let behind = [
        ("cue", 0.0, 0.0),
        ("black", 0.1, 0.0),
        ("red 1", 0.8, 0.0),
        ("blue", -0.5, 0.6),
    ];
    let (mut state, scene) = frame(BallOn::Red, &behind);
    for _ in 0..5 {
        state.standing.scores = vec![0, 0];
        let verdict = Story::of(&scene)
            .cushion("cue", 0)
            .judge(&state, &Call::Nothing);
        assert_eq!(verdict.next.standing.over, None);
        state = verdict
            .next
            .choose(&scene, Choice::PutBack)
            .expect("offered")
            .next;
    }
}
