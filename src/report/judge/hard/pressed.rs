//! H2: contacts that are pressed together. Friction that drives a ball against what it touches would make it bounce
//! 2 w/(μ g (1 − e)) seconds long with infinitely many bounces; so would a slate under a ball that falls.

use glam::DVec3;

use crate::physics::cue::Shot;
use crate::physics::exact::{Contact, Engine, Limits};
use crate::physics::laws::Laws;
use crate::physics::laws::cushion::{CushionLaw, Mirror};
use crate::physics::record::{EndReason, EventKind};
use crate::physics::scene::{PlannedShot, Scene};
use crate::physics::table::Preset;
use crate::report::judge::hard::{By, Claim, Hard, Rows, put};
use crate::report::judge::stand::{Stand, name_of, room};
use crate::sim::play::Stopped;

/// Most events of such a contact.
const EVENTS: usize = 5000;

pub(super) fn rows() -> Rows {
    let mut rows = Vec::new();
    let mirror = CushionLaw::Mirror(Mirror {
        restitution: 0.8.into(),
    });
    for cushion in [mirror, Laws::default().cushion] {
        for speed in [0.0, 0.5] {
            let scene = topspin(cushion, speed);
            for by in By::BOTH {
                rows.push(rests(&scene, by, &cushion, speed)?);
            }
        }
        rows.push(leans(&topspin(cushion, 0.0), &cushion)?);
    }
    for by in By::BOTH {
        rows.push(between(by)?);
        rows.push(drop(by)?);
        rows.push(pocket(by)?);
    }
    Ok(rows)
}

/// A ball with the topspin of 4 m/s that touches the cushion towards which it spins.
fn topspin(cushion: CushionLaw, speed: f64) -> Scene {
    let mut scene = room(Laws {
        cushion,
        ..Laws::default()
    });
    let spin = Stand::POOL.ball.rolling_spin(DVec3::X * 4.0);
    let x = 100.0 - scene.table.reach(Stand::POOL.ball.radius);
    put(&mut scene, "cue", x, 0.3, DVec3::X * speed, spin);
    scene
}

fn rests(scene: &Scene, by: By, cushion: &CushionLaw, speed: f64) -> Result<Hard, Stopped> {
    let (record, seen) = by.audit(scene)?;
    let touches = |kind: EventKind| matches!(kind, EventKind::Cushion { .. });
    let bounces = record.events.iter().filter(|event| touches(event.kind));
    let bounces = bounces.count();
    let rested = record.reason == Some(EndReason::Rest);
    let claim = Claim::new(
        "H2",
        format!("topspin at the cushion, {speed} m/s, {}", name_of(cushion)),
        by.name(),
        format!("rests, stays in, at most {EVENTS} events"),
    );
    Ok(claim.fact(
        rested
            && bounces > 0
            && record.events.len() < EVENTS
            && seen.cushion <= 1e-9
            && seen.left == 0,
        format!(
            "{} after {:.2} s, {} events, {bounces} of them bounces",
            if rested { "rests" } else { "moves" },
            record.end_time,
            record.events.len()
        ),
    ))
}

/// The exact solver says while it lasts that the ball leans on the cushion, and the spin that drives it wears off.
fn leans(scene: &Scene, cushion: &CushionLaw) -> Result<Hard, Stopped> {
    let mut engine = Engine::new(scene, Limits::default())?;
    let (mut leaned, mut spin, mut grew) = (0, f64::INFINITY, false);
    for i in 1..200 {
        engine.advance(0.01 * f64::from(i), &mut ())?;
        leaned += u32::from(matches!(
            engine.contact(0),
            Contact::RestingOnCushion { .. }
        ));
        let now = (-engine.state(0).angular_velocity.z).max(0.0);
        grew |= now > spin + 1e-6;
        spin = now;
    }
    let claim = Claim::new(
        "H2",
        format!("topspin at the cushion, at rest, {}", name_of(cushion)),
        "exact",
        "leans on the cushion while its spin decays",
    );
    Ok(claim.fact(
        leaned > 0 && !grew,
        format!(
            "leans in {leaned} of 200 looks, spin {}",
            if grew { "grows" } else { "falls" }
        ),
    ))
}

/// A ball that its topspin presses against another, which touches the cushion.
fn between(by: By) -> Result<Hard, Stopped> {
    let r = Stand::POOL.ball.radius;
    let mut scene = room(Laws::default());
    let spin = Stand::POOL.ball.rolling_spin(DVec3::X * 5.0);
    let x = 100.0 - scene.table.reach(r);
    put(&mut scene, "cue", x - 2.0 * r, 0.0, DVec3::ZERO, spin);
    put(&mut scene, "1", x, 0.0, DVec3::ZERO, DVec3::ZERO);
    let (record, seen) = by.audit(&scene)?;
    let claim = Claim::new(
        "H2",
        "topspin against a ball at the cushion",
        by.name(),
        format!("rests, stays in, at most {EVENTS} events"),
    );
    let rested = record.reason == Some(EndReason::Rest);
    let deep = seen.cushion.max(seen.overlap);
    Ok(claim.fact(
        rested && record.events.len() < EVENTS && deep <= 1e-9,
        format!("{} events, overlap {deep:.0e} m", record.events.len()),
    ))
}

/// A ball that falls on the slate from 0.1 m.
fn drop(by: By) -> Result<Hard, Stopped> {
    let mut scene = room(Laws::default());
    put(&mut scene, "cue", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
    scene.balls[0].state.position.y += 0.1;
    let record = by.play(&scene)?;
    let slate = record
        .events
        .iter()
        .filter(|event| event.kind == EventKind::Slate);
    let bounces = slate.count();
    let rested = record.reason == Some(EndReason::Rest);
    let claim = Claim::new(
        "H2",
        "dropped on the slate from 0.1 m",
        by.name(),
        "rests, at most 100 bounces",
    );
    Ok(claim.fact(
        rested && (2..=100).contains(&bounces),
        format!("{bounces} bounces, rests after {:.3} s", record.end_time),
    ))
}

/// A ball that jumps into the far side of a corner pocket, and on its way out meets the nose from below.
fn pocket(by: By) -> Result<Hard, Stopped> {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let (x, z) = (-0.992_410_546_244_571_5, 0.096_022_910_363_046_83);
    scene.place("cue", Stand::POOL.ball, x, z);
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: Shot {
            heading: 1.946_287_199_593_663_3,
            elevation: 0.0,
            side: -0.167_809_556_990_789_84,
            height: -0.249_424_800_410_358_1,
            speed: 6.053_508_120_241_644,
        },
    });
    let record = by.play(&scene)?;
    let rested = record.reason == Some(EndReason::Rest);
    let claim = Claim::new(
        "H2",
        "between the edge of a pocket and a nose",
        by.name(),
        "gets out or in, at most 1000 events",
    );
    Ok(claim.fact(
        rested && record.events.len() < 1000,
        format!(
            "{} events, ends {:?}",
            record.events.len(),
            record.end[0].motion
        ),
    ))
}
