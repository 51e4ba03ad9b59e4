//! Whole shots, event by event: the same sequence, and times and positions within the gates of the folder's README.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};
use serde::Deserialize;

use masse::physics::ball::{Ball, Motion, State};
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::{BallBallLaw, Friction, Frictional, Frictionless, PeerCap};
use masse::physics::laws::cushion::{CushionLaw, Inclination, Mirror, Stronge2018};
use masse::physics::laws::motion::{Cloth, MotionLaw};
use masse::physics::laws::pocket::PocketLaw;
use masse::physics::laws::slate::SlateLaw;
use masse::physics::record::{Event, EventKind};
use masse::physics::scene::{Scene, SceneBall, Solver};
use masse::physics::table::{Arc, Cushion, Line, Nose, Pocket, Table};

use super::{motion, state, text, vector};

#[derive(Deserialize)]
struct File {
    models: Models,
    ball_params: BTreeMap<String, Parameters>,
    tables: BTreeMap<String, PeerTable>,
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Models {
    ball_ball: BallBallModel,
    cushion: CushionModel,
}

#[derive(Deserialize)]
struct BallBallModel {
    model: String,
    friction: Option<Marlow>,
}

#[derive(Deserialize)]
struct Marlow {
    a: f64,
    b: f64,
    c: f64,
}

#[derive(Deserialize)]
struct CushionModel {
    model: String,
    omega_ratio: Option<f64>,
}

#[derive(Deserialize)]
struct Parameters {
    m: f64,
    #[serde(rename = "R")]
    radius: f64,
    u_s: f64,
    u_r: f64,
    u_sp: f64,
    e_b: f64,
    e_c: f64,
    f_c: f64,
    g: f64,
}

#[derive(Deserialize)]
struct PeerTable {
    w: f64,
    l: f64,
    linear: Vec<Linear>,
    circular: Vec<Circular>,
    pockets: Vec<Hole>,
}

#[derive(Deserialize)]
struct Linear {
    id: String,
    p1: Vec<f64>,
    p2: Vec<f64>,
    height: f64,
}

#[derive(Deserialize)]
struct Circular {
    id: String,
    center: Vec<f64>,
    radius: f64,
}

#[derive(Deserialize)]
struct Hole {
    id: String,
    center: Vec<f64>,
    radius: f64,
    depth: f64,
}

#[derive(Deserialize)]
struct Case {
    id: String,
    table: String,
    params: String,
    initial: BTreeMap<String, [f64; 10]>,
    events: Vec<PeerEvent>,
    robust_events: usize,
}

#[derive(Deserialize)]
struct PeerEvent {
    t: f64,
    #[serde(rename = "type")]
    kind: String,
    ids: Vec<String>,
    before: BTreeMap<String, [f64; 10]>,
}

impl PeerTable {
    /// Their table in our axes, its origin moved to the middle.
    fn middle(&self) -> DVec3 {
        DVec3::new(0.5 * self.l, 0.0, 0.5 * self.w)
    }

    fn plan(&self, theirs: &[f64]) -> DVec2 {
        let point = vector(theirs) - self.middle();
        DVec2::new(point.x, point.z)
    }

