//! The model of the coursework report, judged like every other: what it gets wrong, and by how much.
//!
//! Its own formulas are in [`crate::physics::laws::coursework`]; here they run with the rates of the scene files, unless a
//! row says otherwise. Expected values are the exact solver's.

use glam::DVec3;

use crate::physics::ball::{Motion, State};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::Friction;
use crate::physics::laws::coursework::Coursework;
use crate::physics::scene::{Solver, Stepped};
use crate::report::judge::experiments::{
    oblique_speeds, settled_normal, square_ratio, throw_points,
};
use crate::report::judge::measurements::{FROZEN_PAIR, MATHAVAN_2010, THREE_CUSHION_SETTLED};
use crate::report::judge::stand::{Stand, cut_line, room, rough, smooth, turn};
use crate::report::judge::{Family, Measure, Row, Work};
use crate::sim::play::{Stopped, play};

pub(super) const ALL: &[Family] = &[
    ("C1 drag", Work::Shots(drag)),
    ("C2 spin", Work::Laws(spin)),
    ("C3 collision", Work::Laws(collision)),
    ("C4 overlap", Work::Shots(overlap)),
    ("C5 english", Work::Laws(english)),
    ("experiments", Work::Laws(experiments)),
];

const LAW: &str = "Coursework";

/// A tick of the coursework program, s.
const TICK: f64 = 1.0 / 120.0;

/// One per cent: what a player would not see.
const CLOSE: (Measure, f64) = (Measure::Relative, 0.01);

fn row(name: &str, expected: f64, ours: f64, unit: &'static str) -> Row {
    Row::measured(name, LAW, expected, ours, unit, CLOSE).by("exact solver; 1 % taken")
}

fn angle(name: &str, expected: f64, ours: f64) -> Row {
    Row::measured(name, LAW, expected, ours, "°", (Measure::Absolute, 0.5))
        .by("exact solver; half a degree taken")
}

/// Moves a ball by the model for this time in s.
fn later(model: &Coursework, start: &State, time: f64) -> State {
    let mut state = *start;
    let ticks = libm::round(time / TICK) as u32;
    for _ in 0..ticks {
        state.position += state.velocity * TICK;
        state = model.rub(&Stand::POOL.ball, &state, TICK);
    }
    state
}

/// What the model makes of a ball after a hit or a bounce in the time in which cloth would make it roll; in the model it
/// never settles.
pub(super) fn when_it_should_roll(start: &State) -> State {
    let stand = Stand::POOL;
    let start = stand.motion().classify(&stand.ball, *start);
    if start.motion == Motion::Sliding {
        let time = stand.motion().piece(&stand.ball, &start).duration;
        later(&Coursework::default(), &start, time)
    } else {
        start
    }
}

/// C1: linear drag, with the rate at which the whole path of a 2 m/s shot comes out right.
fn drag() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let mut scene = stand.room(smooth(1.0));
    scene.place("cue", stand.ball, 0.0, 0.0);
    scene.balls[0].state.velocity.x = 2.0;
    let record = play(&scene)?;
    let path = record.end[0].position.x;
    let model = Coursework {
        drag: 2.0 / path,
        spin_drag: 2.0 / path,
        coupling: 0.0,
        push: 0.0,
        english: 0.0,
        rest_below: 0.0,
    };
    let start = stand.stunned(2.0);
    let fitted = "drag fitted to the whole path of a 2 m/s shot";
    let mut rows = Vec::new();
    let slide = record.events.first().map_or(f64::NAN, |event| event.time);
    rows.push(row(
        &format!("C1 {fitted}: speed after {slide:.3} s"),
        record.state_at(0, slide).velocity.x,
        later(&model, &start, slide).velocity.x,
        "m/s",
    ));
    for distance in [1.27, 2.54] {
        let real = first_time(|time| record.state_at(0, time).position.x >= distance);
        let model = first_time(|time| later(&model, &start, time).position.x >= distance);
        rows.push(row(
            &format!("C1 {fitted}: time over {distance} m"),
            real,
            model,
            "s",
        ));
    }
    rows.push(
        Row::measured(
            &format!("C1 {fitted}: speed when it should rest"),
            LAW,
            0.0,
            later(&model, &start, record.end_time).velocity.x,
            "m/s",
            (Measure::Absolute, 0.005),
        )
        .by("exact solver; 5 mm/s taken")
        .because("Linear drag is exponential decay: the ball starts too slow to slow down, then never stops. There is no slide."),
    );
    let whole = later(&Coursework::default(), &start, 60.0);
    rows.push(
        row("C1 rates of the scene files: whole path at 2 m/s", path, whole.position.x, "m")
            .because("A rate in 1/s gives a path in proportion to the speed; on cloth it grows with the square."),
    );
    Ok(rows)
}

