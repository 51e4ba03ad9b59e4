//! What all games share: the lag, spotting, areas, pointing, practice.

use glam::DVec2;
use masse::game::rules::call::{nearest_ball, nearest_pocket};
use masse::game::rules::lag::{BadLag, lag, lag_winner};
use masse::game::rules::spot::{APART, Spotter, Touching};
use masse::game::rules::{Area, Call, EightBall, FreePractice, Game, GameState, TableChange};
use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::{PlannedShot, Scene};
use masse::physics::table::Preset;

use super::story::{Story, lay, place, start};

/// A lag of one ball from behind the head string.
fn lagged(z: f64, heading: f64, speed: f64) -> Result<f64, BadLag> {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let ball = scene.place("cue", Ball::POOL, scene.table.head_spot().x - 0.1, z);
    let shot = Shot {
        heading,
        speed,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball, shot });
    let record = solve(&scene, Limits::default()).expect("the lag is played");
    lag(&scene, &record, ball)
}

#[test]
fn a_lag_goes_to_the_foot_cushion_once_and_comes_back() {
    let good = lagged(0.3, 0.0, 2.2).expect("a good lag");
    let better = lagged(0.3, 0.0, 2.25).expect("a good lag");
    assert!(good > 0.0 && better > 0.0 && good < 2.5, "{good} {better}");
    let nearer = usize::from(better < good);
    assert_eq!(lag_winner([Ok(good), Ok(better)]), Some(nearer));
    assert_eq!(lagged(0.3, 0.0, 0.6), Err(BadLag::FootCushion { times: 0 }));
    let hard = lagged(0.3, 0.0, 9.0);
    assert!(
        matches!(hard, Err(BadLag::FootCushion { times }) if times > 1),
        "{hard:?}"
    );
    assert_eq!(lagged(0.3, 0.12, 2.2), Err(BadLag::CrossedLongLine));
    assert_eq!(lagged(0.3, -0.35, 2.2), Err(BadLag::SideCushion));
    assert_eq!(lag_winner([Ok(1.0), Err(BadLag::Gone)]), Some(0));
    assert_eq!(lag_winner([Err(BadLag::Gone), Ok(2.0)]), Some(1));
    assert_eq!(
        lag_winner([Err(BadLag::Gone), Err(BadLag::SideCushion)]),
        None
    );
    assert_eq!(lag_winner([Ok(1.0), Ok(1.0)]), None);
}

#[test]
fn a_lag_that_falls_or_rests_in_a_corner_is_bad() {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let ball = scene.place("cue", Ball::POOL, -0.8, 0.3);
    let (foot, head) = (
        (0..scene.table.cushions.len()).find(|&cushion| {
            let (least, most) = scene.table.cushions[cushion].bounds();
            least.x == most.x && least.x > 1.0
        }),
        scene.table.pockets[1].center,
    );
    let once = Story::of(&scene).cushion("cue", foot.expect("a foot cushion"));
    assert!(lag(&scene, once.record(), ball).is_ok());
    let once = Story::of(&scene).cushion("cue", foot.expect("a foot cushion"));
    assert_eq!(
        lag(&scene, once.pot("cue", 1).record(), ball),
        Err(BadLag::Gone)
    );
    let once = Story::of(&scene).cushion("cue", foot.expect("a foot cushion"));
    let shelf = head + DVec2::new(0.055, -0.055);
    assert_eq!(
        lag(&scene, once.go("cue", shelf.x, shelf.y).record(), ball),
        Err(BadLag::PastNose)
    );
}

fn pool(balls: &[(&str, f64, f64)]) -> Scene {
    let (_, mut scene) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
    lay(&mut scene, balls);
    scene
}

fn spotted(scene: &Scene, name: &str) -> DVec2 {
    let mut spotter = Spotter::new(scene.clone());
    let ball = scene.ball_named(name).expect("the ball");
    assert!(spotter.on_long_line(ball, scene.table.foot_spot(), Touching::Object));
    let after = spotter.into_scene();
    after.check().expect("no balls overlap");
    place(&after, name)
}

