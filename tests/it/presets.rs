//! Presets: the built-in ones play and lie in the measured ranges, files copy and change them, and bad numbers are refused
//! with the source of their range.

use std::path::PathBuf;

use masse::physics::ball::Ball;
use masse::physics::cue::{Cue, Tip};
use masse::physics::exact::{self, Limits};
use masse::physics::laws::ball_ball::{BallBallLaw, Friction};
use masse::physics::laws::motion::{Cloth, MotionLaw};
use masse::physics::scene::{PlannedShot, Rack, Solver};
use masse::physics::table::{Preset as TablePreset, Table};
use masse::scenarios::preset::{self, Preset};
use masse::scenarios::{file, library};

use crate::cli::{err, folder, masse, out, output};
use crate::closeness::assert_close;

fn built_in(name: &str) -> Preset {
    preset::open(name).unwrap_or_else(|error| panic!("{error}"))
}

fn cloth_of(preset: &Preset) -> Cloth {
    match preset.equipment.laws.motion {
        MotionLaw::Coulomb(cloth) => cloth,
        other => panic!("{other:?}"),
    }
}

fn scene(text: &str) -> masse::physics::scene::Scene {
    file::parse(text, "test.ron")
        .unwrap_or_else(|error| panic!("{error}"))
        .scene
}

