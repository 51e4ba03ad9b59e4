//! Every built-in scene loads, plays headless and survives being written out.

use masse::physics::ball::Motion;
use masse::physics::exact::{self, Limits};
use masse::physics::record::{EndReason, Event, EventKind, Record};
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::scenarios::{file, library};
use masse::sim::stepping;

fn scene(name: &str) -> Scene {
    match library::open(name) {
        Ok(scenario) => scenario.scene,
        Err(error) => panic!("{error}"),
    }
}

fn played(name: &str) -> (Scene, Record) {
    let scene = scene(name);
    let (record, _) = stepping::run_to_rest(&scene);
    (scene, record)
}

/// Kinetic energy of all balls, J.
fn energy(scene: &Scene, record: &Record) -> (f64, f64) {
    let of = |states: &mut dyn Iterator<Item = masse::physics::ball::State>| {
        scene
            .balls
            .iter()
            .zip(states)
            .map(|(ball, state)| ball.ball.kinetic_energy(&state))
            .sum()
    };
    (
        of(&mut scene.balls.iter().map(|ball| ball.state)),
        of(&mut record.end.iter().copied()),
    )
}

#[test]
fn every_built_in_scene_has_a_title_and_plays() {
    for built_in in library::BUILT_IN {
        let scenario = built_in
            .scenario()
            .unwrap_or_else(|error| panic!("{error}"));
        assert!(
            !scenario.title.is_empty() && !scenario.description.is_empty(),
            "{}",
            built_in.name
        );
        let (record, _) = stepping::run_to_rest(&scenario.scene);
        assert!(
            !record.events.is_empty(),
            "{}: nothing happens",
            built_in.name
        );
        assert!(
            record
                .end
                .iter()
                .all(masse::physics::ball::State::is_finite),
            "{}",
            built_in.name
        );
        let ends = matches!(record.reason, Some(EndReason::Rest))
            || record.end_time >= scenario.scene.time_limit;
        assert!(
            ends,
            "{}: {:?} at {} s",
            built_in.name, record.reason, record.end_time
        );
    }
}

#[test]
fn both_solvers_end_the_same_where_nothing_is_chaotic() {
    for name in [
        "stop-shot",
        "draw-back",
        "stun-shot",
        "follow",
        "throw",
        "masse",
        "jump-shot",
        "real-backspin",
        "real-side-curve",
    ] {
        let mut scene = scene(name);
        scene.solver = Solver::Stepped(Stepped::default());
        let (stepped, _) = stepping::run_to_rest(&scene);
        scene.solver = Solver::Exact;
        let exact = exact::solve(&scene, Limits::default())
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        for (ball, (one, other)) in stepped.end.iter().zip(&exact.end).enumerate() {
            assert_eq!(one.motion, other.motion, "{name}: ball {ball}");
            let apart = (one.position - other.position).length();
            assert!(apart < 1e-6, "{name}: ball {ball} ends {apart} m apart");
        }
    }
}

#[test]
fn every_built_in_scene_is_written_and_read_bit_for_bit() {
    for built_in in library::BUILT_IN {
        let scenario = built_in
            .scenario()
            .unwrap_or_else(|error| panic!("{error}"));
        let text = file::write(&scenario).unwrap_or_else(|error| panic!("{error}"));
        let again = file::parse(&text, built_in.name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(
            format!("{scenario:?}"),
            format!("{again:?}"),
            "{}",
            built_in.name
        );
    }
}

#[test]
fn the_names_are_told_apart() {
    let mut names: Vec<&str> = library::BUILT_IN.iter().map(|scene| scene.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), library::BUILT_IN.len());
    let error = library::open("brake-eight")
        .expect_err("no such scene")
        .to_string();
    assert!(
        error.contains("`brake-eight`") && error.contains("break-eight"),
        "{error}"
    );
}

