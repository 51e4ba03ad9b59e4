//! What players see: pots, banks, kicks, combinations; that they keep the rules, their budget and their word.

use glam::DVec2;
use masse::game::placing;
use masse::game::players::contest::{execute, put};
use masse::game::players::idea::Kind;
use masse::game::players::{Level, Plan, Thinking};
use masse::game::rules::rotation::Phase;
use masse::game::rules::{Area, Call, Game, GameState, Verdict};
use masse::physics::ball::Motion;
use masse::physics::cue::Shot;
use masse::physics::cue_path;
use masse::physics::exact::{Limits, solve};
use masse::physics::scene::{PlannedShot, Scene};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{eight_ball, lay};

const TOP: Level = Level::ALL[Level::ALL.len() - 1];

fn think(state: &GameState, scene: &Scene, level: &Level) -> (Plan, u32) {
    Thinking::new(state, scene, level, 5)
        .expect("a sound scene")
        .finish()
}

/// Plays a stroke as it is and has it judged.
fn play(state: &GameState, scene: &Scene, plan: &Plan, shot: Shot) -> Verdict {
    let mut scene = scene.clone();
    let cue = state.cue_ball(&scene);
    if let Some(spot) = plan.spot {
        put(&mut scene, cue, spot);
    }
    scene.shot = Some(PlannedShot { ball: cue, shot });
    let record = solve(&scene, Limits::default()).expect("a sound shot");
    state.judge(&scene, &record, &plan.call)
}

fn names(scene: &Scene, balls: &[usize]) -> Vec<String> {
    balls
        .iter()
        .map(|&ball| scene.balls[ball].name.clone())
        .collect()
}

#[test]
fn every_level_pots_a_hanger() {
    let (state, scene) = eight_ball(&[
        (0, 0.4, 0.2),
        (3, 1.2, 0.58),
        (8, -0.6, 0.1),
        (9, -0.9, -0.3),
    ]);
    for level in Level::ALL {
        let (plan, _) = think(&state, &scene, &level);
        assert_eq!(plan.kind, Kind::Pot, "{}", level.name);
        let verdict = play(&state, &scene, &plan, plan.shot);
        assert_eq!(names(&scene, &verdict.made), ["3"], "{}", level.name);
        assert!(!verdict.is_foul());
    }
}

#[test]
fn the_eight_goes_last_and_wins() {
    let (state, scene) = eight_ball(&[
        (0, 0.0, 0.0),
        (8, 0.9, 0.4),
        (9, -0.9, -0.3),
        (12, -0.5, 0.4),
    ]);
    for level in &Level::ALL[1..] {
        let (plan, _) = think(&state, &scene, level);
        assert!(matches!(plan.call, Call::Pot { .. }), "{}", level.name);
        let over = play(&state, &scene, &plan, plan.shot).next.standing.over;
        assert_eq!(over.and_then(|over| over.winner), Some(0), "{}", level.name);
    }
}

#[test]
fn a_bank_is_found_when_it_is_all_there_is() {
    // The 1 lies in front of the middle of a long cushion with stripes between it and every pocket but those across.
    let (state, scene) = eight_ball(&[
        (0, 0.35, -0.2),
        (1, 0.3, 0.5),
        (9, 0.1, 0.57),
        (10, 0.5, 0.57),
        (11, 0.2, 0.3),
        (12, 0.5, 0.25),
        (13, 0.05, -0.1),
        (8, -1.0, 0.0),
    ]);
    let thinking = Thinking::new(&state, &scene, &TOP, 1).expect("a sound scene");
    let (plan, _) = thinking.finish();
    let verdict = play(&state, &scene, &plan, plan.shot);
    assert!(!verdict.is_foul(), "{plan:?}");
    assert_eq!(plan.kind, Kind::Bank, "{plan:?}");
    assert_eq!(names(&scene, &verdict.made), ["1"], "{plan:?}");
}

#[test]
fn a_combination_is_found() {
    let (state, scene) = eight_ball(&[
        (0, 0.2, 0.0),
        (1, 0.85, 0.31),
        (2, 1.16, 0.53),
        (8, -1.0, 0.0),
        (9, -0.8, 0.3),
    ]);
    let (plan, _) = think(&state, &scene, &TOP);
    let verdict = play(&state, &scene, &plan, plan.shot);
    assert!(!verdict.made.is_empty() && !verdict.is_foul(), "{plan:?}");
}

#[test]
fn a_hidden_ball_is_kicked_at() {
    // A wall of stripes between the cue ball and the 1.
    let wall = [-0.12, -0.06, 0.0, 0.06, 0.12];
    let mut balls = vec![(0, -0.2, 0.0), (1, 0.6, 0.0), (8, 1.0, 0.4)];
    balls.extend(wall.iter().zip(9_u8..).map(|(&z, number)| (number, 0.0, z)));
    let (state, scene) = eight_ball(&balls);
    for level in &Level::ALL[2..] {
        let (plan, _) = think(&state, &scene, level);
        let verdict = play(&state, &scene, &plan, plan.shot);
        assert!(
            !verdict.is_foul(),
            "{}: {plan:?} {:?}",
            level.name,
            verdict.fouls
        );
    }
}

