//! One ball. H9: a slide of almost nothing. H10: spin without motion, and the slowest roll.

use glam::DVec3;

use crate::physics::ball::Motion;
use crate::physics::laws::Laws;
use crate::physics::laws::motion::Cloth;
use crate::physics::record::EndReason;
use crate::report::judge::hard::{By, Claim, Rows, put, worst};
use crate::report::judge::stand::{Stand, room};

pub(super) fn almost_rolling() -> Rows {
    let mut rows = Vec::new();
    let ball = Stand::POOL.ball;
    for by in By::BOTH {
        let (mut errors, mut most, mut rested) = (Vec::new(), 0, true);
        for exponent in 6..=18 {
            let slip = libm::pow(10.0, -f64::from(exponent));
            let mut scene = room(Laws::default());
            let velocity = DVec3::X * (1.0 + slip);
            put(
                &mut scene,
                "cue",
                0.0,
                0.0,
                velocity,
                ball.rolling_spin(DVec3::X),
            );
            let record = by.play(&scene)?;
            let cloth = Cloth::default();
            let way = 0.5 / (cloth.rolling * cloth.gravity);
            // The slip itself changes the way.
            let error = (record.end[0].position.x / way - 1.0).abs() - 3.0 * slip;
            errors.push(error.max(0.0));
            most = most.max(record.events.len());
            rested &= record.reason == Some(EndReason::Rest);
        }
        let error = worst(errors);
        let claim = Claim::new(
            "H9",
            "rolls at 1 m/s but for a slip of 1e-6 to 1e-18 m/s",
            by.name(),
            "rolls v²/(2 μ g) far, at most 2 events",
        );
        rows.push(claim.error(
            if rested && most <= 2 { error } else { f64::NAN },
            1e-12,
            format!("differs by {error:.0e}, at most {most} events"),
        ));
    }
    Ok(rows)
}

pub(super) fn spinning() -> Rows {
    let mut rows = Vec::new();
    let ball = Stand::POOL.ball;
    let cloth = Cloth::default();
    for by in By::BOTH {
        let mut scene = room(Laws::default());
        put(&mut scene, "cue", 0.3, 0.1, DVec3::ZERO, DVec3::Y * -54.5);
        let crawl = DVec3::X * 1e-4;
        put(
            &mut scene,
            "slow",
            2.0,
            0.0,
            crawl,
            ball.rolling_spin(crawl),
        );
        let record = by.play(&scene)?;
        let stop = |ball: usize| {
            record.paths[ball]
                .last()
                .map_or(f64::NAN, |piece| piece.time)
        };
        let drift = (record.end[0].position - scene.balls[0].state.position).length();
        let must = [
            54.5 / cloth.spin_deceleration,
            1e-4 / (cloth.rolling * cloth.gravity),
        ];
        let errors = [0, 1].map(|ball| (stop(ball) / must[ball] - 1.0).abs());
        let claim = Claim::new(
            "H10",
            "spins at 54.5 rad/s in its place",
            by.name(),
            format!("no drift, ends at {:.6} s", must[0]),
        );
        rows.push(claim.error(
            if drift == 0.0 { errors[0] } else { f64::NAN },
            1e-12,
            format!("drifts {drift} m, ends at {:.6} s", stop(0)),
        ));
        let back = (0..1000).any(|i| {
            let time = record.end_time * f64::from(i) / 1000.0;
            record.state_at(1, time).velocity.x < 0.0
        });
        let rest = record.end.iter().all(|state| state.motion == Motion::Rest);
        let claim = Claim::new(
            "H10",
            "rolls at 0.1 mm/s",
            by.name(),
            format!("never backwards, ends at {:.6} ms", 1e3 * must[1]),
        );
        rows.push(claim.error(
            if !back && rest { errors[1] } else { f64::NAN },
            1e-12,
            format!("ends at {:.6} ms", 1e3 * stop(1)),
        ));
    }
    Ok(rows)
}
