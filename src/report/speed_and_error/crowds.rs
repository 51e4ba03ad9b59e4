//! Many balls: what one of them costs, what the grid is worth, and whether the energy stays.

use std::time::{Duration, Instant};

use cpu_time::ProcessTime;

use crate::physics::ball::State;
use crate::physics::exact::Engine;
use crate::physics::exact::Limits;
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::report::speed_and_error::error::energy;
use crate::report::speed_and_error::many::gas;
use crate::report::speed_and_error::play::{self, SAMPLES, app, step};
use crate::report::speed_and_error::{Effort, Method};
use crate::sim::play::Stopped;
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
    // A tick of very many balls is long enough to be measured by itself.
    let ticks = if balls > 50_000 { WINDOW / 6 } else { WINDOW };
    let mut costs = Vec::new();
    for cloth in [false, true] {
        let scene = gas(balls, cloth, 0);
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
            tick(effort, &Method::Crowd(RATE).prepare(&scene), ticks)?,
        );
        if cloth {
            let mut rest = Method::Crowd(RATE).prepare(&scene);
            for ball in &mut rest.balls[1..] {
                ball.state = State::at_rest(ball.state.position);
            }
            add(
                "stepped, as a crowd, all but one at rest",
                tick(effort, &rest, ticks)?,
            );
        } else {
            add(
                "stepped, as a crowd in f32",
                tick(effort, &Method::Single(RATE).prepare(&scene), ticks)?,
            );
        }
        if balls <= 10_000 {
            let mut few = Method::Located(RATE).prepare(&scene);
            fit_grid(&mut few);
            add("stepped", tick(effort, &few, ticks)?);
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

/// Ticks that are measured: not more, because a gas on a cloth slows down, and what rests costs nothing.
const WINDOW: u32 = 60;

/// The cheapest of some rounds of the same work, in s: whatever else the machine does only adds.
fn cheapest(
    effort: &Effort,
    mut round: impl FnMut() -> Result<Duration, Stopped>,
) -> Result<f64, Stopped> {
    let (mut least, begun) = (Duration::MAX, Instant::now());
    loop {
        least = least.min(round()?);
        if begun.elapsed() > 2 * effort.budget {
            return Ok(least.as_secs_f64());
        }
    }
}

/// Processor time in s of a tick, over the first so many after some to warm up.
fn tick(effort: &Effort, scene: &Scene, ticks: u32) -> Result<f64, Stopped> {
    let whole = cheapest(effort, || {
        let mut app = app(scene);
        if scene.solver.is_crowd() {
            app.world_mut().resource_mut::<Crowd>().mirror = Mirror::WhenAsked;
        }
        step(&mut app, WARM_UP)?;
        let start = ProcessTime::now();
        step(&mut app, ticks)?;
        Ok(start.elapsed())
    })?;
    Ok(whole / f64::from(ticks))
}

/// The same stretch of time by the exact solver, which has no ticks.
fn exact(effort: &Effort, scene: &Scene) -> Result<f64, Stopped> {
    let mut scene = scene.clone();
    scene.solver = Solver::Exact;
    let at = |ticks: u32| f64::from(ticks) / f64::from(RATE);
    let whole = cheapest(effort, || {
        let mut engine = Engine::new(&scene, Limits::default())?;
        engine.advance(at(WARM_UP), &mut ())?;
        let start = ProcessTime::now();
        engine.advance(at(WARM_UP + WINDOW), &mut ())?;
        Ok(start.elapsed())
    })?;
    Ok(whole / f64::from(WINDOW))
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

/// Ticks that are measured for a grid.
const GRID_TICKS: u32 = 10;

/// Grids along which the coursework's experiment is repeated, cells along a side.
pub(super) const GRIDS: [u32; 12] = [5, 10, 15, 20, 30, 40, 50, 65, 80, 120, 180, 250];

/// The coursework's own experiment: frame time against the number of cells.
///
/// # Errors
/// [`Stopped`] if a solver cannot go on.
pub fn cost_of_grid(effort: &Effort, balls: u32, cells: u32) -> Result<Vec<GridCost>, Stopped> {
    let scene = gas(balls, false, 0);
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
            milliseconds: 1e3 * tick(effort, &scene, GRID_TICKS)?,
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
