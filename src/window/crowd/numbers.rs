//! The live numbers of a crowd, from its census.

use std::time::Duration;

use bevy::prelude::*;
use bevy_egui::egui;

use crate::game::watch::Watch;
use crate::physics::ball::Ball;
use crate::sim::clock::Clock;
use crate::sim::playfield::Playfield;
use crate::sim::stepped::crowd::{Census, Crowd, Pass};
use crate::window::crowd::pace::Cost;
use crate::window::crowd::pack::Packed;
use crate::window::language::Language;

/// How much a new value counts against the old ones.
const FRESH: f64 = 0.1;

/// Means over the last ticks and frames.
#[derive(Resource, Debug, Default)]
pub(super) struct Numbers {
    /// ms of a tick in each pass.
    passes: [f64; Pass::ALL.len()],
    /// Ticks of the clock when it was last looked at.
    ticks: u64,
    /// Contacts of balls and with cushions, and the seconds they took, since the rates were last told.
    counted: (u64, u64, f64),
    /// Contacts of balls and with cushions in a second of the table.
    rates: (f64, f64),
    /// Deepest overlap since the scene began, m.
    overlap: f64,
    /// Energy of the first tick, kinetic and potential, J.
    first: Option<f64>,
    /// s of a frame.
    frame: f64,
    /// Seconds of the table in a second.
    pace: f64,
    /// Time of the clock at the last frame, s.
    shown: f64,
}

/// Counts one tick.
pub(super) fn count(
    mut numbers: ResMut<Numbers>,
    census: Res<Census>,
    clock: Res<Clock>,
    playfield: Res<Playfield>,
) {
    if !playfield.solver.is_crowd() || clock.ticks == numbers.ticks {
        return;
    }
    if clock.ticks < numbers.ticks {
        *numbers = Numbers {
            frame: numbers.frame,
            ..default()
        };
    }
    numbers.ticks = clock.ticks;
    for (mean, time) in numbers.passes.iter_mut().zip(census.times) {
        *mean += FRESH * (1e3 * time.as_secs_f64() - *mean);
    }
    numbers.counted.0 += census.contacts;
    numbers.counted.1 += census.cushions;
    numbers.counted.2 += clock.tick;
    numbers.overlap = numbers.overlap.max(census.overlap);
    numbers
        .first
        .get_or_insert(census.energy + census.potential);
}

/// Follows the frames, and tells rates four times a second.
pub(super) fn follow(
    mut numbers: ResMut<Numbers>,
    time: Res<Time<Real>>,
    clock: Res<Clock>,
    mut told: Local<Duration>,
) {
    let frame = time.delta_secs_f64();
    numbers.frame += FRESH * (frame - numbers.frame);
    let gone = (clock.time() - numbers.shown).max(0.0);
    numbers.shown = clock.time();
    if frame > 0.0 && gone < 1.0 {
        let pace = gone / frame;
        numbers.pace += FRESH * (pace - numbers.pace);
    }
    if time.elapsed() > *told + Duration::from_millis(250) {
        *told = time.elapsed();
        let (balls, cushions, seconds) = std::mem::take(&mut numbers.counted);
        if seconds > 0.0 {
            numbers.rates = (balls as f64 / seconds, cushions as f64 / seconds);
        }
    }
}

