//! What must hold in any scene, after every event, by either solver.

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::exact::{Engine, Limits, Watch};
use masse::physics::laws::Laws;
use masse::physics::laws::cluster::DEEP;
use masse::physics::laws::pocket::PocketLaw;
use masse::physics::record::{Event, EventKind, Participant, PathPiece};
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::report::audit::{Audit, Worst};
use masse::sim::stepping;

/// Largest rise of energy at an event, as a share of all there was.
const ENERGY: f64 = 1e-9;

/// Largest change of momentum in an impact of balls alone, as a share of what moved.
const MOMENTUM: f64 = 1e-10;

/// Deepest overlap, m: a tenth of what the solvers count as beyond rounding. Racks that are pressed for seconds creep into
/// each other by some 1e-8 m, all others by 1e-14 m.
const OVERLAP: f64 = 0.1 * DEEP;

/// Most events of a scene: two that lean on each other touch a thousand times a second, and a ball on the slate can lean on
/// three others. One that slides down into a pocket leans on the edge, the liner, two noses and another ball, and touches them
/// when they press it and when it parts from the last of them.
fn most_events(scene: &Scene) -> u64 {
    let falls = scene.laws.pocket != PocketLaw::Capture && !scene.table.pockets.is_empty();
    let (balls, time) = (scene.balls.len() as f64, scene.time_limit);
    let in_pockets = if falls { 6000.0 * balls * time } else { 0.0 };
    2000 + (3000.0 * balls * (1.0 + time) + in_pockets) as u64
}

fn judge(seen: &Worst, most: u64) -> Result<(), String> {
    let bad = [
        ("energy rises", seen.energy, ENERGY),
        ("momentum is lost", seen.momentum, MOMENTUM),
        ("balls overlap", seen.overlap, OVERLAP),
        ("a cushion is overlapped", seen.cushion, OVERLAP),
        ("time goes back", seen.back, 0.0),
        ("balls leave the table", f64::from(seen.left), 0.0),
        ("states are not finite", f64::from(seen.not_finite), 0.0),
        ("too many events", seen.events as f64, most as f64),
    ];
    for (what, value, allowed) in bad {
        if value > allowed || value.is_nan() {
            return Err(format!("{what}: {value:e}, allowed {allowed:e}; {seen:?}"));
        }
    }
    Ok(())
}

/// Plays a scene by the exact solver under audit, and returns the number of events.
pub fn exact(scene: &Scene) -> Result<u64, String> {
    let mut scene = scene.clone();
    scene.solver = Solver::Exact;
    let most = most_events(&scene);
    let stopped = |error: masse::physics::exact::SolveError| format!("exact: {error}");
    let mut engine = Engine::new(&scene, Limits { events: most }).map_err(stopped)?;
    let mut audit = Audit::new(&scene);
    if let Some(planned) = &scene.shot {
        engine
            .strike(planned.ball, &scene.cue, &planned.shot, &mut audit)
            .map_err(stopped)?;
    }
    engine
        .advance(scene.time_limit, &mut audit)
        .map_err(stopped)?;
    let seen = audit.worst();
    judge(&seen, most).map_err(|what| format!("exact: {what}"))?;
    Ok(seen.events)
}

/// Plays a scene by the stepped solver and audits the record.
pub fn stepped(scene: &Scene, tick: f64) -> Result<u64, String> {
    let mut scene = scene.clone();
    scene.solver = Solver::Stepped(Stepped {
        tick,
        ..Stepped::default()
    });
    let most = most_events(&scene);
    let (record, _) = stepping::try_run_to_rest(&scene)
        .map_err(|failed| format!("stepped at {} s: {}", failed.time, failed.reason))?;
    let seen = Audit::of(&scene, &record);
    judge(&seen, most).map_err(|what| format!("stepped: {what}"))?;
    Ok(seen.events)
}

/// It was blind once for whatever began with a stroke at a table at rest.
#[test]
fn the_audit_sees_energy_that_comes_from_nowhere_after_a_stroke() {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let cue = scene.place("cue", Ball::POOL, -0.5, 0.0);
    scene.place("1", Ball::POOL, 0.5, 0.1);
    let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
    let mut audit = Audit::new(&scene);
    engine
        .strike(cue, &scene.cue, &Shot::default(), &mut audit)
        .expect("a sound shot");
    engine.advance(0.05, &mut audit).expect("nothing is met");
    assert!(audit.worst().energy <= ENERGY, "{:?}", audit.worst());
    let before = engine.state(cue);
    let mut after = before;
    after.velocity *= 2.0;
    let piece = scene.laws.piece(&scene.table, &Ball::POOL, &after);
    audit.piece(cue, &PathPiece { time: 0.05, piece });
    let (from, to) = (before.motion, after.motion);
    audit.event(&Event {
        time: 0.05,
        kind: EventKind::Motion { from, to },
        first: Participant {
            ball: cue,
            before,
            after,
        },
        second: None,
        impulse: 0.0,
    });
    assert!(audit.worst().energy > 0.5, "{:?}", audit.worst());
}
