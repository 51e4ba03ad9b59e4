//! Three-cushion, UMB.

use glam::DVec2;
use masse::game::rules::three_cushion::Frozen;
use masse::game::rules::{Call, Choice, Foul, Game, GameState, Note, Over, Reason, ThreeCushion};
use masse::physics::exact::{Limits, solve};
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use masse::scenarios::library;

use super::story::{Story, lay, place, start};

fn game(rules: ThreeCushion) -> (GameState, Scene) {
    start(Game::ThreeCushion(rules), Preset::Carom)
}

/// After the opening stroke, with player 0 and the white ball at the table.
fn later() -> (GameState, Scene) {
    let (state, scene) = game(ThreeCushion::default());
    let verdict = point(&scene, "white").judge(&state, &Call::Nothing);
    assert_eq!(
        (verdict.points.as_slice(), verdict.next_player()),
        ([1, 0].as_slice(), 0)
    );
    (verdict.next, scene)
}

/// Red, three cushions, the other ball.
fn point(scene: &Scene, cue: &str) -> Story {
    let other = if cue == "white" { "yellow" } else { "white" };
    Story::with(scene, cue)
        .meet(cue, "red")
        .cushion(cue, 0)
        .cushion(cue, 1)
        .cushion(cue, 2)
        .meet(cue, other)
}

#[test]
fn the_opening_position_is_that_of_the_book() {
    let (state, scene) = game(ThreeCushion::default());
    let (head, foot) = (scene.table.head_spot(), scene.table.foot_spot());
    assert_eq!(
        (place(&scene, "red"), place(&scene, "yellow")),
        (foot, head)
    );
    assert_eq!(place(&scene, "white"), head + DVec2::new(0.0, 0.1825));
    let on = state.targets(&scene);
    let ball = |name: &str| scene.ball_named(name).expect("the ball");
    assert_eq!((on.cue, on.first), (ball("white"), vec![ball("red")]));
    let (mut second, _) = game(ThreeCushion::default());
    second.standing.turn = 1;
    assert_eq!(second.cue_ball(&scene), ball("yellow"));
}

#[test]
fn three_cushions_before_the_second_ball_make_a_point() {
    let (state, scene) = later();
    let of = |story: Story| story.judge(&state, &Call::Nothing);
    assert_eq!(of(point(&scene, "white")).points, [1, 0]);
    assert_eq!(
        of(point(&scene, "white")).next_player(),
        0,
        "and the turn goes on"
    );
    // All three before the first ball, or between: only the second ball matters.
    let before = Story::with(&scene, "white")
        .cushion("white", 0)
        .cushion("white", 1)
        .cushion("white", 2)
        .meet("white", "yellow")
        .meet("white", "red");
    assert_eq!(of(before).points, [1, 0]);
    let mixed = Story::with(&scene, "white")
        .cushion("white", 0)
        .meet("white", "yellow")
        .meet("white", "yellow")
        .cushion("white", 1)
        .cushion("white", 2)
        .meet("white", "red");
    assert_eq!(of(mixed).points, [1, 0]);
    let two = Story::with(&scene, "white")
        .cushion("white", 0)
        .meet("white", "yellow")
        .cushion("white", 1)
        .meet("white", "red")
        .cushion("white", 2);
    assert_eq!((of(two).points, 1), (vec![0, 0], 1));
    let one_ball = Story::with(&scene, "white")
        .meet("white", "red")
        .cushion("white", 0)
        .cushion("white", 1)
        .cushion("white", 2);
    assert_eq!(of(one_ball).next_player(), 1);
    // Only the cue ball's contacts count.
    let by_red = Story::with(&scene, "white")
        .meet("white", "red")
        .cushion("red", 0)
        .cushion("white", 1)
        .cushion("white", 2)
        .meet("red", "yellow")
        .meet("white", "yellow");
    assert_eq!(of(by_red).points, [0, 0]);
}

