//! Scenes played many times with other numbers.

use masse::physics::exact::{Limits, solve};
use masse::physics::laws::ball_ball::{BallBallLaw, Frictional};
use masse::physics::record::EndReason;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::scenarios::dial::Dial;
use masse::scenarios::file::Scenario;
use masse::scenarios::library;
use masse::scenarios::sweep::{Axis, AxisError, Sweep};
use masse::sim::play::play;

use crate::cli::{err, folder, masse, out, output};

fn open(name: &str) -> Scenario {
    library::open(name).expect("a scene")
}

fn axes(scene: &Scene, texts: &[&str]) -> Vec<Axis> {
    let parsed = texts.iter().map(|text| Axis::parse(text, scene));
    parsed
        .collect::<Result<_, _>>()
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_value_meets_every_other_and_the_last_axis_is_the_fastest() {
    let scenario = open("stun-shot");
    let axes = axes(
        &scenario.scene,
        &["speed=1:2:3", "side=-0.1,0.2", "cue.mass=0.5"],
    );
    let sweep = Sweep::grid(&scenario, axes).expect("a grid");
    let values: Vec<_> = (0..sweep.shots()).map(|shot| sweep.values(shot)).collect();
    assert_eq!(
        values,
        [
            [1.0, -0.1, 0.5],
            [1.0, 0.2, 0.5],
            [1.5, -0.1, 0.5],
            [1.5, 0.2, 0.5],
            [2.0, -0.1, 0.5],
            [2.0, 0.2, 0.5],
        ]
    );
}

/// Every kind of number, set by hand in the same scene: the same shot to the last bit.
#[test]
fn a_row_is_the_shot_with_these_numbers() {
    let scenario = open("throw");
    let texts = [
        "speed=1.7",
        "heading=1.5",
        "balls.cue.x=-0.45",
        "balls.1.mass=0.2",
        "laws.ball_ball.restitution=0.9",
        "cue.mass=0.6",
        "table.nose_height=0.037",
    ];
    let sweep = Sweep::grid(&scenario, axes(&scenario.scene, &texts)).expect("a grid");
    let rows = sweep.play(0..1);
    let played = rows[0].played.as_ref().expect("it can be played");

    let mut scene = scenario.scene.clone();
    let planned = scene.shot.as_mut().expect("a shot");
    Dial::Speed.set(&mut planned.shot, 1.7);
    Dial::Heading.set(&mut planned.shot, 1.5);
    let (cue, one) = (
        scene.ball_named("cue").expect("a ball"),
        scene.ball_named("1").expect("a ball"),
    );
    scene.balls[cue].state.position.x = -0.45;
    scene.balls[one].ball.mass = 0.2;
    let BallBallLaw::Frictional(Frictional { restitution, .. }) = &mut scene.laws.ball_ball else {
        panic!("another law");
    };
    *restitution = 0.9;
    scene.cue.mass = 0.6;
    scene.table.nose_height = 0.037;
    let record = solve(&scene, Limits::default()).expect("it can be played");
    assert_eq!(played.end, record.end);
    assert_eq!(played.time, record.end_time);
    assert_eq!(played.outcomes, scenario.judge(&record));
    assert_ne!(
        record.end,
        solve(&scenario.scene, Limits::default())
            .expect("it plays")
            .end
    );
}

#[test]
fn threads_and_the_number_of_shots_change_no_row() {
    let scenario = open("break-eight");
    let axes = axes(
        &scenario.scene,
        &["speed=6:11", "heading=0+-0.5", "side=0,0.1"],
    );
    let few = Sweep::random(&scenario, axes.clone(), 70, 3).expect("a sweep");
    let many = Sweep::random(&scenario, axes.clone(), 140, 3).expect("a sweep");
    let other = Sweep::random(&scenario, axes, 70, 4).expect("a sweep");
    let rows = few.play(0..70);
    let on_one = few.on_threads(1).expect("a thread").play(0..70);
    assert_eq!(rows, on_one);
    let on_three = many.on_threads(3).expect("threads").play(0..140);
    assert_eq!(rows, on_three[..70]);
    assert_ne!(rows[0].values, other.values(0));
    let speeds = on_three.iter().map(|row| row.values[0]);
    assert!(speeds.clone().all(|speed| (6.0..11.0).contains(&speed)));
    let mean = speeds.sum::<f64>() / 140.0;
    assert!((mean - 8.5).abs() < 0.5, "{mean}");
    let normal: Vec<f64> = on_three.iter().map(|row| row.values[1]).collect();
    let square = normal.iter().map(|value| value * value).sum::<f64>() / 140.0;
    assert!((square.sqrt() - 0.5).abs() < 0.1, "{square}");
    assert!(rows.iter().all(|row| [0.0, 0.1].contains(&row.values[2])));
}

#[test]
fn the_stepped_solver_sweeps_too() {
    let mut scenario = open("stun-shot");
    scenario.scene.solver = Solver::Stepped(Stepped::default());
    let sweep = Sweep::grid(&scenario, axes(&scenario.scene, &["speed=1,2"])).expect("a grid");
    let mut scene = scenario.scene.clone();
    Dial::Speed.set(&mut scene.shot.as_mut().expect("a shot").shot, 2.0);
    let record = play(&scene).expect("it can be played");
    let rows = sweep.play(1..2);
    let played = rows[0].played.as_ref().expect("it can be played");
    assert_eq!((&played.end, played.time), (&record.end, record.end_time));
    assert_eq!(played.reason, Some(EndReason::Rest));
}

#[test]
fn what_cannot_vary_is_told_with_what_can() {
    let scene = open("stun-shot").scene;
    let still = open("gas").scene;
    for (text, scene, words) in [
        ("speed", &scene, "speed=1:7:100"),
        ("speed=", &scene, "speed=1:7:100"),
        ("speed=1:2:0", &scene, "speed=1:7:100"),
        ("speed=1:2:3:4", &scene, "speed=1:7:100"),
        ("speed=inf", &scene, "speed=1:7:100"),
        ("speed=1+--1", &scene, "speed=1:7:100"),
        ("spin=1", &scene, "heading, speed, side, height, elevation"),
        ("laws.cushions.friction=1", &scene, "ball_ball, cushion"),
        ("laws.cushion=1", &scene, "friction, restitution"),
        ("balls.7.x=1", &scene, "cue, 1"),
        ("balls.1.colour=1", &scene, "x, z, mass, radius"),
        ("balls.1=1", &scene, "x, z, mass, radius"),
        ("speed=1", &still, "no shot"),
    ] {
        let error = Axis::parse(text, scene).expect_err(text).to_string();
        assert!(error.contains(words), "{text}: {error}");
    }
    let scenario = open("stun-shot");
    let twice = axes(&scene, &["speed=1", "speed=2"]);
    assert!(matches!(
        Sweep::grid(&scenario, twice),
        Err(AxisError::Twice { .. })
    ));
    let random = axes(&scene, &["speed=1:2"]);
    assert!(matches!(
        Sweep::grid(&scenario, random),
        Err(AxisError::NoCount { .. })
    ));
}

#[test]
fn the_table_has_a_row_for_every_shot_and_says_why_one_could_not_be_played() {
    let file = folder("sweeps").join("stun.csv");
    let sweep = output(
        masse()
            .args(["sweep", "stun-shot", "--over", "speed=1,200", "--over"])
            .args(["balls.1.x=0.3,-0.4", "--threads", "2", "--out"])
            .arg(&file),
    );
    assert_eq!(sweep.status.code(), Some(0), "{}", err(&sweep));
    assert!(
        err(&sweep).contains("3 cannot be played"),
        "{}",
        err(&sweep)
    );
    let mut csv = csv::Reader::from_path(&file).expect("a table");
    let head = csv.headers().expect("a head").clone();
    let column = |name: &str| head.iter().position(|head| head == name).expect(name);
    let rows: Vec<_> = csv.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 4);
    assert_eq!(&rows[0][column("reason")], "rest");
    assert!(
        rows[1][column("reason")].contains("overlap"),
        "{:?}",
        rows[1]
    );
    assert!(rows[2][column("reason")].contains("shot.speed: 200"));
    let scenario = open("stun-shot");
    let mut scene = scenario.scene.clone();
    Dial::Speed.set(&mut scene.shot.as_mut().expect("a shot").shot, 1.0);
    scene.balls[1].state.position.x = 0.3;
    let record = solve(&scene, Limits::default()).expect("it can be played");
    let x: f64 = rows[0][column("cue.x")].parse().expect("a number");
    assert_eq!(x, record.end[0].position.x);
    let found: Vec<_> = scenario.judge(&record);
    for (i, outcome) in found.iter().enumerate() {
        let cell = &rows[0][column(&format!("found_{}", i + 1))];
        assert_eq!(cell.parse().ok(), outcome.found);
    }
    // To the standard output the same.
    let printed = output(masse().args([
        "sweep",
        "stun-shot",
        "--over",
        "speed=1,200",
        "--over",
        "balls.1.x=0.3,-0.4",
    ]));
    assert_eq!(out(&printed), std::fs::read_to_string(&file).expect("text"));
}

