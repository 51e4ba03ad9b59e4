//! The built-in crowds.

use masse::scenarios::library::{CROWDS, open};
use masse::sim::stepped::crowd::Census;
use masse::sim::stepping;

#[test]
fn every_crowd_has_a_title() {
    for crowd in CROWDS {
        assert!(!crowd.title().expect("a scene file").is_empty());
    }
}

/// The rack lies in rows that touch nothing, and the blow of one ball opens it.
#[test]
fn a_rack_of_5050_is_opened_by_one_ball() {
    let scene = open("rack-5050").expect("built in").scene;
    assert_eq!(scene.balls.len(), 5051);
    assert!(scene.solver.is_crowd());
    let mut app = stepping::headless_app(&scene);
    // It takes the ball 72 ticks to reach the rack.
    stepping::step(&mut app, 180);
    let census = app.world().resource::<Census>().clone();
    // The blow runs along the lines of the lattice to the far edge; what is not on its way stays where it is.
    let states = stepping::states(&mut app);
    let moved = |i: &usize| (states[*i].position - scene.balls[*i].state.position).length() > 1e-3;
    let (all, far) = (
        (1..5051).filter(moved).count(),
        (4951..5051).filter(moved).count(),
    );
    assert!(census.contacts_in_all > 400, "{census:?}");
    assert!(
        (80..2500).contains(&all) && far > 1,
        "{all} moved, {far} in the last row"
    );
    assert!(
        census.overlap < 0.01 * 2.0 * scene.balls[0].ball.radius,
        "{census:?}"
    );
    let before = 0.5 * scene.balls[0].ball.mass * 20.0 * 20.0;
    assert!((census.energy / before - 1.0).abs() < 1e-9, "{census:?}");
}

/// A lattice fills the table row by row with as many balls as are asked for.
#[test]
fn the_balls_of_the_report_lie_on_a_lattice() {
    let scene = open("crowd-5750").expect("built in").scene;
    assert_eq!(scene.balls.len(), 5750);
    let rows: Vec<f64> = scene
        .balls
        .iter()
        .map(|ball| ball.state.position.z)
        .collect();
    let pitch = scene.table.width / 76.0;
    assert!(rows.windows(2).all(|pair| pair[1] > pair[0] - pitch));
}

/// A crowd on the command line is counted.
#[test]
fn the_command_line_counts_a_crowd() {
    let run = |more: &[&str]| {
        let mut command = crate::cli::masse();
        command.args(["run", "crowd-5750", "--time-limit", "0.02"]);
        command.args(more).output().expect("it runs")
    };
    let done = run(&[]);
    assert_eq!(done.status.code(), Some(0));
    let line = String::from_utf8(done.stdout).expect("text");
    let census: serde_json::Value = serde_json::from_str(&line).expect("a line of JSON");
    assert_eq!(census["balls"], 5750);
    assert!(census["energy"].as_f64().expect("a number") > 0.0);
    let refused = run(&["--out", "crowd.jsonl"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--out"));
}