#[test]
fn a_ball_is_spotted_on_the_foot_spot_or_behind_it_against_what_is_there() {
    let foot = Preset::NineFoot.table().foot_spot();
    let diameter = 2.0 * Ball::POOL.radius;
    assert_eq!(spotted(&pool(&[("cue", 0.0, 0.0)]), "8"), foot);
    // Against an object ball, touching it.
    let here = spotted(&pool(&[("cue", 0.0, 0.0), ("1", foot.x, 0.0)]), "8");
    assert!((here.x - foot.x - diameter).abs() < 1e-12 && here.y == 0.0);
    // Aside of the line the ball still bars; the spotted one touches it.
    let here = spotted(&pool(&[("cue", 0.0, 0.0), ("1", foot.x + 0.01, 0.02)]), "8");
    assert!((here.distance(DVec2::new(foot.x + 0.01, 0.02)) - diameter).abs() < 1e-12);
    assert!(here.x > foot.x);
    // Not against the cue ball.
    let here = spotted(&pool(&[("cue", foot.x, 0.0), ("1", -0.5, 0.0)]), "8");
    assert!((here.x - foot.x - diameter - APART).abs() < 1e-12);
}

#[test]
fn with_no_room_towards_the_foot_a_ball_is_spotted_towards_the_head() {
    let foot = Preset::NineFoot.table().foot_spot();
    let diameter = 2.0 * Ball::POOL.radius;
    let names: Vec<String> = (1..=15)
        .filter(|number| *number != 8)
        .map(|number| number.to_string())
        .collect();
    let mut balls = vec![("cue", -0.5, 0.3)];
    let end = 1.27 - Ball::POOL.radius;
    for (step, name) in (0..).zip(&names) {
        let x = foot.x + f64::from(step) * (diameter + 1e-3);
        if x <= end {
            balls.push((name, x, 0.0));
        }
    }
    assert!(balls.len() > 10, "the line is full");
    let here = spotted(&pool(&balls), "8");
    assert!((here.x - foot.x + diameter).abs() < 1e-12, "{here}");
}

#[test]
fn a_cue_ball_in_hand_is_put_down_where_the_area_allows_and_nothing_lies() {
    let scene = pool(&[("cue", 0.5, 0.0), ("1", -0.635, 0.0), ("2", -0.8, 0.3)]);
    let area = Area::behind_head_string(&scene.table);
    for wish in [
        DVec2::new(-0.635, 0.0),
        DVec2::new(0.9, 0.4),
        DVec2::new(-9.0, 9.0),
        DVec2::new(-0.8, 0.31),
    ] {
        let spot = area.place(&scene, 0, wish).expect("there is room");
        assert!(area.is_legal(&scene, 0, spot), "{wish} {spot}");
    }
    assert!(
        !area.is_legal(&scene, 0, DVec2::new(-0.8, 0.31)),
        "on a ball"
    );
    assert!(!area.is_legal(&scene, 0, DVec2::new(-0.5, 0.31)), "outside");
    assert!(!area.allows(DVec2::new(f64::NAN, 0.0)));
}

#[test]
fn pointing_finds_the_pocket_and_the_ball_meant() {
    let scene = pool(&[("cue", 0.0, 0.0), ("1", 0.5, 0.0), ("2", 0.5, 0.3)]);
    for (index, pocket) in scene.table.pockets.iter().enumerate() {
        let towards_middle = pocket.center * 0.9;
        assert_eq!(nearest_pocket(&scene.table, towards_middle), Some(index));
    }
    assert_eq!(nearest_pocket(&Preset::Carom.table(), DVec2::ZERO), None);
    let ball = |name: &str| scene.ball_named(name).expect("the ball");
    let among = [ball("1"), ball("2"), ball("8")];
    let near = |x: f64, z: f64| nearest_ball(&scene, &among, DVec2::new(x, z), 0.05);
    assert_eq!(near(0.51, 0.05), Some(ball("1")));
    assert_eq!(near(0.51, 0.2501), Some(ball("2")));
    assert_eq!(near(0.0, 0.0), None, "the cue ball is not among them");
}