#[test]
fn every_built_in_preset_plays_a_break() {
    for asset in preset::BUILT_IN {
        let preset = built_in(asset.name);
        assert!(!preset.title.is_empty() && !preset.description.is_empty());
        assert!(preset.files.is_empty());
        assert!(
            library::BUILT_IN
                .iter()
                .all(|scene| scene.name != asset.name)
        );
        let mut scene =
            masse::game::racking::set_up(&preset.equipment, Solver::Exact, Rack::NineBall, 1);
        assert_eq!(scene.check(), Ok(()), "{}", asset.name);
        let shot = masse::physics::cue::Shot {
            speed: 6.0,
            ..Default::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = exact::solve(&scene, Limits::default())
            .unwrap_or_else(|error| panic!("{}: {error}", asset.name));
        assert!(
            record.events.len() > 30,
            "{}: {}",
            asset.name,
            record.events.len()
        );
        assert!(
            record
                .end
                .iter()
                .all(masse::physics::ball::State::is_finite)
        );
    }
}

#[test]
fn every_number_of_a_preset_has_a_source_beside_it() {
    for asset in preset::BUILT_IN.iter().chain(preset::CLOTHS) {
        for line in asset.text.lines() {
            let code = line.split("//").next().unwrap_or_default();
            let is_number = code
                .split_once(':')
                .is_some_and(|(_, value)| value.trim().starts_with(|c: char| c.is_ascii_digit()));
            if is_number {
                assert!(line.contains("//"), "{}: no source: {line}", asset.name);
            }
        }
    }
}

#[test]
fn the_numbers_are_those_of_the_papers() {
    // Rolling and sliding deceleration of Mathavan 2009, his balls and impacts of 2014.
    let snooker = built_in("snooker");
    let cloth = cloth_of(&snooker);
    let deceleration = cloth.rolling * cloth.gravity;
    assert!(
        (0.124..=0.126).contains(&deceleration),
        "{deceleration} m/s²"
    );
    let sliding = cloth.sliding * cloth.gravity;
    assert!((1.75..=2.40).contains(&sliding), "{sliding} m/s²");
    assert_eq!(snooker.equipment.laws.ball_ball.restitution(1.0), 0.89);
    assert_eq!(snooker.equipment.laws.cushion.restitution(1.0), 0.98);
    assert_eq!(snooker.equipment.balls.object.mass, 0.1406);
    assert_eq!(snooker.equipment.table, TablePreset::Snooker.table());
    // Heated carom: the deceleration of the tracked shots.
    let carom = cloth_of(&built_in("heated_carom"));
    let deceleration = carom.rolling * carom.gravity;
    assert!(
        (0.0418..=0.0480).contains(&deceleration),
        "{deceleration} m/s²"
    );
    // Pool: every number within the ranges of Alciatore, and Marlow's friction.
    let pool = built_in("pool");
    let cloth = cloth_of(&pool);
    assert!((0.15..=0.4).contains(&cloth.sliding) && (0.005..=0.015).contains(&cloth.rolling));
    assert!((5.0..=15.0).contains(&cloth.spin_deceleration));
    assert!((0.6..=0.9).contains(&pool.equipment.laws.cushion.restitution(1.0)));
    let BallBallLaw::Frictional(balls) = pool.equipment.laws.ball_ball else {
        panic!("{:?}", pool.equipment.laws.ball_ball);
    };
    assert!((0.92..=0.98).contains(&balls.restitution));
    assert_eq!(balls.friction, Friction::MARLOW);
    assert_eq!(pool.equipment.balls.cue, Ball::POOL);
    assert_eq!(pool.equipment.cue, Cue::default());
    // A bar box has a heavier cue ball of the same size, and is slower.
    let bar = built_in("bar_box");
    let more = (bar.equipment.balls.cue.mass - Ball::POOL.mass) / 0.028_35;
    assert!((0.5..=1.0).contains(&more), "{more} oz");
    assert_eq!(bar.equipment.balls.cue.radius, Ball::POOL.radius);
    assert_eq!(bar.equipment.balls.object, Ball::POOL);
    assert!(cloth_of(&bar).rolling > cloth.rolling);
    // Cloths from fast to slow.
    let rolling: Vec<f64> = preset::CLOTHS
        .iter()
        .map(|cloth| preset::cloth(cloth.name).expect("built in").rolling)
        .collect();
    assert_eq!(rolling, [0.005, 0.01, 0.015]);
}

/// Width between the walls of a throat at the hole, m: twice the distance of the nearest facing from the axis of the pocket.
fn throat(table: &Table, pocket: usize, along: glam::DVec2) -> f64 {
    let pocket = &table.pockets[pocket];
    let at = pocket.center - pocket.radius * along;
    2.0 * table
        .cushions
        .iter()
        .map(|cushion| cushion.nearest(at).0)
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn a_snooker_table_has_round_jaws_and_takes_a_ball() {
    let table = TablePreset::Snooker.table();
    assert_eq!((table.length, table.width), (3.569, 1.778));
    assert_close("nose", table.nose_height, 1.4 * 0.02625, 1e-15, "m");
    let corner = table
        .pockets
        .iter()
        .position(|p| p.name == "foot right")
        .expect("a corner");
    let side = table
        .pockets
        .iter()
        .position(|p| p.name == "side right")
        .expect("a side");
    let diagonal = glam::DVec2::splat(std::f64::consts::FRAC_1_SQRT_2);
    assert_close("corner", throat(&table, corner, diagonal), 0.083, 2e-3, "m");
    let width = throat(&table, side, glam::DVec2::Y);
    assert!((0.087..0.105).contains(&width), "side {width} m");
    let text = |from: (f64, f64), heading: f64| {
        format!(
            "(preset: \"snooker\", balls: [(name: \"cue\", position: ({}, {}))], \
             shot: (ball: \"cue\", heading_deg: {heading}, speed: 1.5))",
            from.0, from.1
        )
    };
    // Straight into a corner and a middle pocket it falls, along the cushion past the middle pocket it does not.
    let falls = |text: &str| {
        let record = exact::solve(&scene(text), Limits::default()).expect("solvable");
        record.end[0].motion == masse::physics::ball::Motion::Pocketed
    };
    assert!(falls(&text((1.2845, 0.389), -45.0)));
    assert!(falls(&text((0.0, 0.3), -90.0)));
    assert!(!falls(&text((0.5, 0.8), 180.0)));
}

#[test]
fn a_scene_names_a_preset_and_changes_single_fields() {
    let plain = scene("(preset: \"snooker\", balls: [(name: \"cue\", position: (0, 0))])");
    let snooker = built_in("snooker").equipment;
    assert_eq!(
        (&plain.table, &plain.laws, &plain.cue),
        (&snooker.table, &snooker.laws, &snooker.cue)
    );
    assert_eq!(plain.balls[0].ball, snooker.balls.cue);
    let changed = scene(
        "(preset: \"snooker\", table: NineFoot, cloth: \"fast\", laws: Custom(cushion: Mirror(restitution: 0.7)),
          cue: (tip: Phenolic), cue_ball: (mass: 0.15), set: {\"laws.ball_ball.friction\": 0.07, \"laws.motion.gravity\": 9.8},
          balls: [(name: \"cue\", position: (0, 0)), (name: \"red\", position: (0.3, 0))])",
    );
    assert_eq!(changed.table, TablePreset::NineFoot.table());
    let MotionLaw::Coulomb(cloth) = changed.laws.motion else {
        panic!("{:?}", changed.laws.motion);
    };
    assert_eq!(
        (cloth.rolling, cloth.sliding, cloth.gravity),
        (0.005, 0.15, 9.8)
    );
    let BallBallLaw::Frictional(balls) = changed.laws.ball_ball else {
        panic!("{:?}", changed.laws.ball_ball);
    };
    assert_eq!(
        (balls.restitution, balls.friction),
        (0.89, Friction::Constant(0.07))
    );
    assert_eq!(changed.laws.cushion.restitution(1.0), 0.7);
    assert_eq!(changed.cue, snooker.cue.with_tip(Tip::Phenolic));
    assert_eq!(changed.balls[0].ball.mass, 0.15);
    assert_eq!(changed.balls[1].ball, snooker.balls.object);
    // By a maker's measures, the same table as by its name.
    let measured = scene(
        "(table: Pocketed(length: 2.54, width: 1.27, nose_height: 0.03629025, cushion_depth: 0.0508,
            corner: (width: 0.1159, cut_angle_deg: 142, jaw_radius: 0.012, hole_radius: 0.062, shelf: 0.0413),
            side: (width: 0.1286, cut_angle_deg: 104, jaw_radius: 0.008, hole_radius: 0.0645, shelf: 0.0048)),
          balls: [(name: \"cue\", position: (0, 0))])",
    );
    assert_eq!(measured.table, TablePreset::NineFoot.table());
}

/// An empty folder with these files.
fn files(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = folder(name);
    for (name, text) in files {
        std::fs::write(folder.join(name), text).expect("a file");
    }
    folder
}

#[test]
fn a_copied_preset_is_found_beside_its_scene_and_builds_on_others() {
    let folder = files(
        "presets",
        &[
            (
                "mine.ron",
                "(title: \"Mine\", base: \"house.ron\", cloth: \"felt.ron\")",
            ),
            (
                "house.ron",
                "(base: \"pool\", set: {\"laws.cushion.restitution\": 0.7})",
            ),
            (
                "felt.ron",
                "(sliding: 0.3, rolling: 0.012, spin_deceleration: 9)",
            ),
            ("scene.ron", "(preset: \"mine.ron\", rack: NineBall())"),
            ("circle.ron", "(base: \"circle.ron\")"),
        ],
    );
    let read = file::read(&folder.join("scene.ron")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(read.scene.laws.cushion.restitution(1.0), 0.7);
    let mine = folder.join("mine.ron");
    assert_eq!(read.preset.as_deref(), mine.to_str());
    let preset = preset::read(&mine).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(preset.title, "Mine");
    assert_eq!(cloth_of(&preset).sliding, 0.3);
    let names: Vec<_> = preset
        .files
        .iter()
        .filter_map(|file| file.file_name())
        .collect();
    assert_eq!(names, ["mine.ron", "house.ron", "felt.ron"]);
    let error = preset::read(&folder.join("circle.ron"))
        .expect_err("a circle")
        .to_string();
    assert!(
        error.contains("circle.ron") && error.contains("made from itself"),
        "{error}"
    );
}

#[test]
fn a_preset_is_written_out_with_its_sources_and_reads_back_the_same() {
    let folder = folder("written-presets");
    for asset in preset::BUILT_IN {
        let path = folder.join(format!("{}.ron", asset.name));
        let written = output(masse().arg("write").arg(asset.name).arg(&path));
        assert_eq!(written.status.code(), Some(0), "{}", err(&written));
        let copy = preset::read(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(copy.equipment, built_in(asset.name).equipment);
        assert!(std::fs::read_to_string(&path).expect("text").contains("//"));
    }
}

#[test]
fn what_is_wrong_with_a_preset_is_named_with_range_and_source() {
    let cases: &[(&str, &[&str])] = &[
        ("(tabel: NineFoot)", &["bad.ron:1:", "tabel", "table", "cue_ball"]),
        ("(base: \"snoker\")", &["preset", "`snoker`", "pool", "bar_box", "snooker", "heated_carom"]),
        ("(cloth: \"felt\")", &["cloth", "`felt`", "fast", "medium", "slow"]),
        ("(laws: Custom(cushion: Han2006()))", &["Han2006", "Han2005", "Mirror", "Stronge2018"]),
        (
            "(laws: Custom(ball_ball: Frictional(friction: Constant(3))))",
            &["laws.ball_ball.friction: 3", "between 0 and 2", "Alciatore"],
        ),
        (
            "(set: {\"laws.cushion.restitution\": 1.2})",
            &["laws.cushion.restitution: 1.2", "between 0 and 1", "Mathavan 2010"],
        ),
        ("(set: {\"laws.cushion.bounce\": 0.2})", &["`laws.cushion.bounce`", "restitution", "friction"]),
        ("(set: {\"laws.cushion\": 0.2})", &["`laws.cushion`", "restitution"]),
        ("(set: {\"lows.cushion\": 0.2})", &["`lows.cushion`", "laws", "cue_ball"]),
        ("(set: {\"cue.mass\": NaN})", &["cue.mass: NaN"]),
        ("(ball: (mass: 0))", &["ball.mass: 0", "WPA"]),
        ("(cue_ball: (radius: -1))", &["cue_ball.radius: -1", "WPA"]),
        ("(cue: (tip: Phenolic, tip_restitution: 0.9))", &["cue.tip_restitution: 0.9", "phenolic", "0.81 to 0.87", "Alciatore"]),
        ("(cue: (tip: Chalk))", &["Chalk", "Leather", "Phenolic"]),
        ("(cue: (tip_friction: 0.6, miscue_offset: 0.5))", &["`miscue_offset`", "`tip_friction`"]),
        ("(cue: (tip_restitution: 1.5))", &["cue.tip_restitution: 1.5", "leather measures"]),
        (
            "(table: Pocketed(length: 2.54, width: 1.27, nose_height: 0.036, cushion_depth: 0.05,
               corner: (width: 0.1159, cut_angle_deg: 60, jaw_radius: 0.012, hole_radius: 0.062, shelf: 0.0413),
               side: (width: 0.1286, cut_angle_deg: 104, jaw_radius: 0.008, hole_radius: 0.0645, shelf: 0.0048)))",
            &["table.corner.cut_angle_deg", "60", "WPA"],
        ),
        (
            "(table: Pocketed(length: 0.6, width: 0.3, nose_height: 0.036, cushion_depth: 0.05,
               corner: (width: 0.2, cut_angle_deg: 142, jaw_radius: 0.012, hole_radius: 0.062, shelf: 0.0413),
               side: (width: 0.2, cut_angle_deg: 104, jaw_radius: 0.008, hole_radius: 0.0645, shelf: 0.0048)))",
            &["table.nose", "left between two pockets"],
        ),
    ];
    for (text, parts) in cases {
        let error = preset::parse(text, "bad.ron").expect_err(text).to_string();
        assert!(error.starts_with("bad.ron"), "{text}\n  gives: {error}");
        for part in *parts {
            assert!(
                error.contains(part),
                "{text}\n  gives: {error}\n  which lacks: {part}"
            );
        }
    }
    let missing = preset::open("nowhere/preset.ron")
        .expect_err("no file")
        .to_string();
    assert!(missing.contains("nowhere/preset.ron"), "{missing}");
}

#[test]
fn the_command_line_equips_a_scene_and_warns_of_the_cue() {
    let run = |arguments: &[&str]| output(masse().arg("run").args(arguments));
    let other = run(&["throw", "--preset", "heated_carom", "--time-limit", "0.1"]);
    // It is played, and cut off before the hit of which the scene expects something.
    assert_eq!(other.status.code(), Some(1), "{}", err(&other));
    let unknown = run(&["throw", "--preset", "billard"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(err(&unknown).contains("heated_carom"), "{}", err(&unknown));
    let folder = files(
        "cue-note",
        &[(
            "low.ron",
            "(preset: \"pool\", balls: [(name: \"cue\", position: (0, 0)), (name: \"1\", position: (-0.06, 0)),
               (name: \"2\", position: (0.5, 0))], shot: (ball: \"cue\", speed: 1))",
        )],
    );
    let low = run(&[folder.join("low.ron").to_str().expect("a path")]);
    assert_eq!(low.status.code(), Some(0));
    assert!(
        err(&low).contains("the cue would pass through ball `1`"),
        "{}",
        err(&low)
    );
}

#[test]
fn list_names_one_thing_a_line() {
    let listed = output(masse().arg("list"));
    assert_eq!(listed.status.code(), Some(0));
    let text = out(&listed);
    assert!(text.lines().count() >= 15, "{text}");
    let mut kinds = Vec::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let name = words.next().expect("a name");
        let kind = words.next().expect("what it is");
        match kind {
            // That each of them can be played is held elsewhere.
            "scene" => assert!(
                masse::scenarios::library::all().any(|scene| scene.name == name),
                "{line}"
            ),
            "preset" => assert!(masse::scenarios::preset::open(name).is_ok(), "{line}"),
            "cloth" => assert!(masse::scenarios::preset::cloth(name).is_ok(), "{line}"),
            _ => panic!("{line}"),
        }
        assert!(words.next().is_some(), "no title: {line}");
        kinds.push(kind);
    }
    kinds.dedup();
    assert_eq!(kinds, ["scene", "preset", "cloth"]);
}
