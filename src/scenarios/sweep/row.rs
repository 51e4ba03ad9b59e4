//! What became of one shot of a sweep, and how a table tells it.

use crate::physics::ball::{Motion, State};
use crate::physics::record::{EndReason, EventKind, Record};
use crate::physics::scene::Scene;
use crate::scenarios::expect::{self, Expectation, Outcome};

/// A shot of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number, from 0.
    pub shot: u64,
    /// The value of every axis.
    pub values: Vec<f64>,
    /// What happened, or why it could not be played.
    pub played: Result<Played, String>,
}

/// What happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Played {
    /// Why it ended.
    pub reason: Option<EndReason>,
    /// When it ended, s.
    pub time: f64,
    /// How often two balls met.
    pub hits: usize,
    /// How often a ball met a cushion.
    pub cushions: usize,
    /// What became of the expectations of the scene.
    pub outcomes: Vec<Outcome>,
    /// Every ball at the end.
    pub end: Vec<State>,
    /// The pocket that took each ball.
    pub pockets: Vec<Option<usize>>,
}

impl Played {
    pub(super) fn of(scene: &Scene, record: &Record, expect: &[Expectation]) -> Self {
        let mut pockets = vec![None; record.end.len()];
        let (mut hits, mut cushions) = (0, 0);
        for event in &record.events {
            match event.kind {
                EventKind::BallBall => hits += 1,
                EventKind::Cushion { .. } => cushions += 1,
                EventKind::Pocketed { pocket } => pockets[event.first.ball] = Some(pocket),
                EventKind::Strike { .. }
                | EventKind::Slate
                | EventKind::Rim { .. }
                | EventKind::OffTable
                | EventKind::Motion { .. } => {}
            }
        }
        Self {
            reason: record.reason,
            time: record.end_time,
            hits,
            cushions,
            outcomes: expect::judge(scene, record, expect),
            end: record.end.clone(),
            pockets,
        }
    }

    /// Where a ball is at the end: `table`, `off`, or the name of the pocket that took it.
    fn fate<'s>(&self, scene: &'s Scene, ball: usize) -> &'s str {
        let pocket = self.pockets[ball].and_then(|pocket| scene.table.pockets.get(pocket));
        match (pocket, self.end[ball].motion) {
            (Some(pocket), _) => &pocket.name,
            (None, Motion::OffTable) => "off",
            (None, Motion::Pocketed) => "pocket",
            (None, _) => "table",
        }
    }
}

/// The heads of the columns after those of the axes.
pub(super) fn columns(scene: &Scene, expect: &[Expectation]) -> Vec<String> {
    let mut columns = ["reason", "time", "hits", "cushions"]
        .map(str::to_owned)
        .to_vec();
    if !expect.is_empty() {
        columns.push("met".to_owned());
        columns.extend((1..=expect.len()).map(|i| format!("found_{i}")));
    }
    for ball in &scene.balls {
        let name = &ball.name;
        columns.extend([
            format!("{name}.x"),
            format!("{name}.z"),
            format!("{name}.fate"),
        ]);
    }
    columns
}

impl Row {
    /// The row as text, in the order of [`Sweep::columns`](super::Sweep::columns). Of a shot that could not be played
    /// `reason` says why, and what follows is empty. Numbers have all their digits.
    #[must_use]
    pub fn cells(&self, scene: &Scene) -> Vec<String> {
        let values = self.values.iter().map(f64::to_string);
        let mut cells: Vec<String> = std::iter::once(self.shot.to_string())
            .chain(values)
            .collect();
        match &self.played {
            Ok(played) => cells.extend(told(played, scene)),
            Err(why) => cells.push(format!("refused: {why}")),
        }
        cells
    }
}

fn told(played: &Played, scene: &Scene) -> Vec<String> {
    let reason = match played.reason {
        None => "cut_short",
        Some(EndReason::Rest) => "rest",
        Some(EndReason::TimeLimit) => "time_limit",
        Some(EndReason::EventLimit) => "event_limit",
        Some(EndReason::Quiet) => "quiet",
    };
    let mut cells = vec![
        reason.to_owned(),
        played.time.to_string(),
        played.hits.to_string(),
        played.cushions.to_string(),
    ];
    if !played.outcomes.is_empty() {
        let met = played.outcomes.iter().all(|outcome| outcome.met);
        cells.push(met.to_string());
        let found = |outcome: &Outcome| outcome.found.map_or_else(String::new, |v| v.to_string());
        cells.extend(played.outcomes.iter().map(found));
    }
    for (ball, state) in played.end.iter().enumerate() {
        cells.push(state.position.x.to_string());
        cells.push(state.position.z.to_string());
        cells.push(played.fate(scene, ball).to_owned());
    }
    cells
}