#[test]
fn the_parts_of_the_coursework_do_what_they_say() {
    // Part 1: every pair, nothing lost.
    let (first, record) = played("coursework-1-collisions");
    assert!(matches!(&first.solver, Solver::Stepped(stepped) if stepped.grid.is_none()));
    let (before, after) = energy(&first, &record);
    assert!(
        (after / before - 1.0).abs() < 1e-9,
        "{before} J becomes {after} J"
    );
    // Part 2: the grid finds what every pair finds.
    let (mut second, record) = played("coursework-2-grid");
    assert!(matches!(&second.solver, Solver::Stepped(stepped) if stepped.grid == Some((20, 20))));
    if let Solver::Stepped(stepped) = &mut second.solver {
        stepped.grid = None;
    }
    let (without, _) = stepping::run_to_rest(&second);
    assert_eq!(record.end, without.end);
    // Part 3: out, stopped by back spin, and back past the start.
    let third = scene("coursework-3-backspin");
    let (record, recorder) = stepping::run_to_rest(&third);
    let start = third.balls[0].state.position.x;
    let farthest = recorder.trails[0]
        .iter()
        .map(|(_, state)| state.position.x)
        .fold(start, f64::max);
    assert!(
        farthest > start + 0.1 && farthest < 1.0,
        "it goes out to {farthest} m"
    );
    assert!(
        record.end[0].position.x < start - 0.1,
        "it comes back to {} m",
        record.end[0].position.x
    );
    // Draw and english together: it hits the 1, and is drawn back behind the place of the hit.
    let (_, record) = played("coursework-3-draw-english");
    let hit = record.events.first().expect("an event");
    assert_eq!(hit.kind, EventKind::BallBall);
    assert!(
        record.end[0].position.x < hit.first.before.position.x - 0.1,
        "{:?}",
        record.end[0]
    );
    // English turns the path on the open cloth, before any cushion.
    let (record, recorder) = stepping::run_to_rest(&scene("coursework-3-side-curve"));
    let cushion = record.events.first().expect("a cushion").time;
    let (_, last) = recorder.trails[0]
        .iter()
        .rfind(|(time, _)| *time < cushion)
        .expect("a path");
    let turned = last.velocity.z.abs() / last.velocity.length();
    assert!(turned > 0.1, "turned by the sine {turned}");
}

/// Velocity with which the first ball that rolls begins to roll.
fn first_roll(record: &Record) -> glam::DVec3 {
    let mut afters = record.events.iter().map(|event| event.first.after);
    afters
        .find(|after| after.motion == Motion::Rolling)
        .expect("it rolls")
        .velocity
}

#[test]
fn the_real_spin_shots_do_what_they_say() {
    // Steep back spin brings a lone ball back past its start (closed form: it rolls back at 0.3385 m/s).
    let (scene, record) = played("real-backspin");
    let rolls = first_roll(&record);
    let back = rolls;
    assert!(
        (back.x - 0.3385).abs() < 1e-3
            && scene.balls[0].state.position.x < record.end[0].position.x
    );
    // English under a raised cue ends 16.10 degrees to the right: tan = a tan t.
    let (_, record) = played("real-side-curve");
    let rolls = first_roll(&record);
    let along = rolls;
    assert!(
        (along.z / along.x - 0.5 * libm::tan(30.0_f64.to_radians())).abs() < 1e-4,
        "{along}"
    );
}

fn first_hit(record: &Record) -> &Event {
    let mut events = record.events.iter();
    events
        .find(|event| event.kind == EventKind::BallBall)
        .expect("a hit")
}

#[test]
fn the_billiards_shots_do_what_they_say() {
    let (stop, record) = played("stop-shot");
    let hit = first_hit(&record);
    let moved = (record.end[0].position - hit.first.before.position).length();
    assert!(moved < 0.005, "the cue ball of a stop shot moves {moved} m");
    assert_eq!(record.end[1].motion, Motion::Pocketed);
    assert_eq!(stop.balls[1].name, "1");
    let (_, record) = played("masse");
    let hit = first_hit(&record);
    assert_eq!(
        (hit.first.ball, hit.second.map(|second| second.ball)),
        (0, Some(2)),
        "it goes round the 8"
    );
    let (_, record) = played("jump-shot");
    let hit = first_hit(&record);
    assert_eq!(
        (hit.first.ball, hit.second.map(|second| second.ball)),
        (0, Some(2)),
        "it flies over the 8"
    );
    assert!(!hit.first.before.motion.flies(), "it has landed");
    let (carom, record) = played("three-cushion");
    let white = carom.ball_named("white").expect("a white ball");
    let yellow = carom.ball_named("yellow").expect("a yellow ball");
    let point = record
        .events
        .iter()
        .position(|e| {
            let balls: Vec<usize> = e.participants().map(|p| p.ball).collect();
            e.kind == EventKind::BallBall && balls.contains(&white) && balls.contains(&yellow)
        })
        .expect("the white ball meets the yellow");
    let cushions = record.events[..point]
        .iter()
        .filter(|e| matches!(e.kind, EventKind::Cushion { .. }) && e.first.ball == white)
        .count();
    assert!(cushions >= 3, "{cushions} cushions before the second ball");
}