#[test]
fn the_same_cushion_counts_again_when_it_was_left_and_a_lasting_touch_counts_once() {
    let (state, scene) = later();
    let nose = 0.5 * scene.table.width - scene.table.reach(scene.balls[0].ball.radius);
    let cushion = 2;
    let twice = Story::with(&scene, "white")
        .meet("white", "red")
        .go("white", 0.0, nose)
        .cushion("white", cushion)
        .go("white", 0.2, 0.5)
        .go("white", 0.3, nose)
        .cushion("white", cushion)
        .go("white", 0.5, 0.3)
        .cushion("white", 1)
        .meet("white", "yellow");
    assert_eq!(twice.judge(&state, &Call::Nothing).points, [1, 0]);
    let along = Story::with(&scene, "white")
        .meet("white", "red")
        .go("white", 0.0, nose - 1e-6)
        .cushion("white", cushion)
        .cushion("white", cushion)
        .cushion("white", cushion)
        .go("white", 0.5, 0.3)
        .meet("white", "yellow");
    assert_eq!(along.judge(&state, &Call::Nothing).points, [0, 0]);
}

#[test]
fn a_solved_three_cushion_shot_scores() {
    let built_in = library::open("three-cushion").expect("it is built in");
    let scene = built_in.scene;
    let record = solve(&scene, Limits::default()).expect("the shot is played");
    let (state, _) = game(ThreeCushion::default());
    let verdict = state.judge(&scene, &record, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.points.as_slice()),
        ([].as_slice(), [1, 0].as_slice())
    );
}

#[test]
fn the_first_shot_touches_red_first() {
    let (state, scene) = game(ThreeCushion::default());
    let wrong = Story::with(&scene, "white")
        .meet("white", "yellow")
        .cushion("white", 0)
        .cushion("white", 1)
        .cushion("white", 2)
        .meet("white", "red");
    let verdict = wrong.judge(&state, &Call::Nothing);
    assert!(
        matches!(verdict.fouls.as_slice(), [Foul::WrongBall { .. }]),
        "{:?}",
        verdict.fouls
    );
    assert_eq!(
        (verdict.points.as_slice(), verdict.next_player()),
        ([0, 0].as_slice(), 1)
    );
    let (state, _) = later();
    assert_eq!(wrong.judge(&state, &Call::Nothing).points, [1, 0]);
}

#[test]
fn fouls_end_the_turn_and_cost_nothing() {
    let (mut state, scene) = later();
    let (verdict, table) = point(&scene, "white")
        .off("red")
        .play(&state, &Call::Nothing);
    let ball = |name: &str| scene.ball_named(name).expect("the ball");
    assert_eq!(verdict.fouls, [Foul::BallOff { ball: ball("red") }]);
    assert_eq!(
        (verdict.points.as_slice(), verdict.next_player()),
        ([0, 0].as_slice(), 1)
    );
    assert_eq!(place(&table, "red"), scene.table.foot_spot());
    let (verdict, _) = point(&scene, "yellow").play(&state, &Call::Nothing);
    assert_eq!(
        verdict.fouls[0],
        Foul::WrongCueBall {
            struck: ball("yellow")
        }
    );
    // The cue ball of the next player goes to the head spot, that of the other to the centre.
    let mut open = scene.clone();
    lay(
        &mut open,
        &[
            ("white", 0.5, 0.5),
            ("yellow", -0.2, 0.4),
            ("red", 0.9, 0.1),
        ],
    );
    let (_, table) = point(&open, "white")
        .off("yellow")
        .play(&state, &Call::Nothing);
    assert_eq!(place(&table, "yellow"), scene.table.head_spot());
    let (_, table) = point(&open, "white")
        .off("white")
        .play(&state, &Call::Nothing);
    assert_eq!(place(&table, "white"), DVec2::ZERO);
    // A taken spot gives the spot of the ball that takes it.
    lay(
        &mut open,
        &[
            ("white", 0.5, 0.5),
            ("yellow", 0.71, 0.01),
            ("red", 0.9, 0.1),
        ],
    );
    let (_, table) = point(&open, "white")
        .off("red")
        .play(&state, &Call::Nothing);
    assert_eq!(place(&table, "red"), scene.table.head_spot());
    state.standing.turn = 1;
    assert_eq!(
        point(&scene, "yellow").judge(&state, &Call::Nothing).fouls,
        []
    );
}

fn frozen() -> (GameState, Scene) {
    let (state, mut scene) = later();
    let radius = scene.balls[0].ball.radius;
    lay(
        &mut scene,
        &[
            ("white", 0.3, 0.0),
            ("yellow", 0.3 + 2.0 * radius, 0.0),
            ("red", -0.4, 0.2),
        ],
    );
    (state, scene)
}

