//! What balls are worth, in which order they are on, and where they come back.

use glam::DVec2;
use masse::game::rules::snooker::{BallOn, value};
use masse::game::rules::spot::APART;
use masse::game::rules::{Area, Call, Choice, Game, Note, Over, Reason, Snooker};
use masse::physics::scene::COLOURS;
use masse::physics::table::Preset;

use super::{cost, frame, nominate, rules, whole};
use crate::rules::story::{Story, place, start};

#[test]
fn the_balls_are_set_up_as_the_rules_say() {
    let (state, scene) = start(Game::Snooker(Snooker::default()), Preset::Snooker);
    assert_eq!(scene.balls.len(), 22);
    scene.check().expect("no balls overlap");
    let (length, radius) = (scene.table.length, scene.balls[0].ball.radius);
    let baulk = 0.737 - 0.5 * length;
    for (name, x, z) in [
        ("brown", baulk, 0.0),
        ("yellow", baulk, 0.292),
        ("green", baulk, -0.292),
        ("blue", 0.0, 0.0),
        ("pink", 0.25 * length, 0.0),
        ("black", 0.5 * length - 0.324, 0.0),
    ] {
        assert!(
            place(&scene, name).distance(DVec2::new(x, z)) < 1e-12,
            "{name}"
        );
    }
    let gap = place(&scene, "red 1").x - place(&scene, "pink").x - 2.0 * radius;
    assert!(
        gap > 0.0 && gap < 1e-3,
        "as near as possible without touching: {gap}"
    );
    let values: Vec<i32> = COLOURS
        .iter()
        .map(|name| value(&scene, scene.ball_named(name).expect("the ball")))
        .collect();
    assert_eq!(values, [2, 3, 4, 5, 6, 7]);
    assert_eq!(value(&scene, scene.ball_named("red 15").expect("a red")), 1);
    let on = state.targets(&scene);
    assert_eq!(
        (on.first.len(), on.in_hand),
        (15, Some(Area::in_d(&scene.table)))
    );
}

#[test]
fn the_d_is_a_half_disc_behind_the_baulk_line() {
    let table = Preset::Snooker.table();
    let (area, middle) = (Area::in_d(&table), table.baulk_spot());
    for (x, z, inside) in [
        (0.0, 0.0, true),
        (0.0, 0.292, true),
        (-0.292, 0.0, true),
        (-0.2, 0.2, true),
        (0.001, 0.0, false),
        (-0.21, 0.21, false),
        (0.0, 0.293, false),
    ] {
        assert_eq!(area.allows(middle + DVec2::new(x, z)), inside, "{x} {z}");
        assert!(area.allows(area.nearest(middle + DVec2::new(x, z))));
    }
}

/// Player 0 clears the table from the opening, with the black after every red.
fn clearance(
    mut state: masse::game::rules::GameState,
    mut scene: masse::physics::scene::Scene,
) -> Option<Over> {
    for red in 1..=15 {
        for name in [format!("red {red}"), "black".to_owned()] {
            let call = nominate(&scene, &name);
            let (verdict, table) = Story::of(&scene)
                .meet("cue", &name)
                .pot(&name, 5)
                .play(&state, &call);
            assert_eq!(
                (verdict.fouls.as_slice(), verdict.next_player()),
                ([].as_slice(), 0),
                "{name}"
            );
            (state, scene) = (verdict.next, table);
        }
    }
    for name in COLOURS {
        let on = state.targets(&scene);
        assert_eq!(
            on.first,
            [scene.ball_named(name).expect("the colour")],
            "ascending order"
        );
        let (verdict, table) = Story::of(&scene)
            .meet("cue", name)
            .pot(name, 5)
            .play(&state, &Call::Nothing);
        assert_eq!(verdict.fouls, []);
        (state, scene) = (verdict.next, table);
    }
    assert!(
        scene.balls[1..]
            .iter()
            .all(|ball| !ball.state.motion.in_play())
    );
    assert_eq!(state.standing.scores[1], 0);
    let best = state.standing.scores[0];
    let free = usize::from(best > 147);
    assert_eq!(best, [147, 155][free]);
    state.standing.over
}

#[test]
fn the_greatest_break_is_147() {
    let (state, scene) = start(Game::Snooker(Snooker::default()), Preset::Snooker);
    let over = Over {
        winner: Some(0),
        reason: Reason::LastBall,
    };
    assert_eq!(clearance(state, scene), Some(over));
}