/// A table with some balls anywhere.
fn strewn(seed: u64) -> (GameState, Scene) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (state, mut scene) = eight_ball(&[(0, -0.6, 0.0), (8, 0.6, 0.0)]);
    for number in [0, 8, 1, 2, 3, 9, 10, 11, 12] {
        loop {
            let at = DVec2::new(rng.random_range(-1.2..1.2), rng.random_range(-0.57..0.57));
            let name = if number == 0 {
                "cue".to_owned()
            } else {
                number.to_string()
            };
            let ball = scene.ball_named(&name).expect("a ball of the rack");
            if placing::is_free(&scene, ball, at) {
                lay(&mut scene, number, at);
                break;
            }
        }
    }
    (state, scene)
}

#[test]
fn the_top_level_meets_the_right_ball_first() {
    let sampled = 60;
    let mut fouls = Vec::new();
    for seed in 0..sampled {
        let (state, scene) = strewn(seed);
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let (plan, _) = think(&state, &scene, &TOP);
        let cue = state.cue_ball(&scene);
        let shot = execute(&scene, cue, &TOP, &plan.shot, &mut rng);
        assert_eq!(cue_path::obstacle(&scene, cue, &shot), None, "table {seed}");
        let verdict = play(&state, &scene, &plan, shot);
        if verdict.is_foul() {
            fouls.push((seed, plan.kind, verdict.fouls));
        }
    }
    assert!(20 * fouls.len() < sampled as usize, "{fouls:?}");
}

#[test]
fn a_ball_in_hand_is_put_where_it_may_lie() {
    for seed in 0..12 {
        let (mut state, scene) = strewn(100 + seed);
        let table = &scene.table;
        for area in [Area::anywhere(table), Area::behind_head_string(table)] {
            state.standing.in_hand = Some(area);
            for level in [&Level::ALL[0], &Level::ALL[2], &TOP] {
                let (plan, _) = think(&state, &scene, level);
                let spot = plan.spot.expect("a place");
                let cue = state.cue_ball(&scene);
                assert!(
                    area.is_legal(&scene, cue, spot),
                    "table {seed}, {}: {spot}",
                    level.name
                );
            }
        }
    }
}

#[test]
fn the_same_thought_comes_out_the_same() {
    let (state, scene) = strewn(3);
    for level in &Level::ALL {
        let (plan, trials) = think(&state, &scene, level);
        let mut slow = Thinking::new(&state, &scene, level, 5).expect("a sound scene");
        let mut share = 0.0;
        while slow.step() {
            let progress = slow.progress();
            assert!(
                progress.share >= share - 1e-12 && progress.share <= 1.0,
                "{progress:?} after {share}"
            );
            share = progress.share;
        }
        assert_eq!(
            (slow.plan(), slow.progress().trials),
            (plan, trials),
            "{}",
            level.name
        );
        assert_eq!(slow.progress().share, 1.0);
    }
}

#[test]
fn a_thought_keeps_to_its_budget_and_may_be_cut_short() {
    for seed in 0..6 {
        let (state, scene) = strewn(200 + seed);
        for level in &Level::ALL {
            let (_, trials) = think(&state, &scene, level);
            assert!(trials <= level.skills.budget, "{}: {trials}", level.name);
            let mut tiny = *level;
            tiny.skills.budget = 3;
            let (plan, trials) = think(&state, &scene, &tiny);
            assert!(trials <= 3 && plan.shot.speed > 0.0);
        }
        let thinking = Thinking::new(&state, &scene, &TOP, 0).expect("a sound scene");
        let plan = thinking.plan();
        let mut planned = scene.clone();
        planned.shot = Some(PlannedShot {
            ball: 0,
            shot: plan.shot,
        });
        planned.check().expect("a stroke that can be played");
    }
}

#[test]
fn a_scene_that_cannot_be_played_is_refused() {
    let (state, mut scene) = strewn(1);
    scene.balls[1].state.position = scene.balls[2].state.position;
    assert!(Thinking::new(&state, &scene, &TOP, 0).is_err());
}