#[test]
fn a_frozen_ball_may_not_be_shot_into() {
    let (state, scene) = frozen();
    let yellow = scene.ball_named("yellow").expect("a yellow");
    let into = Story::with(&scene, "white").also_meet("white", "yellow");
    assert_eq!(
        into.judge(&state, &Call::Nothing).fouls,
        [Foul::IntoFrozen { ball: yellow }]
    );
    let away = Story::with(&scene, "white")
        .meet("white", "red")
        .cushion("white", 0);
    assert_eq!(away.judge(&state, &Call::Nothing).fouls, []);
}

#[test]
fn a_frozen_cue_ball_sends_the_balls_that_touch_to_their_spots_or_gives_the_choice() {
    let (mut state, scene) = frozen();
    let miss = Story::with(&scene, "white").cushion("white", 0);
    let (_, table) = miss.play(&state, &Call::Nothing);
    assert_eq!(
        (place(&table, "yellow"), place(&table, "white")),
        (scene.table.head_spot(), DVec2::ZERO)
    );
    assert_eq!(
        place(&table, "red"),
        place(&scene, "red"),
        "what does not touch stays"
    );
    state.game = Game::ThreeCushion(ThreeCushion {
        frozen: Frozen::Choice,
        opening: false,
        ..ThreeCushion::default()
    });
    let (verdict, table) = miss.play(&state, &Call::Nothing);
    assert_eq!(
        verdict.next.standing.choices,
        [Choice::Accept, Choice::Spot]
    );
    assert_eq!(place(&table, "yellow"), place(&scene, "yellow"));
    let chosen = verdict.next.choose(&table, Choice::Spot).expect("offered");
    let table = chosen.table_chosen(&table, &scene);
    assert_eq!(
        (place(&table, "yellow"), place(&table, "white")),
        (scene.table.head_spot(), DVec2::ZERO)
    );
}

#[test]
fn the_second_player_has_an_equalising_inning_from_the_opening_position() {
    let (mut state, scene) = later();
    state.standing.scores = vec![39, 38];
    let (verdict, table) = point(&scene, "white").play(&state, &Call::Nothing);
    assert_eq!(verdict.notes, [Note::EqualisingInning { player: 1 }]);
    assert_eq!(
        (verdict.next_player(), verdict.next.standing.over),
        (1, None)
    );
    assert_eq!(
        place(&table, "yellow"),
        scene.table.head_spot() + DVec2::new(0.0, 0.1825)
    );
    assert_eq!(place(&table, "white"), scene.table.head_spot());
    let needed = 40;
    let over = |winner| {
        Some(Over {
            winner,
            reason: Reason::Points { needed },
        })
    };
    let miss = Story::with(&table, "yellow")
        .meet("yellow", "red")
        .judge(&verdict.next, &Call::Nothing);
    assert_eq!(miss.next.standing.over, over(Some(0)));
    let one = point(&table, "yellow").judge(&verdict.next, &Call::Nothing);
    assert_eq!((one.next.standing.over, one.next_player()), (None, 1));
    let two = point(&table, "yellow").judge(&one.next, &Call::Nothing);
    assert_eq!(two.next.standing.over, over(None), "level is a draw");
    // The second player to reach the points wins at once.
    let (mut state, _) = later();
    state.standing.scores = vec![30, 39];
    state.standing.turn = 1;
    let won = point(&scene, "yellow").judge(&state, &Call::Nothing);
    assert_eq!(won.next.standing.over, over(Some(1)));
}

#[test]
fn a_game_may_end_by_innings_and_ask_for_fewer_cushions() {
    let (state, scene) = game(ThreeCushion {
        innings: Some(2),
        ..ThreeCushion::default()
    });
    let mut state = state;
    for inning in 0..4 {
        let cue = ["white", "yellow"][inning % 2];
        if inning == 2 {
            state = point(&scene, cue).judge(&state, &Call::Nothing).next;
        }
        state = Story::with(&scene, cue)
            .meet(cue, "red")
            .judge(&state, &Call::Nothing)
            .next;
    }
    assert_eq!(
        state.standing.over,
        Some(Over {
            winner: Some(0),
            reason: Reason::Innings { played: 2 }
        })
    );
    let (state, scene) = game(ThreeCushion {
        cushions: 0,
        ..ThreeCushion::default()
    });
    let free = Story::with(&scene, "white")
        .meet("white", "red")
        .meet("white", "yellow");
    assert_eq!(free.judge(&state, &Call::Nothing).points, [1, 0]);
}
