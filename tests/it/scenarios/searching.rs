//! A search finds what is wanted, the same on any number of threads, and says what it cannot do.

use std::sync::Mutex;

use super::{command_line, played, scenario};
use masse::scenarios::file;
use masse::scenarios::search::{Found, Plan, Player, SearchError, Watch, robustness, solve};

fn position_play() -> String {
    r#"(table: NineFoot,
        balls: [(name: "cue", position: (-0.6, 0.1)), (name: "1", position: (0.2, 0.25))],
        shot: (ball: "cue", aim_at: "1", speed: 2),
        free: [Stroke(Heading, -25, 5), Stroke(Speed, 0.5, 5), Stroke(Side, -0.3, 0.3), Stroke(Height, -0.35, 0.35)],
        expect: [Potted(ball: "1", pocket: "foot right"), Near(ball: "cue", at: Position(-0.5, -0.3), within: 0.1)])"#
        .to_owned()
}

fn on_threads(threads: usize, text: &str, plan: Plan) -> Result<Found, SearchError> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("threads");
    pool.install(|| solve(&scenario(text), plan, &()))
}

#[test]
fn position_play_is_found_alike_on_any_number_of_threads() {
    let plan = Plan {
        seed: 3,
        shots: 20_000,
    };
    let found = on_threads(1, &position_play(), plan).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(found.miss, 0.0);
    assert!(found.robustness > 0.3, "{}", found.robustness);
    assert!(found.scenario.free.is_empty());
    let outcomes = found.scenario.judge(&played(&found.scenario));
    assert!(outcomes.iter().all(|outcome| outcome.met), "{outcomes:?}");
    let again = on_threads(3, &position_play(), plan).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(
        format!("{:?}", found.scenario),
        format!("{:?}", again.scenario)
    );
    assert_eq!(found.values, again.values);
    // Another seed is another search.
    let other = Plan { seed: 4, ..plan };
    let other = on_threads(2, &position_play(), other).unwrap_or_else(|e| panic!("{e}"));
    assert_ne!(found.values, other.values);
}

#[test]
fn a_layout_is_found_whose_ties_hold() {
    let text = r#"(table: NineFoot,
        balls: [(name: "cue", position: (-0.3, 0)), (name: "1", position: (0.5, -0.1)), (name: "2", position: (0.5, 0.1)),
                (name: "3", position: (0.8, 0))],
        shot: (ball: "cue", speed: 4),
        free: [X("1", 0.2, 1), Around("3", "1", -180, 180), Stroke(Speed, 1, 6)],
        ties: [Touch("1", "2", 90), MirrorX("2", "2b")],
        expect: [Potted(ball: "1"), Stays(ball: "cue")])"#;
    let error = file::parse(text, "t.ron")
        .expect_err("no ball 2b")
        .to_string();
    assert!(error.contains("ties[1]: `2b`"), "{error}");
    let text = text.replace(
        r#"Touch("1", "2", 90), MirrorX("2", "2b")"#,
        r#"MirrorZ("2", "1")"#,
    );
    let plan = Plan {
        seed: 1,
        shots: 15_000,
    };
    let found = on_threads(2, &text, plan).unwrap_or_else(|e| panic!("{e}"));
    let at = |name: &str| {
        let ball = found.scenario.scene.ball_named(name).expect("a ball");
        found.scenario.scene.balls[ball].state.position
    };
    assert_eq!((at("1").x, at("1").z), (at("2").x, -at("2").z));
    let reach = 2.0 * found.scenario.scene.balls[0].ball.radius;
    assert!((at("3").distance(at("1")) - reach).abs() < 1e-12);
    assert!(found.scenario.scene.check().is_ok());
}

#[test]
fn a_player_plays_the_bits_of_the_solver() {
    let scenario = scenario(&position_play());
    let mut player = Player::default();
    for speed in [1.0, 3.0, 1.0] {
        let mut scene = scenario.scene.clone();
        if let Some(planned) = &mut scene.shot {
            planned.shot.speed = speed;
        }
        let truth = masse::physics::exact::solve(&scene, masse::physics::exact::Limits::default());
        let truth = truth.unwrap_or_else(|e| panic!("{e}"));
        let record = player.play(&scene).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(format!("{truth:?}"), format!("{record:?}"));
    }
}

