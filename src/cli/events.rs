//! Events as JSON lines.

use std::io::{self, Write};

use serde::Serialize;

use crate::physics::ball::{Motion, State};
use crate::physics::record::{Event, EventKind};
use crate::physics::scene::Scene;

/// One line.
#[derive(Serialize)]
struct Line<'a> {
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

impl<'a> Line<'a> {
    fn of(scene: &'a Scene, event: &'a Event) -> Self {
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
            EventKind::BallBall => {}
            EventKind::Cushion { cushion } => line.cushion = Some(cushion),
            EventKind::Pocketed { pocket } => line.pocket = Some(pocket_name(scene, pocket)),
            EventKind::Motion { from, to } => (line.from, line.to) = (Some(from), Some(to)),
        }
        line
    }
}

/// Writes one line for each event.
pub(super) fn write(out: &mut dyn Write, scene: &Scene, events: &[Event]) -> io::Result<()> {
    for event in events {
        serde_json::to_writer(&mut *out, &Line::of(scene, event))?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// What a line calls this kind of event.
pub(super) fn kind(kind: &EventKind) -> &'static str {
    match kind {
        EventKind::Strike { .. } => "strike",
        EventKind::BallBall => "ball_ball",
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
