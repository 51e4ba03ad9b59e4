//! What a referee sees in a record: hanging balls, balls held up, cushions left and reached again.

use masse::game::rules::{Call, EightBall, Facts, Game};
use masse::physics::ball::Motion;
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::scene::PlannedShot;
use masse::physics::table::Preset;

use super::story::{Story, lay, place, start};

/// The table of 8-ball with these balls.
fn table(balls: &[(&str, f64, f64)]) -> masse::physics::scene::Scene {
    let (_, mut scene) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
    lay(&mut scene, balls);
    scene
}

#[test]
fn a_ball_that_hangs_and_drops_counts_for_five_seconds() {
    let scene = table(&[("cue", 0.0, 0.0), ("1", 1.2, 0.6), ("8", 0.5, 0.0)]);
    let one = scene.ball_named("1").expect("a 1");
    let hang = |time: f64| {
        Story::of(&scene)
            .meet("cue", "1")
            .cushion("1", 0)
            .go("1", 1.25, 0.61)
            .motion("1", Motion::Rolling, Motion::Rest)
            .wait(time)
            .pot("1", 5)
    };
    let soon = hang(4.8);
    assert!(Facts::new(&scene, soon.record(), 0).potted(one).is_some());
    let late = hang(5.2);
    let facts = Facts::new(&scene, late.record(), 0);
    assert!(facts.potted(one).is_none());
    assert_eq!(facts.fell_late.len(), 1);
    let (state, _) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
    let (verdict, after) = late.play(&state, &Call::Nothing);
    assert!(verdict.pocketed.is_empty());
    assert_eq!(
        place(&after, "1"),
        glam::DVec2::new(1.25, 0.61),
        "back where it hung"
    );
    // Touched again while it hangs, it falls by that touch.
    let touched = Story::of(&scene)
        .meet("cue", "1")
        .motion("1", Motion::Rolling, Motion::Rest)
        .wait(9.0)
        .meet("8", "1")
        .pot("1", 5);
    assert!(
        Facts::new(&scene, touched.record(), 0)
            .potted(one)
            .is_some()
    );
}

#[test]
fn a_ball_held_up_by_another_counts_as_fallen_and_one_that_comes_back_out_does_not() {
    let scene = table(&[("cue", 0.0, 0.0), ("1", 1.2, 0.6), ("8", 0.5, 0.0)]);
    let one = scene.ball_named("1").expect("a 1");
    let hole = scene.table.pockets[5].center;
    let held = Story::of(&scene)
        .meet("cue", "1")
        .go("1", hole.x - 0.01, hole.y);
    assert_eq!(
        Facts::new(&scene, held.record(), 0)
            .potted(one)
            .map(|pot| pot.pocket),
        Some(5)
    );
    let out = Story::of(&scene)
        .meet("cue", "1")
        .pot("1", 5)
        .go("1", 1.0, 0.5);
    assert!(Facts::new(&scene, out.record(), 0).potted(one).is_none());
}

#[test]
fn a_frozen_ball_must_leave_its_cushion_and_come_back_or_reach_another() {
    let free = table(&[("cue", 0.0, 0.0), ("1", 0.5, 0.3), ("8", 0.9, 0.0)]);
    let reach = free.table.reach(free.balls[1].ball.radius);
    let at_rail = 0.5 * free.table.width - reach - 2e-6;
    let scene = table(&[("cue", 0.0, 0.0), ("1", 0.5, at_rail), ("8", 0.9, 0.0)]);
    let one = scene.ball_named("1").expect("a 1");
    let nose = (0..scene.table.cushions.len())
        .find(|&cushion| {
            Facts::new(&scene, Story::of(&scene).record(), 0).is_frozen_to(one, cushion)
        })
        .expect("the ball is frozen to a cushion");
    let driven = |story: Story| {
        !Facts::new(&scene, story.record(), 0)
            .cushions_of(one)
            .is_empty()
    };
    let stays = Story::of(&scene)
        .meet("cue", "1")
        .cushion("1", nose)
        .cushion("1", nose);
    assert!(!driven(stays));
    let slides = Story::of(&scene)
        .meet("cue", "1")
        .go("1", 0.6, at_rail)
        .cushion("1", nose);
    assert!(!driven(slides));
    let back = Story::of(&scene)
        .meet("cue", "1")
        .go("1", 0.6, 0.4)
        .go("1", 0.7, at_rail)
        .cushion("1", nose);
    assert!(driven(back));
    let other = (nose + 5) % scene.table.cushions.len();
    assert!(driven(
        Story::of(&scene).meet("cue", "1").cushion("1", other)
    ));
}

#[test]
fn a_ball_that_flies_over_the_rail_and_comes_back_is_not_off() {
    let scene = table(&[("cue", 0.0, 0.0), ("1", 0.5, 0.3), ("8", 0.9, 0.0)]);
    let (state, _) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
    let beyond = 0.5 * scene.table.width + 0.05;
    let back = Story::of(&scene)
        .meet("cue", "1")
        .fly("1", 0.6, beyond)
        .fly("1", 0.7, 0.4);
    let off = |story: &Story| Facts::new(&scene, story.record(), 0).off.len();
    assert_eq!(off(&back), 0);
    assert_eq!(back.judge(&state, &Call::Nothing).fouls, []);
    let gone = Story::of(&scene)
        .meet("cue", "1")
        .fly("1", 0.6, beyond)
        .off("1");
    assert_eq!(off(&gone), 1);
}

#[test]
fn a_frozen_object_ball_is_met_when_shot_into_and_not_when_shot_away_from() {
    let radius = masse::physics::ball::Ball::POOL.radius;
    let mut scene = table(&[("cue", 0.0, 0.0), ("1", 2.0 * radius, 0.0), ("8", 0.9, 0.3)]);
    for (heading, met) in [
        (0.0, true),
        (0.7, true),
        (2.5, false),
        (std::f64::consts::PI, false),
    ] {
        let shot = Shot {
            heading,
            speed: 1.0,
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = solve(&scene, Limits::default()).expect("the shot is played");
        let facts = Facts::new(&scene, &record, 0);
        assert!(facts.are_frozen(0, 1));
        assert_eq!(facts.first_time == Some(0.0), met, "heading {heading}");
        let fouls = masse::game::rules::Foul::Push { ball: 1 };
        let (state, _) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
        let verdict = state.judge(&scene, &record, &Call::Nothing);
        assert!(
            !verdict.fouls.contains(&fouls),
            "to shoot at it is no foul at pool"
        );
    }
}

#[test]
fn strings_and_spots_lie_at_quarters_of_the_table() {
    for preset in [Preset::NineFoot, Preset::EightFoot, Preset::SevenFoot] {
        let table = preset.table();
        assert_eq!(
            table.head_spot(),
            glam::DVec2::new(-0.25 * table.length, 0.0)
        );
        assert_eq!(
            table.foot_spot(),
            glam::DVec2::new(0.25 * table.length, 0.0)
        );
    }
}