#[test]
fn with_a_free_ball_first_it_is_155() {
    let (mut state, mut scene) = start(Game::Snooker(Snooker::default()), Preset::Snooker);
    state.game = Game::Snooker(Snooker {
        free_ball: true,
        ..Snooker::default()
    });
    for name in ["green", "black"] {
        let call = nominate(&scene, name);
        let (verdict, table) = Story::of(&scene)
            .meet("cue", name)
            .pot(name, 5)
            .play(&state, &call);
        assert_eq!(verdict.fouls, []);
        (state, scene) = (verdict.next, table);
    }
    assert_eq!(state.standing.scores, [8, 0]);
    assert!(clearance(state, scene).is_some());
}

#[test]
fn red_and_colour_take_turns_and_colours_come_back_to_their_own_spots() {
    let (state, scene) = frame(BallOn::Red, &whole());
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "red 1")
        .pot("red 1", 5)
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.points.as_slice(), rules(&verdict.next).on),
        ([1, 0].as_slice(), BallOn::Colour)
    );
    assert_eq!(verdict.next.targets(&table).first.len(), 6);
    let (verdict, table) = Story::of(&table)
        .meet("cue", "blue")
        .pot("blue", 5)
        .play(&verdict.next, &nominate(&table, "blue"));
    assert_eq!(
        (verdict.points.as_slice(), rules(&verdict.next).on),
        ([5, 0].as_slice(), BallOn::Red)
    );
    assert_eq!(place(&table, "blue"), DVec2::ZERO);
    assert!(
        !table.balls[table.ball_named("red 1").expect("a red")]
            .state
            .motion
            .in_play()
    );
    // Two reds together are fine, and both count.
    let both = Story::of(&scene)
        .meet("cue", "red 1")
        .also_meet("cue", "red 2")
        .pot("red 1", 5)
        .pot("red 2", 4);
    assert_eq!(both.judge(&state, &Call::Nothing).points, [2, 0]);
}

#[test]
fn after_the_last_red_and_its_colour_the_colours_stay_down() {
    let balls: Vec<_> = whole()
        .into_iter()
        .filter(|ball| !ball.0.starts_with("red"))
        .collect();
    let (state, scene) = frame(BallOn::Colour, &balls);
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "pink")
        .pot("pink", 5)
        .play(&state, &nominate(&scene, "pink"));
    assert_eq!(rules(&verdict.next).on, BallOn::Sequence { value: 2 });
    assert_eq!(
        place(&table, "pink"),
        table.table.foot_spot(),
        "the colour of the last red comes back"
    );
    let (verdict, table) = Story::of(&table)
        .meet("cue", "yellow")
        .pot("yellow", 5)
        .play(&verdict.next, &Call::Nothing);
    assert_eq!(rules(&verdict.next).on, BallOn::Sequence { value: 3 });
    assert!(
        !table.balls[table.ball_named("yellow").expect("a yellow")]
            .state
            .motion
            .in_play()
    );
    // Missing the colour of the last red brings the yellow on as well.
    let verdict = Story::of(&scene)
        .meet("cue", "pink")
        .cushion("pink", 0)
        .judge(&state, &nominate(&scene, "pink"));
    assert_eq!(
        (verdict.fouls.as_slice(), rules(&verdict.next).on),
        ([].as_slice(), BallOn::Sequence { value: 2 })
    );
    assert_eq!(verdict.next_player(), 1);
}

#[test]
fn a_colour_without_its_spot_takes_the_highest_free_one() {
    let mut balls = whole();
    let blue = balls
        .iter_mut()
        .find(|ball| ball.0 == "red 1")
        .expect("a red");
    *blue = ("red 1", 0.02, 0.0);
    let black = balls
        .iter_mut()
        .find(|ball| ball.0 == "black")
        .expect("a black");
    *black = ("black", 0.3, 0.5);
    let (state, scene) = frame(BallOn::Colour, &balls);
    // The blue's spot is taken by a red; the highest free spot is that of the black, which lies elsewhere.
    let (_, table) = Story::of(&scene)
        .meet("cue", "blue")
        .pot("blue", 5)
        .play(&state, &nominate(&scene, "blue"));
    assert_eq!(place(&table, "blue"), table.table.black_spot());
}