    fn table(&self) -> Table {
        let lines = self.linear.iter().map(|line| {
            Cushion::Line(Line {
                from: self.plan(&line.p1),
                to: self.plan(&line.p2),
            })
        });
        let arcs = self.circular.iter().map(|arc| {
            Cushion::Arc(Arc {
                center: self.plan(&arc.center),
                radius: arc.radius,
            })
        });
        Table {
            length: self.l,
            width: self.w,
            nose_height: self.linear[0].height,
            nose: Nose::Wall,
            cushions: lines.chain(arcs).collect(),
            pockets: self
                .pockets
                .iter()
                .map(|hole| Pocket {
                    name: hole.id.clone(),
                    center: self.plan(&hole.center),
                    radius: hole.radius,
                    depth: hole.depth,
                })
                .collect(),
        }
    }
}

impl File {
    fn laws(&self, parameters: &Parameters) -> Laws {
        let ball_ball = match self.models.ball_ball.model.as_str() {
            "frictionless_elastic" => BallBallLaw::Frictionless(Frictionless { restitution: 1.0 }),
            "frictional_inelastic" => {
                let friction = self
                    .models
                    .ball_ball
                    .friction
                    .as_ref()
                    .expect("its friction is given");
                BallBallLaw::PeerCap(PeerCap(Frictional {
                    restitution: parameters.e_b,
                    friction: Friction::Marlow {
                        a: friction.a,
                        b: friction.b,
                        c: friction.c,
                    },
                }))
            }
            other => panic!("no ball-ball model {other}"),
        };
        let cushion = match self.models.cushion.model.as_str() {
            "unrealistic" => CushionLaw::Mirror(Mirror {
                restitution: parameters.e_c.into(),
            }),
            "stronge_compliant" => CushionLaw::Stronge2018(Stronge2018 {
                restitution: parameters.e_c.into(),
                friction: parameters.f_c,
                frequency_ratio: self.models.cushion.omega_ratio.expect("its ratio is given"),
                inclination: Inclination::Peer,
            }),
            other => panic!("no cushion model {other}"),
        };
        Laws {
            motion: MotionLaw::Coulomb(Cloth {
                sliding: parameters.u_s,
                rolling: parameters.u_r,
                spin_deceleration: 2.5 * parameters.u_sp * parameters.g / parameters.radius,
                gravity: parameters.g,
            }),
            ball_ball,
            cushion,
            slate: SlateLaw::Held,
            pocket: PocketLaw::Capture,
        }
    }