/// The first tick at which something holds, up to a minute, in s.
fn first_time(holds: impl Fn(f64) -> bool) -> f64 {
    (0..7200)
        .map(|tick| f64::from(tick) * TICK)
        .find(|time| holds(*time))
        .unwrap_or(f64::NAN)
}

/// C2: friction in proportion to spin.
fn spin() -> Vec<Row> {
    let stand = Stand::POOL;
    let model = Coursework::default();
    let roll = stand.rolling(2.0, 1.0);
    let hit = |cut: f64| {
        let after = stand.hit(&smooth(1.0), &roll, cut).first;
        stand.motion().classify(&stand.ball, after)
    };
    let square = hit(0.0);
    let settled = stand.settled(&square).velocity.x;
    let time = stand.motion().piece(&stand.ball, &square).duration;
    let why = "Sliding friction has the fixed size μ m g for a set time; a push in proportion to the spin is too weak at first and \
               never ends.";
    let mut rows = vec![
        row(
            &format!("C2 square hit by a roll at 2 m/s: cue ball after {time:.3} s"),
            settled,
            later(&model, &square, time).velocity.x,
            "m/s",
        )
        .because(why),
    ];
    let half = hit(f64::to_radians(30.0));
    let real = stand.motion().advance(&stand.ball, &half, 1.0);
    let ours = later(&model, &half, 1.0);
    let slid = stand.settled(&half);
    let ours_then = when_it_should_roll(&half);
    rows.push(angle(
        "C2 half-ball hit by a roll at 2 m/s: cue ball, once it should roll, goes at",
        -turn(DVec3::X, slid.velocity).to_degrees(),
        -turn(DVec3::X, ours_then.velocity).to_degrees(),
    ));
    rows.push(
        Row::measured(
            "C2 half-ball hit by a roll at 2 m/s: cue ball out of place after 1 s",
            LAW,
            0.0,
            (real.position - ours.position).length(),
            "m",
            (Measure::Absolute, 0.01),
        )
        .by("exact solver; 1 cm taken")
        .because("So there is no 30° rule: the cue ball stays near the tangent line where friction should bend it forward."),
    );
    rows
}

/// C3: no restitution, no friction between balls.
fn collision() -> Vec<Row> {
    let stand = Stand::POOL;
    let (real, model) = (rough(0.95, Friction::MARLOW), Laws::coursework().ball_ball);
    let stun = stand.stunned(2.0);
    let left = |law| stand.hit(law, &stun, 0.0).first.velocity.x;
    let half = f64::to_radians(30.0);
    let thrown = |law| stand.throw(law, &stun, half).to_degrees();
    let side = stand.moving(
        DVec3::X * 0.447,
        DVec3::Y * (0.625 * 0.447 / stand.ball.radius),
    );
    let passed =
        |law| -stand.hit(law, &side, 0.0).second.angular_velocity.y / side.angular_velocity.y;
    let cut = |law| stand.hit(law, &stun, 0.0).second.velocity.x;
    vec![
        row("C3 square stun at 2 m/s: object ball", cut(&real), cut(&model), "m/s"),
        row("C3 square stun at 2 m/s: cue ball", left(&real), left(&model), "m/s"),
        angle("C3 half-ball stun at 2 m/s: throw", thrown(&real), thrown(&model)),
        row("C3 straight with half english at 0.447 m/s: spin passed on", passed(&real), passed(&model), "")
            .because("Momentum alone, with neither restitution nor friction: right only for e 1 and smooth balls."),
    ]
}

/// C4: the normal taken where the tick left the balls, overlapped. Mean error of the direction of the object ball over a
/// hundred places at which a half-ball shot may start, each on its own lane of one room.
fn overlap() -> Result<Vec<Row>, Stopped> {
    const PLACES: u32 = 100;
    let stand = Stand::POOL;
    let half = f64::to_radians(30.0);
    let mut rows = Vec::new();
    for (tick, name, locate) in [
        (1.0 / 60.0, "1/60 s", false),
        (1.0 / 120.0, "1/120 s", false),
        (1e-3, "1/1000 s", false),
        (1.0 / 60.0, "1/60 s", true),
    ] {
        let mut scene = room(Laws::ideal());
        for place in 0..PLACES {
            let way = 2.0 * tick * (3.0 + f64::from(place) / f64::from(PLACES));
            let object = DVec3::X * way + 2.0 * stand.ball.radius * cut_line(half);
            let lane = f64::from(place) - 0.5 * f64::from(PLACES - 1);
            scene.place(&format!("cue {place}"), stand.ball, 0.0, lane);
            scene.place(&place.to_string(), stand.ball, object.x, lane + object.z);
        }
        for cue in scene.balls.iter_mut().step_by(2) {
            cue.state.velocity.x = 2.0;
        }
        scene.time_limit = 8.0 * tick;
        scene.solver = Solver::Stepped(Stepped {
            tick,
            locate,
            ..Stepped::default()
        });
        let (mut sum, mut most) = (0.0, 0.0_f64);
        for object in play(&scene)?.end.iter().skip(1).step_by(2) {
            let error = turn(cut_line(half), object.velocity).abs().to_degrees();
            sum += error;
            most = most.max(error);
        }
        let mean = sum / f64::from(PLACES);
        let how = if locate {
            "contact located in the tick"
        } else {
            "normal at the overlap"
        };
        let name = format!("C4 half-ball at 2 m/s, tick {name}, {how}: direction out by");
        let mut row = angle(&name, 0.0, mean);
        row.note = Some(format!(
            "The worst of {PLACES} places to start from is out by {most:.2}°."
        ));
        if locate {
            "Stepped solver".clone_into(&mut row.law);
        }
        rows.push(row);
    }
    Ok(rows)
}