#[test]
fn an_easy_shot_is_more_robust_than_a_hard_one() {
    let shot = |x: f64| {
        let text = format!(
            r#"(table: NineFoot, balls: [(name: "cue", position: (-1, -0.5)), (name: "1", position: ({x}, {}))],
                shot: (ball: "cue", aim_at: "1", speed: 3), expect: [Potted(ball: "1", pocket: "foot right")])"#,
            -0.5 + (x + 1.0) * 1.14 / 2.27
        );
        let scenario = scenario(&text);
        robustness(&mut Player::default(), &scenario.scene, &scenario.expect)
    };
    let (near, far) = (shot(0.95), shot(-0.2));
    assert!(
        near > far + 0.05,
        "near the pocket {near}, far from it {far}"
    );
}

/// Keeps what a search says.
#[derive(Default)]
struct Heard(Mutex<(u64, Vec<f64>)>);

impl Watch for Heard {
    fn played(&self, shots: u64) {
        let mut heard = self.0.lock().expect("not poisoned");
        heard.0 = heard.0.max(shots);
    }

    fn round(&self, best: f64) {
        self.0.lock().expect("not poisoned").1.push(best);
    }
}

#[test]
fn what_cannot_be_searched_is_refused_and_what_is_not_found_is_told() {
    let plan = Plan { seed: 1, shots: 1 };
    let refused = |text: &str| on_threads(1, text, plan).expect_err(text);
    let text = position_play();
    let without = |field: &str| {
        let from = text.find(field).expect("the field");
        let to = from + text[from..].find(']').expect("its end") + 1;
        format!("{}{}", &text[..from], text[to..].trim_start_matches(','))
    };
    assert_eq!(refused(&without("free: [")), SearchError::NothingFree);
    assert_eq!(refused(&without("expect: [")), SearchError::NothingExpected);
    let coursework = text.replace("table: NineFoot", "laws: Coursework, table: NineFoot");
    assert_eq!(refused(&coursework), SearchError::NotExact);
    let overlapping = r#"(table: NineFoot,
        balls: [(name: "cue", position: (-0.6, 0.1)), (name: "1", position: (0.2, 0.25))],
        shot: (ball: "cue", speed: 2), free: [X("1", -0.601, -0.6), Z("1", 0.1, 0.101)], expect: [Potted(ball: "1")])"#;
    assert!(matches!(refused(overlapping), SearchError::NoLayout { .. }));
    // What cannot be met is not found, and the best of it is told.
    let never = text.replace("within: 0.1", "within: 0.1), Stays(ball: \"1\"");
    let heard = Heard::default();
    let found = solve(&scenario(&never), plan, &heard).unwrap_or_else(|e| panic!("{e}"));
    assert!(found.miss > 0.0);
    let (shots, rounds) = heard.0.into_inner().expect("not poisoned");
    assert!(
        shots > 4000 && rounds == [found.miss],
        "{shots} {rounds:?} {}",
        found.miss
    );
}

#[test]
fn ranges_that_make_no_sense_are_refused() {
    for (free, part) in [
        ("Stroke(Heading, 5, -5)", "free[0]: 5 to -5"),
        ("Stroke(Heading, NaN, 5)", "free[0]: NaN to 5"),
        ("Stroke(Elevation, 0, 120)", "free[0]: 0 to 120"),
        (r#"X("7", 0, 1)"#, "free[0]: `7`"),
        (r#"Around("1", "7", 0, 1)"#, "free[0]: `7`"),
        ("Stroke(Colour, 0, 1)", "Colour"),
    ] {
        let text = format!(
            r#"(table: NineFoot, balls: [(name: "cue", position: (-1, 0)), (name: "1", position: (0, 0))],
                shot: (ball: "cue", speed: 1), free: [{free}])"#
        );
        let error = file::parse(&text, "bad.ron").expect_err(free).to_string();
        assert!(error.contains(part), "{free}\n  gives: {error}");
    }
}

#[test]
fn the_command_writes_a_scene_that_runs() {
    let search = command_line::file("solve", "search.ron", &position_play());
    let out = search.with_file_name("found.ron");
    let (search, found) = (search.display().to_string(), out.display().to_string());
    let solved = command_line::masse(&["solve", &search, "--shots", "20000", "--out", &found]);
    let told = command_line::text(&solved.stderr);
    assert_eq!(solved.status.code(), Some(0), "{told}");
    assert!(
        told.contains("heading: ") && told.contains("  met: "),
        "{told}"
    );
    let run = command_line::masse(&["run", &found, "-q"]);
    assert_eq!(run.status.code(), Some(0));
    let refused = command_line::masse(&["solve", "stop-shot"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(command_line::text(&refused.stderr).contains("nothing is free"));
}
