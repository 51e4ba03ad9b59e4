//! Many balls: what one of them costs, what the grid is worth, and whether the energy stays.

use std::time::Instant;

use cpu_time::ProcessTime;

use crate::physics::exact::Engine;
use crate::physics::exact::Limits;
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::report::judge::Stopped;
use crate::report::speed_and_error::error::energy;
use crate::report::speed_and_error::ladder::gas;
use crate::report::speed_and_error::play::{self, SAMPLES, app, step};
use crate::report::speed_and_error::{Effort, Method};
use crate::sim::stepped::crowd::{Crowd, Mirror};
use crate::sim::stepping;

/// Ticks a second of the comparison by numbers of balls.
const RATE: u32 = 120;
/// Ticks before anything is measured.
const WARM_UP: u32 = 5;

/// Processor time a ball and 1/120 s.
#[derive(Clone, Debug, PartialEq)]
pub struct CrowdCost {
    /// Which solver, and with or without cloth.
    pub what: String,
    /// Balls.
    pub balls: u32,
    /// Nanoseconds a ball and 1/120 s.
    pub nanoseconds: f64,
}

/// Balls from a hundred up, by powers of the square root of ten.
pub(super) fn counts(most: u32) -> Vec<u32> {
    [
        100, 316, 1_000, 3_162, 10_000, 31_623, 100_000, 316_228, 1_000_000,
    ]
    .into_iter()
    .filter(|count| *count <= most)
    .collect()
}

/// What a ball costs with this many of them, for each solver that is meant for as many.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
pub fn cost_of_crowd(effort: &Effort, balls: u32) -> Result<Vec<CrowdCost>, Stopped> {
    let mut costs = Vec::new();
    for cloth in [false, true] {
        let scene = gas(balls, cloth);
        let floor = if cloth {
            "with cloth and spin"
        } else {
            "without friction"
        };
        let mut add = |what: &str, seconds: f64| {
            costs.push(CrowdCost {
                what: format!("{what}, {floor}"),
                balls,
                nanoseconds: 1e9 * seconds / f64::from(balls),
            });
        };
        add(
            "stepped, as a crowd",
            tick(effort, &Method::Crowd(RATE).prepare(&scene))?,
        );
        if balls <= 10_000 {
            let mut few = Method::Located(RATE).prepare(&scene);
            fit_grid(&mut few);
            add("stepped", tick(effort, &few)?);
            add("exact", exact(effort, &scene)?);
        }
    }
    Ok(costs)
}

/// Cells of about a diameter.
fn fit_grid(scene: &mut Scene) {
    if let Solver::Stepped(stepped) = &mut scene.solver {
        let cells = (scene.table.length / (2.0 * scene.balls[0].ball.radius))
            .floor()
            .clamp(1.0, 1000.0);
        stepped.grid = Some((cells as u32, cells as u32));
    }
}

/// Processor time in s of a tick: of the cheapest stretch of ticks, so that a stretch in which the machine did something
/// else does not count.
fn tick(effort: &Effort, scene: &Scene) -> Result<f64, Stopped> {
    let mut app = app(scene);
    if scene.solver.is_crowd() {
        app.world_mut().resource_mut::<Crowd>().mirror = Mirror::WhenAsked;
    }
    step(&mut app, WARM_UP)?;
    let stretch = (20_000 / scene.balls.len() as u32).clamp(1, 20);
    let (mut least, begun) = (f64::INFINITY, Instant::now());
    for stretches in 0.. {
        if stretches >= 3 && begun.elapsed() > 3 * effort.budget {
            break;
        }
        let start = ProcessTime::now();
        step(&mut app, stretch)?;
        least = least.min(start.elapsed().as_secs_f64() / f64::from(stretch));
    }
    Ok(least)
}

/// The same for the exact solver, which has no ticks: 1/120 s.
fn exact(effort: &Effort, scene: &Scene) -> Result<f64, Stopped> {
    let mut scene = scene.clone();
    scene.solver = Solver::Exact;
    let mut engine = Engine::new(&scene, Limits::default())?;
    let span = 1.0 / f64::from(RATE);
    let (mut until, begun) = (4.0 * span, Instant::now());
    engine.advance(until, &mut ())?;
    let mut costs = Vec::new();
    while costs.len() < 3 || (begun.elapsed() < 3 * effort.budget && costs.len() < 60) {
        until += span;
        let start = ProcessTime::now();
        engine.advance(until, &mut ())?;
        costs.push(start.elapsed().as_secs_f64());
    }
    costs.sort_by(f64::total_cmp);
    // Each 1/120 s has other events: the one in the middle is fair.
    Ok(costs[costs.len() / 2])
}

