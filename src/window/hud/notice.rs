//! Notices: they come up in the middle below, stay a while and go.

use std::time::Duration;

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::equip::Told;
use crate::game::saying::Saying;
use crate::physics::record::EventKind;
use crate::sim::messages::{Failed, Struck};
use crate::sim::playfield::Playfield;
use crate::window::felt;
use crate::window::language::Language;
use crate::window::page::panel_id;

/// How long a notice stays.
const STAY: Duration = Duration::from_secs(8);
/// Greatest width of a notice in points.
const WIDTH: f32 = 480.0;
/// Notices shown at once.
const SHOWN: usize = 3;

/// What the player is told.
#[derive(Resource, Debug, Default)]
pub(super) struct Notices {
    /// What is said, whether it tells of a failure, and until when it stays.
    list: Vec<(Saying, bool, Duration)>,
    /// Time that somebody could read in: a frame that took long, as the first ones do, counts as a short one.
    read: Duration,
}

impl Notices {
    fn tell(&mut self, saying: Saying, is_failure: bool, until: Duration) {
        self.list.retain(|(old, ..)| *old != saying);
        self.list.push((saying, is_failure, until));
        if self.list.len() > SHOWN {
            self.list.remove(0);
        }
    }
}

/// Tells a new player how to begin.
pub(super) fn welcome(mut notices: ResMut<Notices>, playfield: Res<Playfield>) {
    let (key, english) = if playfield.solver.is_crowd() {
        (
            "notice-crowd",
            "Click a ball to watch it, drag to move, wheel to zoom, Space holds.",
        )
    } else {
        (
            "notice-welcome",
            "Drag to aim, wheel for power, Space to strike. H shows every key.",
        )
    };
    notices.tell(Saying::new(key, &[], english), false, 2 * STAY);
}

/// Tells of a shot that could not be followed, of a miscue, of what others have to tell, and forgets what is old.
pub(super) fn listen(
    mut failed: MessageReader<Failed>,
    mut told: MessageReader<Told>,
    mut struck: MessageReader<Struck>,
    time: Res<Time<Real>>,
    mut notices: ResMut<Notices>,
) {
    let now = notices.read + felt(&time);
    notices.bypass_change_detection().read = now;
    for failure in failed.read() {
        let (at, reason) = (format!("{:.4}", failure.time), failure.reason.clone());
        let saying = Saying::new(
            "notice-solver",
            &[("time", &at), ("reason", &reason)],
            format!("The solver stopped at {at} s: {reason}. The table is back as it was."),
        );
        notices.tell(saying, true, now + STAY);
    }
    for Struck(event) in struck.read() {
        if event.kind == (EventKind::Strike { miscue: true }) {
            let english = "Miscue: the tip slipped off the ball.";
            let saying = Saying::new("notice-miscue", &[], english);
            notices.tell(saying, true, now + STAY);
        }
    }
    for Told { text, is_failure } in told.read() {
        notices.tell(text.clone(), *is_failure, now + STAY);
    }
    if notices.list.iter().any(|(.., until)| *until < now) {
        notices.list.retain(|(.., until)| *until >= now);
    }
}

/// Lays out the notices; a click takes one away.
pub(super) fn show(
    mut contexts: EguiContexts,
    language: Res<Language>,
    mut notices: ResMut<Notices>,
) -> Result {
    if notices.list.is_empty() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let mut gone = None;
    egui::Area::new(panel_id(context, "notices"))
        // Panels must not hide what is told.
        .order(egui::Order::Foreground)
        .anchor(egui::Align2::CENTER_BOTTOM, egui::vec2(0.0, -44.0))
        .show(context, |ui| {
            // Not as narrow as what was shown before.
            ui.set_max_width(WIDTH.min(0.9 * context.content_rect().width()));
            for (i, (saying, is_failure, _)) in notices.list.iter().enumerate() {
                let text = language.say(saying);
                let color = if *is_failure {
                    ui.visuals().error_fg_color
                } else {
                    ui.visuals().strong_text_color()
                };
                let shown = egui::Frame::popup(ui.style()).show(ui, |ui| {
                    ui.add(
                        egui::Label::new(egui::RichText::new(text).color(color))
                            .sense(egui::Sense::click()),
                    )
                });
                if shown.inner.clicked() {
                    gone = Some(i);
                }
            }
        });
    if let Some(i) = gone {
        notices.list.remove(i);
    }
    Ok(())
}
