//! Whole racks of every game by hands that hit about what they aim at: no stuck state, and nothing is lost.

use masse::game::matches::{Match, Phase};
use masse::game::rules::{Game, GameState, Reason, Snooker, StraightPool, ThreeCushion, Verdict};
use masse::physics::exact::{Limits, solve};
use masse::physics::scene::Scene;

use super::{Hand, begin};

/// What holds after every stroke of every game.
fn check(game: &Match, before: &[i32], verdict: &Verdict) {
    let standing = &verdict.next.standing;
    let players = game.setup().players.len();
    assert!(standing.turn < players && standing.breaker < players);
    assert_eq!(
        (standing.scores.len(), standing.fouls.len()),
        (players, players)
    );
    let table = game.table();
    table.check().expect("the next stroke can begin");
    assert!(table.balls.iter().all(|ball| ball.state.is_finite()));
    let after: Vec<i32> = before
        .iter()
        .zip(&verdict.points)
        .map(|(a, b)| a + b)
        .collect();
    assert_eq!(standing.scores, after);
    match &verdict.next.game {
        Game::StraightPool(_) => {}
        Game::EightBall(_) | Game::NineBall(_) | Game::TenBall(_) => {
            assert!(verdict.points.iter().all(|points| *points == 0));
        }
        _ => assert!(
            verdict.points.iter().all(|points| *points >= 0),
            "scores grow"
        ),
    }
    for ball in &verdict.made {
        assert!(verdict.pocketed.contains(ball));
    }
    if game.phase() == Phase::Play {
        let on = game.targets();
        assert!(!on.first.is_empty(), "something is on");
        assert!(
            table.balls[on.cue].state.motion.in_play(),
            "there is a ball to strike"
        );
        for ball in on.first.iter().chain(&on.pot) {
            assert!(table.balls[*ball].state.motion.in_play() && *ball != on.cue);
        }
        if let Some(area) = on.in_hand {
            let at = table.balls[on.cue].state.position;
            assert!(area.allows(glam::DVec2::new(at.x, at.z)));
        }
    }
    conserved(game, &table, &verdict.next);
}

/// No ball is lost or doubled, and those that must be on the table are.
fn conserved(game: &Match, table: &Scene, state: &GameState) {
    let in_play = |name: &str| {
        let ball = table.ball_named(name);
        ball.is_some_and(|ball| table.balls[ball].state.motion.in_play())
    };
    let over = state.standing.over.is_some();
    match &state.game {
        Game::EightBall(_) => assert!(over || in_play("8")),
        Game::NineBall(_) => assert!(over || in_play("9")),
        Game::TenBall(_) => assert!(over || in_play("10")),
        Game::StraightPool(_) => {
            let left = table
                .balls
                .iter()
                .skip(1)
                .filter(|ball| in_play(&ball.name))
                .count();
            assert!(over || left >= 2, "the rack is set again before it is gone");
        }
        Game::Snooker(_) => assert!(over || in_play("black")),
        Game::ThreeCushion(_) => assert!(["white", "yellow", "red"].into_iter().all(in_play)),
        Game::FreePractice(_) => {}
    }
    assert_eq!(game.table().balls.len(), table.balls.len());
}

/// Plays strokes, racks one after the other; gives the racks that ended.
fn play(game: &Game, strokes: usize, seed: u64) -> Match {
    let mut played = begin(game, 1000, seed);
    let mut hand = Hand::new(seed);
    for _ in 0..strokes {
        let before = played.state().standing.scores.clone();
        let balls = played.table().balls.len();
        let verdict = hand.play(&mut played);
        assert_eq!(played.table().balls.len(), balls);
        // A fresh rack is broken from no points.
        check(&played, &before, &verdict);
        if played.phase() == Phase::RackOver {
            played.next_rack().expect("the rack is over");
        }
    }
    assert_eq!(played.shots().len(), strokes);
    played
}