#[test]
fn with_every_spot_taken_a_colour_lies_near_its_own_towards_the_top() {
    let (_, scene) = start(Game::Snooker(Snooker::default()), Preset::Snooker);
    let spot = |name: &str| place(&scene, name);
    let radius = scene.balls[0].ball.radius;
    let mut balls = vec![("cue", -0.4, 0.3)];
    let reds = ["red 1", "red 2", "red 3", "red 4", "red 5", "red 6"];
    for (red, colour) in reds.into_iter().zip(COLOURS) {
        balls.push((red, spot(colour).x, spot(colour).y));
    }
    balls.push(("blue", -0.4, -0.5));
    balls.push(("black", -0.6, -0.5));
    let (state, scene) = frame(BallOn::Colour, &balls);
    let (_, table) = Story::of(&scene)
        .meet("cue", "blue")
        .pot("blue", 5)
        .play(&state, &nominate(&scene, "blue"));
    let wanted = DVec2::new(2.0 * radius + APART, 0.0);
    assert!(
        place(&table, "blue").distance(wanted) < 1e-9,
        "{}",
        place(&table, "blue")
    );
    // The black has 324 mm to the top cushion; with that full of reds it comes down the table.
    let behind: Vec<String> = (7..=12).map(|red| format!("red {red}")).collect();
    for (step, red) in (1..).zip(&behind) {
        balls.push((
            red.as_str(),
            spot("black").x + f64::from(step) * 2.0 * radius * 1.01,
            0.0,
        ));
    }
    let end = 0.5 * scene.table.length - radius;
    balls.retain(|ball| ball.1 < end);
    let (state, scene) = frame(BallOn::Colour, &balls);
    let (_, table) = Story::of(&scene)
        .meet("cue", "black")
        .pot("black", 5)
        .play(&state, &nominate(&scene, "black"));
    let wanted = spot("black") - DVec2::new(2.0 * radius + APART, 0.0);
    assert!(
        place(&table, "black").distance(wanted) < 1e-9,
        "{}",
        place(&table, "black")
    );
}

#[test]
fn the_black_alone_ends_with_the_first_pot_or_foul() {
    let (mut state, scene) = frame(
        BallOn::Sequence { value: 7 },
        &[("cue", 0.0, 0.3), ("black", 0.5, 0.0)],
    );
    state.standing.scores = vec![60, 65];
    let verdict = Story::of(&scene)
        .meet("cue", "black")
        .pot("black", 5)
        .judge(&state, &Call::Nothing);
    let won = |winner| {
        Some(Over {
            winner: Some(winner),
            reason: Reason::LastBall,
        })
    };
    assert_eq!(verdict.next.standing.over, won(0));
    let foul = Story::of(&scene).meet("cue", "black").pot("cue", 5);
    assert_eq!(cost(&foul, &state, &Call::Nothing), 7);
    assert_eq!(
        foul.judge(&state, &Call::Nothing).next.standing.over,
        won(1)
    );
    let neither = Story::of(&scene)
        .meet("cue", "black")
        .cushion("black", 0)
        .judge(&state, &Call::Nothing);
    assert_eq!(
        (neither.next.standing.over, neither.next_player()),
        (None, 1)
    );
}

#[test]
fn level_scores_bring_the_black_back_and_the_lot_decides_who_chooses() {
    let (mut state, scene) = frame(
        BallOn::Sequence { value: 7 },
        &[("cue", 0.0, 0.3), ("black", 0.5, 0.0)],
    );
    state.standing.scores = vec![60, 67];
    let mut chosen = [false; 2];
    for shots in 0..20 {
        state.standing.shots = shots;
        let (verdict, table) = Story::of(&scene)
            .meet("cue", "black")
            .pot("black", 5)
            .play(&state, &Call::Nothing);
        assert_eq!(
            (verdict.next.standing.over, verdict.notes.as_slice()),
            (None, [Note::RespottedBlack].as_slice())
        );
        assert_eq!(place(&table, "black"), table.table.black_spot());
        assert_eq!(
            verdict.next.standing.choices,
            [Choice::GoFirst, Choice::GoSecond]
        );
        let lot = verdict.next_player();
        chosen[lot] = true;
        let second = verdict
            .next
            .choose(&table, Choice::GoSecond)
            .expect("offered");
        assert_eq!(second.next_player(), 1 - lot);
        let first = verdict
            .next
            .choose(&table, Choice::GoFirst)
            .expect("offered");
        assert_eq!(first.next_player(), lot);
        let area = Area::in_d(&table.table);
        assert_eq!(first.next.targets(&table).in_hand, Some(area));
        assert!(area.is_legal(&table, 0, place(&table, "cue")));
        let pot = Story::of(&table)
            .meet("cue", "black")
            .pot("black", 5)
            .judge(&first.next, &Call::Nothing);
        assert_eq!(
            pot.next.standing.over.and_then(|over| over.winner),
            Some(lot)
        );
        let foul = Story::of(&table).judge(&first.next, &Call::Nothing);
        assert_eq!(
            foul.next.standing.over.and_then(|over| over.winner),
            Some(1 - lot)
        );
    }
    assert_eq!(chosen, [true, true], "the lot falls on both");
}
