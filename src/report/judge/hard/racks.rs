//! H3: mirrored racks break mirrored, and the numbers of the balls do not matter. What is frozen to a struck ball goes
//! along. H8: the books of a whole break.

use glam::DVec3;

use crate::physics::ball::State;
use crate::physics::cue::Shot;
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::{BallBallLaw, Frictional};
use crate::physics::scene::{PlannedShot, Rack, Scene, Solver};
use crate::physics::table::Preset;
use crate::report::judge::hard::{By, Claim, Hard, Rows, put, smooth, worst};
use crate::report::judge::stand::{Stand, room};
use crate::sim::play::{Stopped, play};
use crate::sim::stepping;

/// Breaks of H8 per rack.
const BREAKS: u32 = 10;

/// Events of a break on a frozen rack.
const EVENTS: usize = 400;

/// A rack as it is, in the mirror z → −z, or with the balls in reverse order; the states 50 ms on.
fn after(by: By, rack: Rack, z: f64, mirror: f64, reverse: bool) -> Result<Vec<State>, Stopped> {
    let laws = Laws {
        ball_ball: BallBallLaw::Frictional(Frictional::default()),
        ..Laws::default()
    };
    let mut scene = Scene::new(Preset::NineFoot.table(), laws);
    rack.place(&mut scene, Stand::POOL.ball, 0.0, 1);
    scene.balls[0].state.position.x = 0.3;
    scene.balls[0].state.position.z = z;
    scene.balls[0].state.velocity = DVec3::X * 8.0;
    if mirror < 0.0 {
        for ball in &mut scene.balls {
            ball.state.position.z *= -1.0;
        }
    }
    if reverse {
        scene.balls.reverse();
    }
    scene.time_limit = 0.05;
    let mut states = by.play(&scene)?.end;
    if reverse {
        states.reverse();
    }
    Ok(states)
}

pub(super) fn mirrored() -> Rows {
    let mut rows = Vec::new();
    for by in By::BOTH {
        for (rack, z) in [
            (Rack::NineBall, 0.0),
            (Rack::NineBall, 0.01),
            (Rack::EightBall, 0.0),
            (Rack::EightBall, 0.02),
        ] {
            rows.push(broken(by, rack, z)?);
        }
        for e in [1.0, 0.95] {
            for before in [0.0, 0.3] {
                rows.push(into_two(by, e, before)?);
            }
        }
        for degrees in [20.0, 46.0, 70.0] {
            rows.push(frozen_pair(by, degrees)?);
        }
    }
    rows.push(live_pair()?);
    Ok(rows)
}

/// How far the break of a rack is from that of its mirror image and of itself with other numbers.
fn broken(by: By, rack: Rack, z: f64) -> Result<Hard, Stopped> {
    let plain = after(by, rack, z, 1.0, false)?;
    let all_move = plain.iter().all(|state| state.velocity != DVec3::ZERO);
    let mut errors = Vec::new();
    for (mirror, reverse) in [(1.0, true), (-1.0, false), (-1.0, true)] {
        let image = after(by, rack, z, mirror, reverse)?;
        errors.extend(plain.iter().zip(&image).map(|(one, two)| {
            let flipped = DVec3::new(two.velocity.x, two.velocity.y, mirror * two.velocity.z);
            (one.velocity - flipped).length() / 8.0
        }));
    }
    let error = worst(errors);
    let claim = Claim::new(
        "H3",
        format!("{rack:?} rack, hit at 8 m/s, {} mm off its axis", 1e3 * z),
        by.name(),
        "mirrors, and permutes with the balls",
    );
    Ok(claim.error(
        if all_move { error } else { f64::NAN },
        1.3e-13,
        format!("all balls move, differ by {error:.0e} of 8 m/s"),
    ))
}