/// Processor time of a tick with a grid of this many cells.
#[derive(Clone, Debug, PartialEq)]
pub struct GridCost {
    /// Which way to step.
    pub what: &'static str,
    /// Cells along each side.
    pub cells: u32,
    /// Side of a cell in m.
    pub side: f64,
    /// Side of a cell in diameters of a ball.
    pub diameters: f64,
    /// Milliseconds a tick.
    pub milliseconds: f64,
}

/// Grids along which the coursework's experiment is repeated, cells along a side.
pub(super) const GRIDS: [u32; 12] = [5, 10, 15, 20, 30, 40, 50, 65, 80, 120, 180, 250];

/// The coursework's own experiment: frame time against the number of cells.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
pub fn cost_of_grid(effort: &Effort, balls: u32, cells: u32) -> Result<Vec<GridCost>, Stopped> {
    let scene = gas(balls, false);
    let ways = [
        (
            "the coursework's way, 1/60 s",
            Stepped {
                tick: 1.0 / 60.0,
                locate: false,
                ..Stepped::default()
            },
        ),
        (
            "contacts located, 1/60 s",
            Stepped {
                tick: 1.0 / 60.0,
                ..Stepped::default()
            },
        ),
        (
            "as a crowd, 1/60 s",
            Stepped {
                tick: 1.0 / 60.0,
                crowd: true,
                ..Stepped::default()
            },
        ),
    ];
    let mut costs = Vec::new();
    for (what, stepped) in ways {
        let mut scene = scene.clone();
        scene.solver = Solver::Stepped(Stepped {
            grid: Some((cells, cells)),
            ..stepped
        });
        let side = scene.table.length / f64::from(cells);
        costs.push(GridCost {
            what,
            cells,
            side,
            diameters: side / (2.0 * scene.balls[0].ball.radius),
            milliseconds: 1e3 * tick(effort, &scene)?,
        });
    }
    Ok(costs)
}

/// How far the energy of a method is off over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Drift {
    /// The scene.
    pub scene: String,
    /// The method.
    pub method: Method,
    /// Time in s, and the difference of the energy from what it should be as a part of that at the start.
    pub points: Vec<(f64, f64)>,
}

/// Follows the energy of a scene. Without friction it should stay, with friction it should be that of the exact solver.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
pub fn drift(
    name: &str,
    scene: &Scene,
    methods: &[Method],
    samples: usize,
) -> Result<Vec<Drift>, Stopped> {
    let mut expected = Vec::new();
    let mut drifts = Vec::new();
    for &method in std::iter::once(&Method::Exact).chain(methods) {
        let energies = energies(method, scene, samples)?;
        if method == Method::Exact {
            expected.clone_from(&energies);
        }
        let whole = expected[0];
        let lossless = scene.laws.motion == crate::physics::laws::motion::MotionLaw::Frictionless;
        let off = |sample: usize, energy: f64| {
            let should = if lossless { whole } else { expected[sample] };
            (
                play::sample_time(sample) - 1.0 / f64::from(SAMPLES),
                (energy - should) / whole,
            )
        };
        drifts.push(Drift {
            scene: name.to_owned(),
            method,
            points: energies
                .iter()
                .enumerate()
                .map(|(i, energy)| off(i, *energy))
                .collect(),
        });
    }
    Ok(drifts)
}

/// Energy in J at the start and at each common time.
fn energies(method: Method, scene: &Scene, samples: usize) -> Result<Vec<f64>, Stopped> {
    let scene = method.prepare(scene);
    let start: Vec<_> = scene.balls.iter().map(|ball| ball.state).collect();
    let mut energies = vec![energy(&scene, &start)];
    let Some(rate) = method.rate() else {
        let mut engine = Engine::new(&scene, Limits { events: u64::MAX })?;
        for sample in 0..samples {
            engine.advance(play::sample_time(sample), &mut ())?;
            let states: Vec<_> = (0..engine.count()).map(|ball| engine.state(ball)).collect();
            energies.push(energy(&scene, &states));
        }
        return Ok(energies);
    };
    let mut app = app(&scene);
    for _ in 0..samples {
        step(&mut app, rate / SAMPLES)?;
        energies.push(energy(&scene, &stepping::states(&mut app)));
    }
    Ok(energies)
}
