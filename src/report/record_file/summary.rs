//! The end of a run, for programs and for people.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::Serialize;

use crate::physics::ball::State;
use crate::physics::record::{EndReason, EventKind, Record};
use crate::physics::scene::{Scene, Solver};
use crate::report::record_file::lines::{kind, name, pocket_name};

/// What a run came to. The time it took is not in it, so that the same scene gives the same text.
#[derive(Serialize)]
pub struct Summary<'a> {
    scene: &'a str,
    title: &'a str,
    solver: &'a Solver,
    /// Why the run ended.
    reason: Option<EndReason>,
    /// When it ended, s.
    time: f64,
    /// Number of events of each kind.
    events: BTreeMap<&'static str, usize>,
    potted: Vec<Potted<'a>>,
    end: Vec<End<'a>>,
}

#[derive(Serialize)]
struct Potted<'a> {
    ball: &'a str,
    pocket: &'a str,
    time: f64,
}

#[derive(Serialize)]
struct End<'a> {
    ball: &'a str,
    #[serde(flatten)]
    state: &'a State,
}

/// Most balls whose last places are told to a person.
const MOST_PLACES: usize = 16;

impl<'a> Summary<'a> {
    /// What this run of a scene came to; the scene has a name and a title.
    #[must_use]
    pub fn of(scene_name: &'a str, title: &'a str, scene: &'a Scene, record: &'a Record) -> Self {
        let mut events = BTreeMap::new();
        for event in &record.events {
            *events.entry(kind(&event.kind)).or_insert(0) += 1;
        }
        let potted = record.events.iter().filter_map(|event| match event.kind {
            EventKind::Pocketed { pocket } => Some(Potted {
                ball: name(scene, event.first.ball),
                pocket: pocket_name(scene, pocket),
                time: event.time,
            }),
            _ => None,
        });
        Self {
            scene: scene_name,
            title,
            solver: &scene.solver,
            reason: record.reason,
            time: record.end_time,
            events,
            potted: potted.collect(),
            end: record
                .end
                .iter()
                .enumerate()
                .map(|(i, state)| End {
                    ball: name(scene, i),
                    state,
                })
                .collect(),
        }
    }

    /// The summary in a few lines for a person.
    #[must_use]
    pub fn text(&self) -> String {
        let reason = match self.reason {
            Some(EndReason::Rest) => "every ball is at rest",
            Some(EndReason::TimeLimit) => "the time limit was reached",
            Some(EndReason::EventLimit) => "the event limit was reached",
            Some(EndReason::Quiet) => "nothing can happen any more",
            None => "the run was cut short",
        };
        let counts: Vec<String> = self
            .events
            .iter()
            .map(|(kind, count)| format!("{count} {kind}"))
            .collect();
        let mut text = format!(
            "{}: {}\n  after {:.3} s {reason}; events: {}",
            self.scene,
            self.title,
            self.time,
            if counts.is_empty() {
                "none".to_owned()
            } else {
                counts.join(", ")
            },
        );
        for potted in &self.potted {
            let _ = write!(
                text,
                "\n  {:.3} s: {} fell into pocket {}",
                potted.time, potted.ball, potted.pocket
            );
        }
        let left = self.end.iter().filter(|end| end.state.motion.in_play());
        for end in left.clone().take(MOST_PLACES) {
            let at = end.state.position;
            let _ = write!(
                text,
                "\n  {} ends at x = {:+.4} m, z = {:+.4} m",
                end.ball, at.x, at.z
            );
        }
        let left = left.count();
        if left > MOST_PLACES {
            let _ = write!(text, "\n  and {} more balls", left - MOST_PLACES);
        }
        text
    }
}