/// One ball into two that touch: each leaves with 0.4 cos 30° (1 + e) v.
fn into_two(by: By, e: f64, before: f64) -> Result<Hard, Stopped> {
    let r = Stand::POOL.ball.radius;
    let mut scene = room(smooth(e, 1.0));
    let x = -3.0_f64.sqrt() * r - before;
    put(&mut scene, "cue", x, 0.0, DVec3::X, DVec3::ZERO);
    put(&mut scene, "1", 0.0, r, DVec3::ZERO, DVec3::ZERO);
    put(&mut scene, "2", 0.0, -r, DVec3::ZERO, DVec3::ZERO);
    scene.time_limit = 0.5;
    let record = by.play(&scene)?;
    let [cue, one, two] = [0, 1, 2].map(|ball| record.end[ball].velocity);
    let object = 0.4 * 0.75_f64.sqrt() * (1.0 + e);
    let error = worst([
        (one.length() / object - 1.0).abs(),
        (cue - DVec3::X * (1.0 - 0.6 * (1.0 + e))).length(),
        (one - DVec3::new(two.x, two.y, -two.z)).length(),
    ]);
    let claim = Claim::new(
        "H3",
        format!("one ball into two, e {e}, run-up {before} m"),
        by.name(),
        format!("both leave with {object:.5} v, alike"),
    );
    Ok(claim.error(
        error,
        1e-12,
        format!("{:.5} and {:.5} v", one.length(), two.length()),
    ))
}

/// A ball that is struck at this angle to the line to another, which it touches.
fn pair(degrees: f64) -> Scene {
    let ball = Stand::POOL.ball;
    let mut scene = room(Laws {
        ball_ball: crate::report::judge::stand::smooth(0.95),
        ..Laws::default()
    });
    scene.place("cue", ball, 0.0, 0.0);
    scene.place("1", ball, 2.0 * ball.radius, 0.0);
    let shot = Shot {
        heading: degrees.to_radians(),
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    scene
}

/// A frozen pair: the struck ball leaves at tan θ = 2 tan φ.
fn frozen_pair(by: By, degrees: f64) -> Result<Hard, Stopped> {
    let record = by.play(&pair(degrees))?;
    let velocity = record.state_at(0, 0.0).velocity;
    let tangent = (velocity.z / velocity.x).abs();
    let must = 2.0 * libm::tan(degrees.to_radians());
    let claim = Claim::new(
        "H3",
        format!("frozen pair, cue at {degrees}°"),
        by.name(),
        format!("tan θ = 2 tan φ = {must:.6}"),
    );
    Ok(claim.error((tangent / must - 1.0).abs(), 1e-12, format!("{tangent:.6}")))
}

/// The table in motion does with a frozen pair what the solver does on paper.
fn live_pair() -> Result<Hard, Stopped> {
    let mut scene = pair(46.0);
    scene.solver = Solver::Exact;
    let solved = play(&scene)?;
    let (live, _) = stepping::try_run_to_rest(&scene).map_err(Stopped::Stepped)?;
    let same = solved.end == live.end && solved.events == live.events && solved.paths == live.paths;
    let claim = Claim::new(
        "H3",
        "frozen pair, cue at 46°",
        "exact, live",
        "the bits of the solved shot",
    );
    Ok(claim.fact(same, if same { "the same bits" } else { "other bits" }))
}

pub(super) fn audited() -> Rows {
    let mut rows = Vec::new();
    for rack in [Rack::NineBall, Rack::EightBall] {
        let ways = By::BOTH.into_iter().flat_map(|by| [(by, 0.0), (by, 1e-4)]);
        for (by, gap) in ways {
            let mut events = 0;
            let mut errors = Vec::new();
            let (mut overlap, mut left) = (0.0_f64, 0);
            for seed in 0..BREAKS {
                let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
                scene.solver = Solver::Exact;
                rack.place(&mut scene, Stand::POOL.ball, gap, u64::from(seed));
                scene.balls[0].state.velocity = DVec3::new(9.0, 0.0, 0.05 * f64::from(seed));
                let (record, seen) = by.audit(&scene)?;
                events = events.max(record.events.len());
                errors.extend([seen.energy, seen.momentum, seen.back]);
                overlap = overlap.max(seen.overlap).max(seen.cushion);
                left += seen.left + seen.not_finite;
            }
            let error = worst(errors);
            let sound = events < EVENTS && overlap <= 1e-9 && left == 0;
            let claim = Claim::new(
                "H8",
                format!(
                    "{BREAKS} breaks at 9 m/s, {rack:?}, gaps of {} mm",
                    1e3 * gap
                ),
                by.name(),
                format!("after each event: momentum, energy, room; at most {EVENTS} events"),
            );
            rows.push(claim.error(
                if sound { error } else { f64::NAN },
                1e-12,
                format!("at most {events} events, overlap {overlap:.0e} m, {left} astray"),
            ));
        }
    }
    Ok(rows)
}