/// A number of few digits with its thousands apart.
pub(super) fn large(value: f64) -> String {
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) && !text.ends_with('-') {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// Lays out the numbers.
pub(super) fn show(
    ui: &mut egui::Ui,
    numbers: &Numbers,
    census: &Census,
    packed: &Packed,
    cost: &Cost,
    clock: &Clock,
    language: &Language,
) {
    egui::Grid::new("census")
        .num_columns(2)
        .spacing([12.0, 2.0])
        .show(ui, |ui| {
            let mut row = |name: &str, value: String| {
                ui.label(language.text(name));
                ui.label(egui::RichText::new(value).monospace());
                ui.end_row();
            };
            row("crowd-balls", large(census.balls as f64));
            row("crowd-awake", large(census.awake as f64));
            row("crowd-time", format!("{:.2} s", clock.time()));
            row("crowd-frame", format!("{:.1} ms", 1e3 * numbers.frame));
            row("crowd-pace", format!("{:.2} ×", numbers.pace));
            row("crowd-tick", format!("{:.3} ms", 1e3 * cost.tick));
            for pass in Pass::ALL {
                row(
                    pass_key(pass),
                    format!("{:.3} ms", numbers.passes[pass as usize]),
                );
            }
            row("crowd-pass-packing", milliseconds(packed.fill));
            row("crowd-pass-upload", milliseconds(packed.upload.get()));
            row("crowd-contacts", format!("{} /s", large(numbers.rates.0)));
            row(
                "crowd-cushion-contacts",
                format!("{} /s", large(numbers.rates.1)),
            );
            row("crowd-energy", format!("{:.6} J", census.energy));
            if census.potential != 0.0 {
                row("crowd-potential", format!("{:.6} J", census.potential));
            }
            if let Some(first) = numbers.first {
                // Where the middle of the table counts as zero, the whole can be zero too.
                let now = census.energy + census.potential;
                let scale = if census.potential == 0.0 {
                    first
                } else {
                    census.energy
                };
                if scale > 0.0 {
                    row("crowd-energy-change", change((now - first) / scale));
                }
            }
            row("crowd-fastest", format!("{:.3} m/s", census.speed));
            let diameter = 2.0 * f64::from(packed.radius.max(f32::MIN_POSITIVE));
            row(
                "crowd-overlap",
                format!("{:.1e} d", census.overlap / diameter),
            );
            row(
                "crowd-overlap-most",
                format!("{:.1e} d", numbers.overlap / diameter),
            );
            if census.saturated > 0 {
                row("crowd-saturated", large(census.saturated as f64));
            }
        });
    ui.label(egui::RichText::new(language.text("crowd-times")).weak());
}

/// A small change by its size, a large one in percent.
fn change(share: f64) -> String {
    if share.abs() < 1e-3 {
        format!("{share:+.1e}")
    } else {
        format!("{:+.1} %", 1e2 * share)
    }
}

fn pass_key(pass: Pass) -> &'static str {
    match pass {
        Pass::Grid => "crowd-pass-grid",
        Pass::Balls => "crowd-pass-balls",
        Pass::Cushions => "crowd-pass-cushions",
        Pass::Resolve => "crowd-pass-resolve",
        Pass::Move => "crowd-pass-move",
        Pass::Mirror => "crowd-pass-mirror",
    }
}

fn milliseconds(time: Duration) -> String {
    format!("{:.3} ms", 1e3 * time.as_secs_f64())
}

/// Lays out the numbers of the ball that is watched.
pub(super) fn show_ball(
    ui: &mut egui::Ui,
    language: &Language,
    watch: &mut Watch,
    crowd: &Crowd,
    ball: Option<Ball>,
) {
    let Some(number) = watch.chosen else {
        ui.label(egui::RichText::new(language.text("crowd-click")).weak());
        return;
    };
    ui.horizontal(|ui| {
        ui.strong(language.with("crowd-ball", &[("number", number.to_string().into())]));
        ui.checkbox(&mut watch.follow, language.text("crowd-follow"));
        if ui.button(language.text("crowd-let-go")).clicked() {
            watch.chosen = None;
        }
    });
    let Some(state) = crowd.state(number) else {
        ui.label(language.text("crowd-absent"));
        return;
    };
    let (at, spin) = (state.position, state.angular_velocity);
    egui::Grid::new("ball").num_columns(2).show(ui, |ui| {
        let mut row = |name: &str, value: String| {
            ui.label(language.text(name));
            ui.label(egui::RichText::new(value).monospace());
            ui.end_row();
        };
        row("crowd-ball-place", format!("{:.3}, {:.3} m", at.x, at.z));
        row(
            "crowd-ball-speed",
            format!("{:.3} m/s", state.velocity.length()),
        );
        row("crowd-ball-spin", format!("{:.1} rad/s", spin.length()));
        row("crowd-ball-english", format!("{:.1} rad/s", spin.y));
        if let Some(ball) = ball {
            row(
                "crowd-energy",
                format!("{:.3e} J", ball.kinetic_energy(&state)),
            );
        }
    });
}

#[cfg(test)]
mod tests {
    use super::large;

    #[test]
    fn thousands_stand_apart() {
        assert_eq!(large(0.0), "0");
        assert_eq!(large(999.4), "999");
        assert_eq!(large(5750.0), "5 750");
        assert_eq!(large(1_000_000.0), "1 000 000");
        assert_eq!(large(-1234.0), "-1 234");
        assert_eq!(large(-123_456.0), "-123 456");
    }
}