#[test]
fn the_command_refuses_what_has_no_rows() {
    for (arguments, words) in [
        (
            &["sweep", "crowd-5750", "--over", "cue.mass=1"][..],
            "crowd",
        ),
        (&["sweep", "stun-shot"], "--over"),
        (&["sweep", "stun-shot", "--over", "foo=1"], "no such number"),
        (
            &["sweep", "stun-shot", "--over", "speed=1", "--seed", "2"],
            "--shots",
        ),
    ] {
        let refused = output(masse().args(arguments));
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
        assert!(err(&refused).contains(words), "{}", err(&refused));
        assert_eq!(out(&refused), "");
    }
}

/// `masse run --states`: every ball at even times, as the record has it.
#[test]
fn states_are_written_at_even_times_and_at_the_end() {
    let file = folder("states").join("draw.csv");
    let run = output(
        masse()
            .args(["run", "draw-back", "--quiet", "--every", "0.25", "--states"])
            .arg(&file),
    );
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    let scene = open("draw-back").scene;
    let record = solve(&scene, Limits::default()).expect("it can be played");
    let mut csv = csv::Reader::from_path(&file).expect("a table");
    let rows: Vec<_> = csv.records().map(|row| row.expect("a row")).collect();
    let times = (record.end_time / 0.25).ceil() as usize + 1;
    assert_eq!(rows.len(), times * scene.balls.len());
    for (i, row) in rows.iter().enumerate() {
        let ball = i % scene.balls.len();
        let number = |column: usize| row[column].parse::<f64>().expect("a number");
        let step = i / scene.balls.len();
        let time = if step + 1 == times {
            record.end_time
        } else {
            0.25 * step as f64
        };
        assert_eq!(number(0), time);
        assert_eq!(row[1], scene.balls[ball].name);
        let state = record.state_at(ball, time);
        assert_eq!([number(2), number(3), number(4)], state.position.to_array());
        assert_eq!([number(5), number(6), number(7)], state.velocity.to_array());
        let spin = [number(8), number(9), number(10)];
        assert_eq!(spin, state.angular_velocity.to_array());
    }
    let bad = output(masse().args(["run", "gas", "--states", "x.csv", "--every", "0"]));
    assert_eq!(bad.status.code(), Some(2));
}
