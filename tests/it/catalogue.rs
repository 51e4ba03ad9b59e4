//! The catalogue of the laws: paper, formula, numbers and errors of each.

use std::collections::BTreeSet;

use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::BallBallLaw;
use masse::physics::laws::cushion::CushionLaw;
use masse::physics::laws::motion::MotionLaw;
use masse::physics::laws::pocket::PocketLaw;
use masse::physics::laws::slate::SlateLaw;
use masse::report::catalogue::{self, Entry};
use masse::report::judge::Judgement;
use masse::scenarios::library;
use masse::scenarios::sweep::Axis;

use crate::cli::{err, masse, out, output};
use crate::judge::judged;

#[test]
fn every_registered_law_is_there_with_a_source_of_its_own() {
    let all = catalogue::all();
    let registered = MotionLaw::all().len()
        + BallBallLaw::all().len()
        + CushionLaw::all().len()
        + SlateLaw::all().len()
        + PocketLaw::all().len();
    // And the stroke, and impacts at one moment.
    assert_eq!(all.len(), registered + 2);
    let formulas: BTreeSet<_> = all.iter().map(|law| law.source.formula).collect();
    assert_eq!(formulas.len(), all.len(), "two laws have one formula");
    for law in &all {
        for text in [law.source.paper, law.source.formula, law.source.leaves_out] {
            assert!(text.len() > 4, "{}: {text:?}", law.name);
        }
    }
}

/// The judges as the catalogue counts them: no row of the exact judges belongs to nobody.
#[test]
fn every_exact_judge_is_about_a_law() {
    let judgement = judged();
    let all = catalogue::all();
    let about = |law: &Entry, judgement: &Judgement| law.verdict(judgement);
    let lost: Vec<_> = judgement
        .exact
        .iter()
        .filter(|row| !all.iter().any(|law| law.is_judged_by(row)))
        .map(|row| format!("{}: {}", row.law, row.name))
        .collect();
    assert!(
        lost.iter().all(|row| row.starts_with("exact solver")),
        "{lost:#?}"
    );
    for law in &all {
        let verdict = about(law, judgement);
        let name = (law.class, law.name.as_str());
        assert_eq!(
            verdict.closed_forms.pass, verdict.closed_forms.of,
            "{name:?}"
        );
        assert_eq!(verdict.printed.pass, verdict.printed.of, "{name:?}");
        let error = verdict.largest_error.unwrap_or(0.0);
        assert!(error < 1e-9, "{name:?}: {error}");
        // What is met and missed by laws of balls and cushions, and by nobody else's.
        let judged = verdict.closed_forms.of + verdict.printed.of;
        let unjudged = [
            ("motion", "Frictionless"),
            ("motion", "Inclined"),
            ("motion", "Coursework"),
            ("pocket", "Rim"),
        ];
        assert_eq!(judged == 0, unjudged.contains(&name), "{name:?}");
    }
}

/// The path of a number is one that a sweep takes, and its default is what the scene has.
#[test]
fn the_numbers_of_the_default_laws_can_be_swept() {
    let scene = library::open("stun-shot").expect("a scene").scene;
    let Laws {
        motion,
        ball_ball,
        cushion,
        slate,
        pocket,
    } = scene.laws;
    let texts = [
        format!("{motion:?}"),
        format!("{ball_ball:?}"),
        format!("{cushion:?}"),
        format!("{slate:?}"),
        format!("{pocket:?}"),
        "strike".to_owned(),
    ];
    let mut tried = 0;
    for law in catalogue::all() {
        if !texts.iter().any(|text| text.starts_with(&law.name)) || law.class == "simultaneous" {
            continue;
        }
        for number in &law.numbers {
            let axis = Axis::parse(&format!("{}={}", number.path, number.default), &scene);
            assert!(
                axis.is_ok(),
                "{}: {}",
                law.name,
                axis.expect_err("an error")
            );
            assert!(number.least <= number.default && number.default <= number.most);
            tried += 1;
        }
    }
    assert!(tried > 15, "{tried} numbers");
}

#[test]
fn the_command_tells_all_laws_or_one() {
    let all = output(masse().arg("laws"));
    assert_eq!(all.status.code(), Some(0), "{}", err(&all));
    assert_eq!(out(&all), catalogue::table(judged()));
    for law in catalogue::all() {
        assert!(out(&all).contains(law.source.paper), "{}", law.name);
        let sheet = catalogue::sheet(&law, judged());
        for part in [law.source.formula, law.source.leaves_out] {
            assert!(sheet.contains(part), "{sheet}");
        }
        assert!(
            law.numbers
                .iter()
                .all(|number| sheet.contains(&number.path))
        );
        if law.name == "Mathavan2010" {
            let told = ["J14", "E3"].iter().all(|row| sheet.contains(row));
            assert!(told && !sheet.contains("COURSEWORK"), "{sheet}");
        }
    }
    let json = output(masse().args(["laws", "Frictionless", "--json"]));
    let told: serde_json::Value = serde_json::from_str(&out(&json)).expect("JSON");
    let classes: Vec<_> = told
        .as_array()
        .expect("a list")
        .iter()
        .map(|law| law["law"]["class"].as_str().unwrap_or_default().to_owned())
        .collect();
    assert_eq!(classes, ["motion", "ball_ball"]);
    let unknown = output(masse().args(["laws", "Newton"]));
    assert_eq!(unknown.status.code(), Some(2));
    assert!(err(&unknown).contains("Stronge2018"), "{}", err(&unknown));
}
