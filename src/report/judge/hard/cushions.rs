//! H5: balls that touch a cushion stay in, and a corner sends a ball back along its line.

use glam::DVec3;

use crate::physics::laws::Laws;
use crate::physics::laws::cushion::CushionLaw;
use crate::physics::record::EventKind;
use crate::physics::scene::Scene;
use crate::physics::table::Preset;
use crate::report::judge::hard::{By, Claim, Rows, put, smooth, worst};
use crate::report::judge::stand::{Stand, name_of, room};
use crate::sim::play::Stopped;

pub(super) fn rows() -> Rows {
    let mut rows = Vec::new();
    for by in By::BOTH {
        for law in CushionLaw::all() {
            let laws = Laws {
                cushion: law,
                ..Laws::default()
            };
            let (deepest, count) = beyond(by, laws)?;
            let claim = Claim::new(
                "H5",
                format!("at the cushion, {count} ways, {}", name_of(&law)),
                by.name(),
                "never beyond touching by 1e-9 m",
            );
            rows.push(claim.fact(deepest <= 1e-9, format!("{deepest:.1e} m beyond")));
        }
        let mut errors = Vec::new();
        let mut hits = Vec::new();
        for (x, z) in [
            (1.0, 1.0),
            (1.0, 1.0 + 1e-15),
            (1.0 + 1e-15, 1.0),
            (1.0, 1.0 - 1e-9),
        ] {
            let (error, count) = corner(by, x, z)?;
            errors.push(error);
            hits.push(count);
        }
        let error = worst(errors);
        let claim = Claim::new(
            "H5",
            "45° into a square corner, e 0.8, both orders",
            by.name(),
            "two rebounds, back along its line with 0.8 v",
        );
        rows.push(claim.error(
            if hits == [2; 4] { error } else { f64::NAN },
            1e-13,
            format!("{hits:?} rebounds, differs by {error:.0e}"),
        ));
    }
    Ok(rows)
}

/// How far beyond touching a ball ever comes that starts there, at any speed and angle; and the number of starts.
fn beyond(by: By, laws: Laws) -> Result<(f64, u32), Stopped> {
    let mut deepest = Vec::new();
    for speed in [1e-12, 1e-6, 0.1, 2.0, 30.0] {
        for degrees in [0.0_f64, 30.0, 60.0, 89.0, 90.0] {
            for gap in [0.0, 1e-12, 1e-16, -1e-12] {
                let mut scene = room(laws);
                let reach = scene.table.reach(Stand::POOL.ball.radius);
                let angle = degrees.to_radians();
                let velocity = speed * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
                put(
                    &mut scene,
                    "cue",
                    100.0 - reach - gap,
                    0.0,
                    velocity,
                    DVec3::ZERO,
                );
                scene.time_limit = 1.0;
                let record = by.play(&scene)?;
                deepest.extend((0..=200).map(|i| {
                    let state = record.state_at(0, record.end_time * f64::from(i) / 200.0);
                    state.position.x - (100.0 - reach)
                }));
            }
        }
    }
    Ok((worst(deepest), 100))
}

/// A ball into the corner of a square: what its last velocity is off by, and its rebounds.
fn corner(by: By, x: f64, z: f64) -> Result<(f64, usize), Stopped> {
    let table = Preset::Box {
        length: 2.0,
        width: 2.0,
    };
    let mut scene = Scene::new(table.table(), smooth(1.0, 0.8));
    put(
        &mut scene,
        "cue",
        0.0,
        0.0,
        DVec3::new(x, 0.0, z),
        DVec3::ZERO,
    );
    scene.time_limit = 1.5;
    let record = by.play(&scene)?;
    let hit = |kind: EventKind| matches!(kind, EventKind::Cushion { .. });
    let hits = record.events.iter().filter(|event| hit(event.kind)).count();
    let back = DVec3::new(-0.8 * x, 0.0, -0.8 * z);
    Ok(((record.end[0].velocity - back).length(), hits))
}