    fn scene(&self, case: &Case) -> Scene {
        let (table, parameters) = (&self.tables[&case.table], &self.ball_params[&case.params]);
        let mut scene = Scene::new(table.table(), self.laws(parameters));
        scene.solver = Solver::Exact;
        scene.time_limit = 1000.0;
        for (name, theirs) in &case.initial {
            scene.balls.push(SceneBall {
                name: name.clone(),
                ball: Ball {
                    mass: parameters.m,
                    radius: parameters.radius,
                    spins: true,
                },
                state: table_state(table, theirs),
            });
        }
        scene
    }
}

fn table_state(table: &PeerTable, theirs: &[f64; 10]) -> State {
    let mut ours = state(&theirs[..9].try_into().expect("nine numbers"));
    ours.position -= table.middle();
    ours.motion = motion(theirs[9] as u8);
    ours
}

/// What happened to whom, and when and where.
#[derive(Clone, Debug)]
struct Entry {
    time: f64,
    what: String,
    at: Vec<DVec3>,
}

fn ours(event: &Event, scene: &Scene, table: &PeerTable) -> Option<Entry> {
    let name = |ball: usize| scene.balls[ball].name.clone();
    let first = name(event.first.ball);
    let mut who: Vec<(String, DVec3)> = event
        .participants()
        .map(|participant| (name(participant.ball), participant.before.position))
        .collect();
    who.sort_by(|a, b| a.0.cmp(&b.0));
    let what = match event.kind {
        EventKind::BallBall => format!("ball_ball {} {}", who[0].0, who[1].0),
        EventKind::Cushion { cushion } => match table.linear.get(cushion) {
            Some(line) => format!("ball_linear_cushion {first} {}", line.id),
            None => format!(
                "ball_circular_cushion {first} {}",
                table.circular[cushion - table.linear.len()].id
            ),
        },
        EventKind::Pocketed { pocket } => {
            format!("ball_pocket {first} {}", table.pockets[pocket].id)
        }
        EventKind::Motion { from, to } => {
            let label = |motion| match motion {
                Motion::Sliding => "sliding",
                Motion::Rolling => "rolling",
                Motion::Spinning => "spinning",
                _ => "stationary",
            };
            format!("{}_{} {first}", label(from), label(to))
        }
        _ => return None,
    };
    Some(Entry {
        time: event.time,
        what,
        at: who.into_iter().map(|(_, position)| position).collect(),
    })
}

fn theirs(event: &PeerEvent, table: &PeerTable) -> Entry {
    let mut ids = event.ids.clone();
    if event.kind == "ball_ball" {
        ids.sort();
    }
    Entry {
        time: event.t,
        what: format!("{} {}", event.kind, ids.join(" ")),
        at: event
            .before
            .values()
            .map(|state| vector(&state[..3]) - table.middle())
            .collect(),
    }
}

/// A slide that lasts less than this in s is rounding of a rolling start, and one engine sees it, the other does not.
const NO_SLIDE: f64 = 1e-12;

/// Sorts by name inside runs of events closer than 1e-9 s: their order there is arbitrary.
fn settle_ties(lines: &mut [Entry]) {
    let mut start = 0;
    for i in 1..=lines.len() {
        if i == lines.len() || lines[i].time - lines[i - 1].time > 1e-9 {
            lines[start..i].sort_by(|a, b| a.what.cmp(&b.what));
            start = i;
        }
    }
}

fn compare(name: &str, gate: f64) {
    let file: File =
        serde_json::from_str(&text(name)).expect("the file has the format of its README");
    let (mut count, mut worst_time, mut worst_place) = (0, 0.0_f64, 0.0_f64);
    for case in &file.cases {
        let scene = file.scene(case);
        let table = &file.tables[&case.table];
        let record =
            solve(&scene, Limits::default()).unwrap_or_else(|error| panic!("{}: {error}", case.id));
        let mut mine: Vec<Entry> = record
            .events
            .iter()
            .filter_map(|event| ours(event, &scene, table))
            .collect();
        let mut peer: Vec<Entry> = case
            .events
            .iter()
            .map(|event| theirs(event, table))
            .collect();
        for list in [&mut mine, &mut peer] {
            list.retain(|entry| {
                entry.time > NO_SLIDE || !entry.what.starts_with("sliding_rolling")
            });
        }
        settle_ties(&mut mine);
        settle_ties(&mut peer);
        for (i, peer) in peer.iter().take(case.robust_events).enumerate() {
            let mine = mine
                .get(i)
                .unwrap_or_else(|| panic!("{} event {i}: nothing, expected {peer:?}", case.id));
            assert_eq!(
                mine.what, peer.what,
                "{} event {i}: {mine:?}, expected {peer:?}",
                case.id
            );
            let late = (mine.time - peer.time).abs();
            let off = mine
                .at
                .iter()
                .zip(&peer.at)
                .map(|(a, b)| (*a - *b).length())
                .fold(0.0, f64::max);
            assert!(
                late < gate && off < gate,
                "{} event {i} {}: {late:e} s, {off:e} m off",
                case.id,
                mine.what
            );
            worst_time = worst_time.max(late);
            worst_place = worst_place.max(off);
            count += 1;
        }
    }
    println!("{name}: {count} events alike, at most {worst_time:e} s and {worst_place:e} m apart");
    assert!(count > 0, "{name} holds no events");
}

#[test]
fn reference_shots_elastic_two_ball() {
    compare("elastic_two_ball.json", 1e-6);
}

#[test]
fn reference_shots_elastic_cushion() {
    compare("elastic_cushion.json", 1e-6);
}

#[test]
fn reference_shots_elastic_multi() {
    compare("elastic_multi.json", 1e-4);
}

#[test]
fn reference_shots_default_two_ball() {
    compare("default_two_ball.json", 1e-6);
}

#[test]
fn reference_shots_default_cushion() {
    compare("default_cushion.json", 1e-6);
}

#[test]
fn reference_shots_default_multi() {
    compare("default_multi.json", 1e-4);
}