/// After the break of a game of 9-ball the cue ball lies behind a wall, and the 1 beyond it.
fn hidden_after_the_break() -> (GameState, Scene) {
    let game = Game::named("9-ball").expect("9-ball");
    let (mut state, mut scene) = GameState::start(game, 2, 0, &super::pool(), 1);
    state.standing.in_hand = None;
    state.standing.shots = 1;
    if let Game::NineBall(rules) = &mut state.game {
        rules.phase = Phase::PushOut;
    }
    let wall = [(2, -0.12), (3, -0.06), (4, 0.0), (5, 0.06), (6, 0.12)];
    for placed in &mut scene.balls {
        placed.state.motion = Motion::Pocketed;
    }
    lay(&mut scene, 0, DVec2::new(-0.15, 0.0));
    lay(&mut scene, 1, DVec2::new(0.9, 0.0));
    lay(&mut scene, 9, DVec2::new(1.1, -0.4));
    for (number, z) in wall {
        lay(&mut scene, number, DVec2::new(0.0, z));
    }
    scene.check().expect("the balls have room");
    (state, scene)
}

#[test]
fn who_is_hidden_after_the_break_pushes_out_to_where_neither_has_much() {
    let (state, scene) = hidden_after_the_break();
    // The highest level has a kick that it is sure of.
    for level in &Level::ALL[2..4] {
        let (plan, _) = think(&state, &scene, level);
        assert_eq!(plan.kind, Kind::PushOut, "{}: {plan:?}", level.name);
        assert_eq!(plan.call, Call::PushOut);
        assert!((0.3..0.7).contains(&plan.value), "{plan:?}");
        let verdict = play(&state, &scene, &plan, plan.shot);
        assert!(!verdict.is_foul(), "{:?}", verdict.fouls);
        assert_eq!(verdict.next.standing.choices.len(), 2);
    }
    // Who sees the ball plays it, and nobody pushes out later.
    let (mut state, mut scene) = hidden_after_the_break();
    lay(&mut scene, 0, DVec2::new(0.5, 0.0));
    lay(&mut scene, 1, DVec2::new(1.1, 0.5));
    assert_eq!(think(&state, &scene, &TOP).0.kind, Kind::Pot);
    lay(&mut scene, 0, DVec2::new(-0.15, 0.0));
    if let Game::NineBall(rules) = &mut state.game {
        rules.phase = Phase::Later;
    }
    assert_ne!(think(&state, &scene, &TOP).0.call, Call::PushOut);
}

#[test]
fn who_is_pressed_for_time_still_has_a_plan_and_rehearses_less() {
    let mut rehearsed = (0, 0);
    for seed in 0..6 {
        let (state, scene) = strewn(300 + seed);
        rehearsed.0 += think(&state, &scene, &TOP).1;
        let mut thinking = Thinking::new(&state, &scene, &TOP, 5).expect("a sound scene");
        let mut steps: u32 = 0;
        while thinking.step() {
            steps += 1;
            thinking.press(f64::from(steps) / 6.0);
        }
        assert!(steps <= 10, "{steps}");
        rehearsed.1 += thinking.progress().trials;
        assert!(thinking.best().is_some_and(|plan| plan.shot.speed > 0.0));
    }
    assert!(4 * rehearsed.1 < 3 * rehearsed.0, "{rehearsed:?}");
}

/// Who may neither kick nor push out raises the cue.
fn raiser() -> Level {
    let mut level = TOP;
    level.skills.kick_cushions = 0;
    level
}

#[test]
fn who_is_hidden_behind_a_ball_jumps_over_it_or_bends_around() {
    // A wall to jump over; and a ball too near to be jumped over, that a massé goes around.
    let wall = [(9, 0.0, -0.058), (10, 0.0, 0.0), (11, 0.0, 0.058)];
    let over = [(0, -0.3, 0.0), (3, 0.6, 0.02), (8, -1.0, 0.4)];
    let over: Vec<_> = over.into_iter().chain(wall).collect();
    let around = [
        (0, -0.2, 0.0),
        (9, -0.13, 0.0),
        (3, 0.35, 0.0),
        (8, -1.0, 0.4),
    ];
    for (balls, kind) in [(&over[..], Kind::Jump), (&around[..], Kind::Masse)] {
        let (state, scene) = eight_ball(balls);
        let (plan, _) = think(&state, &scene, &raiser());
        assert_eq!(plan.kind, kind, "{plan:?}");
        assert!(plan.shot.elevation > 0.3 && plan.chance > 0.5, "{plan:?}");
        let verdict = play(&state, &scene, &plan, plan.shot);
        assert!(!verdict.is_foul(), "{:?}", verdict.fouls);
    }
}

#[test]
fn a_jump_pots_a_hidden_ball() {
    let (state, scene) = eight_ball(&[
        (0, 0.2, 0.0),
        (9, 0.45, 0.12),
        (3, 0.9, 0.35),
        (8, -1.0, 0.4),
    ]);
    let (plan, _) = think(&state, &scene, &raiser());
    assert_eq!(plan.kind, Kind::Jump, "{plan:?}");
    let verdict = play(&state, &scene, &plan, plan.shot);
    assert_eq!(names(&scene, &verdict.made), ["3"]);
}
