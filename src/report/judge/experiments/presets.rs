//! E1, E3 and E10 with the presets of equipment: the numbers that the game ships, beside what was measured.

use crate::physics::equipment::Equipment;
use crate::physics::laws::motion::MotionLaw;
use crate::report::judge::experiments::{settled_normal, square_ratio};
use crate::report::judge::measurements::{
    CAROM_ROLL, MATHAVAN_2009_ROLL, MATHAVAN_2009_SLIDE, MATHAVAN_2010, THREE_CUSHION_SETTLED,
};
use crate::report::judge::stand::Stand;
use crate::report::judge::{Measure, Row};

/// A preset by name.
pub type Named = (String, Equipment);

/// What was measured on the kind of table that a preset stands for.
pub(in crate::report::judge) fn rows(presets: &[Named]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, equipment) in presets {
        let Some(stand) = stand(equipment) else {
            continue;
        };
        let law = format!("preset {name}");
        match name.as_str() {
            "snooker" => rows.extend(snooker(&law, &stand, equipment)),
            "heated_carom" => rows.extend(carom(&law, &stand, equipment)),
            _ => {}
        }
    }
    rows
}

/// The balls, cloth and nose of a preset, if it has a cloth.
fn stand(equipment: &Equipment) -> Option<Stand> {
    let MotionLaw::Coulomb(cloth) = equipment.laws.motion else {
        return None;
    };
    Some(Stand {
        ball: equipment.balls.cue,
        cloth,
        nose_height: equipment.table.nose_height,
    })
}

/// Deceleration in m/s² of a ball with this share of the spin of rolling.
fn deceleration(stand: &Stand, roll: f64) -> f64 {
    let piece = stand.motion().piece(&stand.ball, &stand.rolling(0.5, roll));
    piece.acceleration.length()
}

fn snooker(law: &str, stand: &Stand, equipment: &Equipment) -> Vec<Row> {
    let source = "Mathavan et al. 2009, high-speed camera; half the range";
    let taken = "The number of the preset comes from this paper.";
    let mut rows = Vec::new();
    for (what, (least, most), roll) in [
        ("E1 deceleration of a roll", MATHAVAN_2009_ROLL, 1.0),
        ("E1 deceleration of a slide", MATHAVAN_2009_SLIDE, 0.0),
    ] {
        let middle = 0.5 * (least + most);
        let half = (Measure::Absolute, 0.5 * (most - least));
        let ours = deceleration(stand, roll);
        rows.push(
            Row::measured(what, law, middle, ours, "m/s²", half)
                .by(source)
                .remark(taken),
        );
    }
    let slow: Vec<(f64, f64)> = MATHAVAN_2010
        .into_iter()
        .filter(|(speed, _)| *speed < 1.5)
        .map(|(speed, after)| {
            (
                after / speed,
                square_ratio(stand, &equipment.laws.cushion, speed),
            )
        })
        .collect();
    let title = "E3 square roll below 1.5 m/s, snooker: speed ratio";
    rows.push(
        Row::points(title, law, &slow, "", (Measure::RelativeRms, 0.025))
            .by("Mathavan et al. 2010, fig. 7a; 2.5 % is the scatter of the markers")
            .remark("Coefficients of the cushion are those that the authors of the paper chose for their own law and this set."),
    );
    rows
}

fn carom(law: &str, stand: &Stand, equipment: &Equipment) -> Vec<Row> {
    let roll: Vec<(f64, f64)> = CAROM_ROLL
        .map(|measured| (measured, deceleration(stand, 1.0)))
        .to_vec();
    let (normal_speed, measured) = THREE_CUSHION_SETTLED;
    let settled: Vec<(f64, f64)> = [0.0, 15.0, 30.0, 45.0]
        .map(|degrees| {
            let incidence = f64::to_radians(degrees);
            (
                measured,
                settled_normal(stand, &equipment.laws.cushion, normal_speed, incidence),
            )
        })
        .to_vec();
    vec![
        Row::points("E10 deceleration of a roll, three speeds", law, &roll, "m/s²", (Measure::RelativeRms, 0.1))
            .by("182 tracked three-cushion shots, 613 paths; a tenth taken")
            .remark("The number of the preset is the mean of these three; that it rises with speed is not modelled."),
        Row::points(
            "E10 roll at 0 to 45° off the normal: settled normal ratio",
            law,
            &settled,
            "",
            (Measure::RelativeRms, 0.04),
        )
        .by("182 tracked three-cushion shots, normal speed 0.3 to 0.5 m/s, n 73")
        .because("Coefficients of a snooker cushion under the law of the preset: no cushion of a carom table was measured as well."),
    ]
}