/// Shots solved again have the bits they had: the same verdict comes from the scene that was kept.
fn replays(game: &Match) {
    for index in (0..game.shots().len()).step_by(17) {
        let shot = &game.shots()[index];
        let scene = game.replay(index).expect("the shot was played");
        let record = solve(&scene, Limits::default()).expect("it is played again");
        let verdict = shot.before.judge(&scene, &record, &shot.call);
        assert_eq!(
            (
                &verdict.fouls,
                &verdict.pocketed,
                &verdict.made,
                &verdict.points
            ),
            (&shot.fouls, &shot.pocketed, &shot.made, &shot.points)
        );
        if let Some(next) = game.shots().get(index + 1)
            && shot.chosen.is_empty()
            && next.rack == shot.rack
            && next.before.standing.in_hand.is_none()
        {
            let after = verdict.table_after(&scene, &record);
            let kept = game.replay(index + 1).expect("the shot was played");
            assert_eq!(after.balls, kept.balls, "shot {index}");
        }
    }
}

fn figures(game: &Match) {
    let all = game.statistics();
    let sum = |of: fn(&masse::game::matches::Statistics) -> u32| all.iter().map(of).sum::<u32>();
    assert_eq!(sum(|figures| figures.shots) as usize, game.shots().len());
    let fouls = game
        .shots()
        .iter()
        .filter(|shot| !shot.fouls.is_empty())
        .count();
    assert_eq!(sum(|figures| figures.fouls) as usize, fouls);
    let pots: usize = game.shots().iter().map(|shot| shot.made.len()).sum();
    assert_eq!(sum(|figures| figures.pots) as usize, pots);
    for figures in &all {
        assert!(figures.average_thought() > 0.0 && figures.average_thought() < 3.0);
        assert!(figures.best_run >= 0);
    }
}

/// Plays a game for this many strokes; racks must have ended for all of these reasons.
fn whole(game: &Game, strokes: usize, reasons: &[fn(&Reason) -> bool]) {
    let played = play(game, strokes, 7);
    replays(&played);
    figures(&played);
    for (index, is) in reasons.iter().enumerate() {
        let mut ends = played.ends().iter();
        let ended = ends.any(|end| is(&end.over.reason));
        assert!(
            ended,
            "no rack ended for reason {index}: {:?}",
            played.ends()
        );
    }
}

fn named(name: &str) -> Game {
    Game::named(name).expect("there is such a game")
}

const WON: fn(&Reason) -> bool = |reason| matches!(reason, Reason::WinningBall { .. });
const LOST: fn(&Reason) -> bool = |reason| matches!(reason, Reason::LosingBall { .. });
const FOULS: fn(&Reason) -> bool = |reason| *reason == Reason::ThreeFouls;
const LAST: fn(&Reason) -> bool = |reason| *reason == Reason::LastBall;
const MISSES: fn(&Reason) -> bool = |reason| *reason == Reason::ThreeMisses;
const POINTS: fn(&Reason) -> bool = |reason| matches!(reason, Reason::Points { .. });

#[test]
fn eight_ball_racks_end() {
    whole(&named("8-ball"), 1500, &[WON, LOST]);
}

#[test]
fn nine_ball_racks_end() {
    whole(&named("9-ball"), 1500, &[WON, FOULS]);
}

#[test]
fn ten_ball_racks_end() {
    whole(&named("10-ball"), 1500, &[WON, FOULS]);
}

#[test]
fn straight_pool_games_end() {
    let rules = StraightPool {
        to: 5,
        ..StraightPool::default()
    };
    whole(&Game::StraightPool(rules), 1500, &[POINTS]);
}

#[test]
fn snooker_frames_end() {
    whole(&named("snooker"), 3000, &[LAST]);
    let rules = Snooker {
        misses_lose: 1,
        ..Snooker::default()
    };
    whole(&Game::Snooker(rules), 300, &[MISSES]);
}

#[test]
fn three_cushion_games_end() {
    let rules = ThreeCushion {
        to: 3,
        ..ThreeCushion::default()
    };
    whole(&Game::ThreeCushion(rules), 1500, &[POINTS]);
}

#[test]
fn practice_goes_on() {
    whole(&named("practice"), 500, &[]);
}
