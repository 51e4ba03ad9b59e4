//! Record files: what is written is read back with every bit, and what is damaged is named.

mod damage;
mod drawing;

use masse::physics::ball::State;
use masse::physics::exact;
use masse::physics::laws::Laws;
use masse::physics::record::{Event, PathPiece, Record};
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::report::record_file;
use masse::scenarios::library;
use masse::sim::stepping;

fn text(name: &str, title: &str, scene: &Scene, record: &Record) -> String {
    let mut out = Vec::new();
    record_file::write(&mut out, name, title, scene, record).expect("memory can be written");
    String::from_utf8(out).expect("JSON is text")
}

fn played(scene: &Scene) -> Record {
    match scene.solver {
        Solver::Exact => exact::solve(scene, exact::Limits::default()).expect("it can be played"),
        Solver::Stepped(_) => stepping::run_to_rest(scene).0,
    }
}

/// Every number of a state by its bits: 0 and -0 differ.
fn state_bits(state: &State) -> Vec<u64> {
    [state.position, state.velocity, state.angular_velocity]
        .iter()
        .flat_map(|vector| vector.to_array().map(f64::to_bits))
        .collect()
}

fn event_bits(event: &Event) -> Vec<u64> {
    let states = event.participants().flat_map(|participant| {
        [
            state_bits(&participant.before),
            state_bits(&participant.after),
        ]
        .concat()
    });
    [event.time.to_bits(), event.impulse.to_bits()]
        .into_iter()
        .chain(states)
        .collect()
}

fn piece_bits(turn: &PathPiece) -> Vec<u64> {
    let piece = &turn.piece;
    let rates = [piece.acceleration, piece.angular_acceleration];
    [turn.time, piece.spin_deceleration, piece.duration]
        .map(f64::to_bits)
        .into_iter()
        .chain(state_bits(&piece.start))
        .chain(
            rates
                .iter()
                .flat_map(|rate| rate.to_array().map(f64::to_bits)),
        )
        .collect()
}

/// Every number of a record by its bits.
fn bits(record: &Record) -> Vec<Vec<u64>> {
    let events = record.events.iter().map(event_bits);
    let pieces = record.paths.iter().flatten().map(piece_bits);
    let end = record.end.iter().map(state_bits);
    let time = vec![record.end_time.to_bits()];
    events.chain(pieces).chain(end).chain([time]).collect()
}

#[test]
fn every_built_in_scene_comes_back_bit_for_bit() {
    for built_in in library::BUILT_IN {
        let scenario = built_in.scenario().expect("it is sound");
        let mut scene = scenario.scene;
        // Long enough for contacts of every kind, short enough for a test.
        scene.time_limit = if scene.balls.len() > 40 { 0.2 } else { 20.0 };
        let mut solvers = vec![Solver::Stepped(Stepped::default())];
        if scene.laws.motion.is_closed_form() {
            solvers.push(Solver::Exact);
        }
        for solver in solvers {
            scene.solver = solver;
            let what = format!("{} {solver:?}", built_in.name);
            let record = played(&scene);
            assert!(!record.paths.is_empty(), "{what}");
            let written = text(built_in.name, &scenario.title, &scene, &record);
            let read = record_file::parse(&written, built_in.name)
                .unwrap_or_else(|error| panic!("{what}: {error}"));
            assert_eq!(read.scene, scene, "{what}");
            assert_eq!(read.record, record, "{what}");
            assert_eq!(bits(&read.record), bits(&record), "{what}");
            assert_eq!(
                (read.name.as_str(), &read.title),
                (built_in.name, &scenario.title)
            );
            let again = text(&read.name, &read.title, &read.scene, &read.record);
            assert_eq!(again, written, "{what}: written again, it is another text");
        }
    }
}

#[test]
fn states_between_the_events_come_back_too() {
    let scene = library::open("break-nine").expect("a scene").scene;
    let record = played(&scene);
    let read = record_file::parse(&text("a", "b", &scene, &record), "a").expect("it is whole");
    for ball in 0..scene.balls.len() {
        for part in 0..=50 {
            let time = record.end_time * f64::from(part) / 50.0;
            let (one, two) = (
                record.state_at(ball, time),
                read.record.state_at(ball, time),
            );
            assert_eq!(
                state_bits(&one),
                state_bits(&two),
                "ball {ball} at {time} s"
            );
        }
    }
}

#[test]
fn a_record_of_another_scene_is_not_written() {
    let mut scene = library::open("stun-shot").expect("a scene").scene;
    let record = played(&scene);
    let refused = |scene: &Scene| {
        let written = record_file::write(&mut Vec::new(), "a", "b", scene, &record);
        written.expect_err("the scene is another").kind()
    };
    let mut fewer = scene.clone();
    fewer.balls.pop();
    assert_eq!(refused(&fewer), std::io::ErrorKind::InvalidInput);
    scene.laws = Laws::ideal();
    assert_eq!(refused(&scene), std::io::ErrorKind::InvalidInput);
}
