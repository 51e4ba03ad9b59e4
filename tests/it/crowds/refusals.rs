//! What a crowd refuses, before anything is allocated for it.

use masse::physics::ball::{Ball, Motion};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;

use super::{SMOOTH, as_crowd, gas};

fn refusal(scene: &Scene) -> String {
    scene.check().expect_err("a refusal").to_string()
}

#[test]
fn a_sound_crowd_is_accepted() {
    gas(100, 0.4, 1.0, Laws::ideal(), SMOOTH)
        .check()
        .expect("sound");
    gas(100, 0.4, 1.0, Laws::coursework(), Ball::POOL)
        .check()
        .expect("sound");
}

#[test]
fn a_crowd_names_what_it_cannot_do() {
    let sound = gas(100, 0.4, 1.0, Laws::ideal(), SMOOTH);
    let mut scene = sound.clone();
    scene.balls[7].ball.radius *= 0.5;
    scene.balls[7].state.position.y *= 0.5;
    assert!(refusal(&scene).contains("balls[7]"), "{}", refusal(&scene));
    let mut scene = sound.clone();
    scene.table = Preset::NineFoot.table();
    assert!(refusal(&scene).contains("pockets"), "{}", refusal(&scene));
    let mut scene = sound.clone();
    scene.balls[3].state.motion = Motion::Airborne;
    assert!(refusal(&scene).contains("balls[3]"), "{}", refusal(&scene));
    let mut scene = sound;
    scene.solver = Solver::Stepped(Stepped {
        crowd: true,
        locate: false,
        ..Stepped::default()
    });
    assert!(refusal(&scene).contains("locate"), "{}", refusal(&scene));
}

#[test]
fn ticks_and_grids_out_of_range_are_refused() {
    for (tick, grid, field) in [
        (0.0, None, "solver.tick: 0"),
        (1.0, None, "solver.tick: 1"),
        (f64::NAN, None, "solver.tick"),
        (0.01, Some((0, 10)), "solver.grid.0: 0"),
        (0.01, Some((10, 0)), "solver.grid.1: 0"),
        (0.01, Some((1_000_000, 1_000_000)), "solver.grid"),
    ] {
        let mut scene = gas(10, 0.4, 1.0, Laws::ideal(), SMOOTH);
        as_crowd(&mut scene, tick, grid);
        assert!(refusal(&scene).contains(field), "{}", refusal(&scene));
    }
}

#[test]
fn more_balls_than_fit_are_refused() {
    let mut scene = gas(100, 0.7, 0.0, Laws::ideal(), SMOOTH);
    scene.table = Preset::Box {
        length: 0.5,
        width: 0.5,
    }
    .table();
    for ball in &mut scene.balls {
        ball.state.position *= glam::DVec3::new(0.8, 1.0, 0.8);
    }
    let refusal = refusal(&scene);
    assert!(
        refusal.contains("100 balls") && refusal.contains('%'),
        "{refusal}"
    );
}

/// A scene file is refused by field and value before its balls are laid out.
#[test]
fn a_file_that_cannot_be_played_is_refused_by_field() {
    let with = |fill: &str, solver: &str| {
        let text = format!(
            "(table: Box(length: 10, width: 10), laws: Ideal, ball: (spins: false), fill: ({fill}), \
             solver: Stepped({solver}))"
        );
        masse::scenarios::file::parse(&text, "mine")
    };
    with("count: 10", "crowd: true").expect("sound");
    for (fill, solver, says) in [
        ("count: 40000", "crowd: true", "fill.count: 40000"),
        ("count: 90000000", "crowd: true", "fill.count: 90000000"),
        ("count: 2000000000", "crowd: true", "fill.count: 2000000000"),
        (
            "count: 50, within: ((0, 0), (0.2, 0.2))",
            "crowd: true",
            "fill.count: 50",
        ),
        (
            "count: 50, within: ((1, 0), (-1, 1))",
            "crowd: true",
            "fill.within (x): 1",
        ),
        ("count: 10", "tick: 0, crowd: true", "solver.tick: 0"),
        ("count: 10", "tick: 1, crowd: true", "solver.tick: 1"),
        ("count: 10", "grid: (0, 5), crowd: true", "solver.grid.0: 0"),
        (
            "count: 10",
            "locate: false, crowd: true",
            "solver.locate: false",
        ),
    ] {
        let refusal = with(fill, solver).expect_err("a refusal").to_string();
        assert!(
            refusal.contains(says) && refusal.contains("mine"),
            "{refusal}"
        );
    }
}
