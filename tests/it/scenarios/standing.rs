//! Where expectations stand while a shot is played: nothing that is said to be settled changes afterwards.

use masse::physics::exact::{self, Limits};
use masse::physics::record::Record;
use masse::scenarios::expect::{Outcome, Phrase, Standing, score, standings};
use masse::scenarios::library;

use super::{played, scenario};

/// The record as it was after so many seconds.
fn until(whole: &Record, time: f64) -> Record {
    let mut record = Record {
        events: whole.events.clone(),
        paths: whole.paths.clone(),
        end: (0..whole.paths.len())
            .map(|ball| whole.state_at(ball, time))
            .collect(),
        end_time: time,
        reason: None,
    };
    record.events.retain(|event| event.time <= time);
    for path in &mut record.paths {
        path.retain(|piece| piece.time <= time);
    }
    record
}

#[test]
fn what_is_settled_stays_so_in_every_shot_of_the_library() {
    let (mut open, mut early) = (0, 0);
    for built_in in library::BUILT_IN {
        let scenario = built_in.scenario().expect("it is good");
        let Ok(whole) = exact::solve(&scenario.scene, Limits::default()) else {
            continue;
        };
        let at = |record: &Record, over| {
            let marks = standings(&scenario.scene, record, &scenario.expect, over);
            marks
                .into_iter()
                .map(|(_, standing)| standing)
                .collect::<Vec<_>>()
        };
        let last = at(&whole, true);
        assert!(!last.contains(&Standing::Open), "{}", built_in.name);
        for part in 1..12 {
            let time = whole.end_time * f64::from(part) / 12.0;
            for (i, standing) in at(&until(&whole, time), false).into_iter().enumerate() {
                if standing == Standing::Open {
                    open += 1;
                } else {
                    early += 1;
                    let told = format!("{} at {time} s: {}", built_in.name, scenario.expect[i]);
                    assert_eq!(standing, last[i], "{told}");
                }
            }
        }
    }
    assert!(open > 100 && early > 100, "{open} open, {early} settled");
}

const SHOT: &str = "(title: \"t\", table: NineFoot, balls: [(name: \"cue\", position: (-0.6, 0)), \
                    (name: \"1\", position: (0.3, 0.02))], shot: (ball: \"cue\", heading_deg: 0, speed: 2), expect: [";

#[test]
fn misses_are_settled_as_soon_as_nothing_can_mend_them() {
    let scenario = scenario(&format!(
        "{SHOT}Never(Hit(\"cue\", \"1\")), Order([Hit(\"cue\", \"1\"), Rail(\"1\")]), Potted(ball: \"1\"), \
         Count(of: Hit(\"cue\", \"1\"), most: 0), Speed(ball: \"1\", most: 0.01, when: After(\"cue\", \"1\"))])"
    ));
    let whole = played(&scenario);
    let hit = whole
        .events
        .iter()
        .find(|event| event.second.is_some())
        .expect("they meet")
        .time;
    let at = |time: f64| {
        let marks = standings(
            &scenario.scene,
            &until(&whole, time),
            &scenario.expect,
            false,
        );
        marks
            .into_iter()
            .map(|(_, standing)| standing)
            .collect::<Vec<_>>()
    };
    assert_eq!(at(0.5 * hit), [Standing::Open; 5]);
    let (open, missed) = (Standing::Open, Standing::Missed);
    assert_eq!(at(hit + 1e-6), [missed, open, open, missed, missed]);
}

fn phrase() -> Phrase {
    Phrase {
        key: "seen-so",
        english: "so it was",
        values: Vec::new(),
    }
}

fn outcome(miss: f64) -> Outcome {
    Outcome {
        met: miss == 0.0,
        miss,
        found: None,
        unit: "",
        wanted: phrase(),
        seen: phrase(),
    }
}

#[test]
fn the_score_is_full_only_if_all_is_met_and_falls_with_the_miss() {
    assert_eq!(score(&[outcome(0.0), outcome(0.0)]), 100);
    assert_eq!(score(&[outcome(0.0), outcome(1e-9)]), 99);
    assert_eq!(score(&[outcome(0.25)]), 50);
    let scores: Vec<u32> = [0.01, 0.1, 0.5, 2.0, 1e9]
        .map(|miss| score(&[outcome(miss)]))
        .into();
    assert!(scores.is_sorted_by(|a, b| a > b), "{scores:?}");
}
