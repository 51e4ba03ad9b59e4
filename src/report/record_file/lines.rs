//! The lines as they are written.

use serde::Serialize;

use crate::physics::ball::{Motion, State};
use crate::physics::record::{Event, EventKind, PathPiece, Record};
use crate::physics::scene::Scene;
use crate::report::record_file::{FORMAT, Summary, VERSION};

/// The first line.
#[derive(Serialize)]
pub(super) struct Header<'a> {
    format: &'static str,
    version: u64,
    name: &'a str,
    title: &'a str,
    scene: &'a Scene,
}

impl<'a> Header<'a> {
    pub(super) fn of(name: &'a str, title: &'a str, scene: &'a Scene) -> Self {
        Self {
            format: FORMAT,
            version: VERSION,
            name,
            title,
            scene,
        }
    }
}

/// An event.
#[derive(Serialize)]
pub(super) struct EventLine<'a> {
    time: f64,
    kind: &'static str,
    who: Vec<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    miscue: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cushion: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pocket: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<Motion>,
    #[serde(skip_serializing_if = "Option::is_none")]
    to: Option<Motion>,
    impulse: f64,
    before: Vec<&'a State>,
    after: Vec<&'a State>,
}

impl<'a> EventLine<'a> {
    pub(super) fn of(scene: &'a Scene, event: &'a Event) -> Self {
        let mut line = Self {
            time: event.time,
            kind: kind(&event.kind),
            who: event.participants().map(|p| name(scene, p.ball)).collect(),
            miscue: None,
            cushion: None,
            pocket: None,
            from: None,
            to: None,
            impulse: event.impulse,
            before: event.participants().map(|p| &p.before).collect(),
            after: event.participants().map(|p| &p.after).collect(),
        };
        match event.kind {
            EventKind::Strike { miscue } => line.miscue = Some(miscue),
            EventKind::BallBall | EventKind::Slate | EventKind::OffTable => {}
            EventKind::Cushion { cushion } => line.cushion = Some(cushion),
            EventKind::Rim { pocket } | EventKind::Pocketed { pocket } => {
                line.pocket = Some(pocket_name(scene, pocket));
            }
            EventKind::Motion { from, to } => (line.from, line.to) = (Some(from), Some(to)),
        }
        line
    }
}

/// A path that the events do not tell.
#[derive(Serialize)]
pub(super) struct PathLine<'a> {
    path: &'a str,
    pieces: Vec<PieceStart<'a>>,
}

#[derive(Serialize)]
struct PieceStart<'a> {
    time: f64,
    state: &'a State,
}

impl<'a> PathLine<'a> {
    pub(super) fn of(scene: &'a Scene, ball: usize, path: &'a [PathPiece]) -> Self {
        Self {
            path: name(scene, ball),
            pieces: path
                .iter()
                .map(|turn| PieceStart {
                    time: turn.time,
                    state: &turn.piece.start,
                })
                .collect(),
        }
    }
}

/// The last line.
#[derive(Serialize)]
pub(super) struct Last<'s, 'a> {
    pub(super) summary: &'s Summary<'a>,
    /// How many paths have lines of their own.
    pub(super) paths: usize,
}

/// What a line calls this kind of event.
pub(super) fn kind(kind: &EventKind) -> &'static str {
    match kind {
        EventKind::Strike { .. } => "strike",
        EventKind::BallBall => "ball_ball",
        EventKind::Slate => "slate",
        EventKind::Rim { .. } => "rim",
        EventKind::OffTable => "off_table",
        EventKind::Cushion { .. } => "cushion",
        EventKind::Pocketed { .. } => "pocketed",
        EventKind::Motion { .. } => "motion",
    }
}

/// The name of a ball; empty if a record names a ball that its scene does not have.
pub(super) fn name(scene: &Scene, ball: usize) -> &str {
    scene.balls.get(ball).map_or("", |ball| &ball.name)
}

/// The name of a pocket; empty if a record names a pocket that its scene does not have.
pub(super) fn pocket_name(scene: &Scene, pocket: usize) -> &str {
    scene
        .table
        .pockets
        .get(pocket)
        .map_or("", |pocket| &pocket.name)
}

/// Whether a record speaks of the balls of this scene and of no others.
pub(super) fn belongs(scene: &Scene, record: &Record) -> bool {
    let count = scene.balls.len();
    record.paths.len() == count
        && record.paths.iter().all(|path| !path.is_empty())
        && record.end.len() == count
        && record
            .events
            .iter()
            .flat_map(Event::participants)
            .all(|participant| participant.ball < count)
}