/// C5: english turns the velocity.
fn english() -> Vec<Row> {
    let stand = Stand::POOL;
    let spin = DVec3::Y * (1.25 * 2.0 / stand.ball.radius);
    let start = stand.moving(DVec3::X * 2.0, spin);
    let turned = turn(
        DVec3::X,
        later(&Coursework::default(), &start, 1.0).velocity,
    )
    .to_degrees();
    let real = stand.motion().advance(&stand.ball, &start, 1.0);
    let across = stand.moving(DVec3::X, DVec3::Y / stand.ball.radius);
    let off = |law| {
        turn(-DVec3::X, stand.rebound(law, &across, 0.0).velocity)
            .abs()
            .to_degrees()
    };
    let (law, model) = (Laws::default().cushion, Laws::coursework().cushion);
    vec![
        angle(
            "C5 most english at 2 m/s, level cue: path turns in 1 s by",
            turn(DVec3::X, real.velocity).to_degrees(),
            turned,
        ),
        angle("C5 square into a cushion, R ω = v of side: leaves off the normal at", off(&law), off(&model))
            .because("Side spin leaves the open path straight but for squirt; its work is done at the cushion and in throw."),
    ]
}

/// The experiments, with the collisions of the model.
fn experiments() -> Vec<Row> {
    let laws = Laws::coursework();
    let stand = Stand::POOL;
    let angles: Vec<(f64, f64)> = FROZEN_PAIR
        .into_iter()
        .map(|(cut_deg, measured)| {
            // The cue sends the ball along its own line; then the two collide.
            let cut = f64::to_radians(cut_deg);
            let velocity = stand
                .hit(&laws.ball_ball, &stand.stunned(1.0), cut)
                .first
                .velocity;
            (measured, turn(cut_line(cut), velocity).abs().to_degrees())
        })
        .collect();
    let slow: Vec<(f64, f64)> = MATHAVAN_2010
        .into_iter()
        .filter(|(speed, _)| *speed < 1.5)
        .map(|(speed, after)| {
            (
                after / speed,
                square_ratio(&Stand::SNOOKER, &laws.cushion, speed),
            )
        })
        .collect();
    let (normal_speed, ratio) = THREE_CUSHION_SETTLED;
    let settled = settled_normal(&Stand::CAROM, &laws.cushion, normal_speed, 0.0);
    vec![
        Row::points(
            "E2 oblique hits, snooker: settled speeds, with our cloth",
            LAW,
            &oblique_speeds(&laws.ball_ball),
            "m/s",
            (Measure::RelativeRms, 0.06),
        )
        .by("Mathavan et al. 2009, table I; restitution 0.89 as measured there"),
        Row::points(
            "E3 square roll below 1.5 m/s, snooker: speed ratio",
            LAW,
            &slow,
            "",
            (Measure::RelativeRms, 0.025),
        )
        .by("Mathavan et al. 2010, fig. 7a"),
        Row::points(
            "E5 throw of a rolling ball",
            LAW,
            &throw_points(&laws.ball_ball),
            "°",
            (Measure::Rms, 0.7),
        )
        .by("Domenech 2023"),
        Row::points(
            "E7 frozen pair: cue ball leaves at",
            LAW,
            &angles,
            "°",
            (Measure::Rms, 3.0),
        )
        .by("Alciatore, TP A.15"),
        Row::measured(
            "E10 square roll: settled normal ratio, with our cloth",
            LAW,
            ratio,
            settled,
            "",
            (Measure::Relative, 0.04),
        )
        .by("182 tracked three-cushion shots")
        .because(
            "Cushions and balls that lose nothing and do not rub: none of the experiments is met.",
        ),
    ]
}
