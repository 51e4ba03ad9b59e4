//! How much of a shot's success is luck.

use crate::physics::scene::Scene;
use crate::scenarios::dial::Dial;
use crate::scenarios::expect::{Expectation, miss};
use crate::scenarios::search::Player;
use crate::scenarios::search::spread::{latin, numbers};

/// Strokes of each size.
const STROKES: usize = 24;

/// Sizes of the errors in units of [`Dial::human_error`].
const SIZES: [f64; 4] = [1.0, 0.3, 0.1, 0.03];

/// Errors of the stroke in units of [`Dial::human_error`], evenly spread from -1 to 1.
fn errors() -> Vec<Vec<f64>> {
    let mut points = latin(&mut numbers(0, 0, 0), STROKES, Dial::ALL.len());
    for value in points.iter_mut().flatten() {
        *value = 2.0 * *value - 1.0;
    }
    points
}

/// The share of strokes with errors that still meet everything, 0 to 1: errors as large as a good player's, a third, a tenth
/// and a thirtieth of them. The same scene gives the same number. A dial at its stop, as the elevation of a level cue, is
/// turned away from it only.
#[must_use]
pub fn robustness(player: &mut Player, scene: &Scene, expect: &[Expectation]) -> f64 {
    let Some(planned) = scene.shot else {
        return 0.0;
    };
    let mut tried = scene.clone();
    let mut met = 0;
    let strokes = errors();
    for size in SIZES {
        for errors in &strokes {
            let mut shot = planned.shot;
            for (dial, error) in Dial::ALL.into_iter().zip(errors) {
                let (least, most) = dial.limits(&planned.shot, scene.cue.miscue_offset);
                let mut turned = dial.get(&shot) + size * error * dial.human_error();
                if dial == Dial::Elevation && dial.get(&shot) == 0.0 {
                    turned = 0.0;
                }
                // A tip at the edge of a miscue stays there.
                let own = dial.get(&planned.shot);
                dial.set(&mut shot, turned.clamp(least.min(own), most.max(own)));
            }
            tried.shot = Some(crate::physics::scene::PlannedShot { shot, ..planned });
            match player.play(&tried) {
                Ok(record) if miss(&tried, record, expect) == 0.0 => met += 1,
                Ok(_) => {}
                Err(_) => player.forget(),
            }
        }
    }
    f64::from(met) / (SIZES.len() * STROKES) as f64
}