#[test]
fn practice_counts_what_falls_and_forbids_nothing() {
    let (mut state, mut scene) = one_player(Game::FreePractice(FreePractice::default()));
    let (verdict, table) = Story::of(&scene)
        .meet("cue", "8")
        .pot("8", 5)
        .pot("cue", 0)
        .play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.fouls.as_slice(), verdict.points.as_slice()),
        ([].as_slice(), [1].as_slice())
    );
    assert_eq!(
        verdict.next.standing.in_hand,
        Some(Area::anywhere(&scene.table))
    );
    assert!(table.balls[0].state.motion.in_play());
    (state, scene) = (verdict.next, table);
    let mut story = Story::of(&scene);
    for number in (1..=15).filter(|number| *number != 8) {
        story = story.pot(&number.to_string(), 3);
    }
    let (verdict, table) = story.play(&state, &Call::Nothing);
    assert_eq!(
        (verdict.points, verdict.table),
        (vec![14], TableChange::Rerack)
    );
    assert!(table.balls.iter().all(|ball| ball.state.motion.in_play()));
    assert_eq!(verdict.next.standing.over, None);
}

fn one_player(game: Game) -> (GameState, Scene) {
    let like = Scene::new(Preset::NineFoot.table(), Laws::default());
    GameState::start(game, 1, 0, &like, 1)
}

#[test]
fn every_game_is_listed_with_a_dated_code_and_starts_playable() {
    let mut names = Vec::new();
    for game in Game::all() {
        let code = game.rules().code();
        assert_eq!(Game::named(code.name), Some(game.clone()));
        assert!(
            code.edition.chars().any(|letter| letter.is_ascii_digit()) || code.name == "practice",
            "{}",
            code.edition
        );
        let table = if game.rules().has_pockets() {
            Preset::NineFoot
        } else {
            Preset::Carom
        };
        let like = Scene::new(table.table(), Laws::default());
        let players = *game.rules().players().start();
        let (state, scene) = GameState::start(game.clone(), players, 0, &like, 1);
        scene.check().expect("no balls overlap");
        let on = state.targets(&scene);
        assert!(
            !on.first.is_empty() && on.choices.is_empty(),
            "{}",
            code.name
        );
        assert!(
            on.in_hand
                .is_none_or(|area| area.is_legal(&scene, on.cue, place(&scene, "cue")))
        );
        for setting in game.rules().settings() {
            assert!(!setting.meaning.is_empty() && !setting.value.is_empty());
        }
        names.push(code.name);
    }
    let wanted = [
        "8-ball",
        "9-ball",
        "10-ball",
        "14.1",
        "snooker",
        "three-cushion",
        "practice",
    ];
    assert_eq!(names, wanted);
}

#[test]
fn every_rack_can_be_named_in_a_scene_file() {
    use masse::physics::scene::Rack;
    for rack in Rack::ALL {
        let table = match rack {
            Rack::Snooker => "Snooker",
            Rack::ThreeCushion => "Carom",
            _ => "NineFoot",
        };
        let text = format!("(title: \"A rack\", table: {table}, rack: {rack:?}(seed: 3))");
        let scene = masse::scenarios::file::parse(&text, "rack.ron")
            .expect("a scene")
            .scene;
        let mut placed = Scene::new(scene.table.clone(), Laws::default());
        rack.place(&mut placed, Ball::POOL, 0.0, 3);
        let names = |scene: &Scene| -> Vec<String> {
            scene.balls.iter().map(|ball| ball.name.clone()).collect()
        };
        assert_eq!(names(&scene), names(&placed));
    }
}
