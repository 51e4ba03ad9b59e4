//! The scenes, from one ball to thousands.

use glam::DVec3;

use crate::physics::ball::Ball;
use crate::physics::laws::Laws;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::scene::{Rack, Scene, Solver};
use crate::physics::table::Preset;
use crate::report::speed_and_error::many::{self, gas};
use crate::report::speed_and_error::{BOARD, DAM, Effort, Method, Named};

/// The coursework report's own number of balls.
pub(super) const COURSEWORK_BALLS: u32 = 5750;

/// The gas of this many balls, or the largest crowd asked for.
pub(super) const GAS: &str = "gas";
/// The scene of which energy is followed beside the gas.
pub(super) const LOOSE: &str = "five-loose-balls";

/// A break of balls that do not touch before: impacts come one after another. The break of the library has a frozen rack,
/// whose contacts are resolved together.
pub(super) const LOOSENED: &str = "loosened-break";

/// One scene, started in several places so that the tick falls anywhere around its contacts.
#[derive(Clone, Debug)]
pub struct Rung {
    /// What it is called, in tables and after `--scene`.
    pub name: String,
    /// What happens in it.
    pub title: String,
    /// The starts.
    pub starts: Vec<Scene>,
    /// Whether nothing in it amplifies errors much, so that a method has an order that can be asked for.
    pub gentle: bool,
    /// Whether a crowd can play it: smooth balls, all alike.
    pub crowded: bool,
    /// Most ticks a second that are played of a stepped method.
    pub finest: u32,
}

impl Rung {
    fn new(name: &str, title: &str, starts: Vec<Scene>) -> Self {
        Self {
            name: name.to_owned(),
            title: title.to_owned(),
            starts,
            gentle: false,
            crowded: false,
            finest: u32::MAX,
        }
    }

    /// The methods that can play it.
    #[must_use]
    pub fn methods(&self, effort: &Effort) -> Vec<Method> {
        let rates = || effort.rates.iter().copied();
        let general = || rates().filter(|rate| *rate <= self.finest);
        let mut methods = vec![Method::Exact];
        methods.extend(general().map(Method::Located));
        if self.crowded {
            methods.extend(rates().map(Method::Crowd));
            methods.extend(rates().map(Method::Single));
        }
        methods.extend(general().map(Method::Plain));
        let has_cloth = |scene: &Scene| {
            !matches!(
                scene.laws.motion,
                MotionLaw::Frictionless | MotionLaw::Inclined(_)
            )
        };
        if self.starts.iter().any(has_cloth) {
            methods.extend(general().map(Method::Coursework));
        }
        methods
    }
}

/// Every scene of the ladder; `library` holds built-in scenes that belong to it.
pub(super) fn ladder(effort: &Effort, library: &[Named]) -> Vec<Rung> {
    let several = |start: &dyn Fn(f64) -> Scene| {
        let share = |i: u32| f64::from(i) / f64::from(effort.starts);
        (0..effort.starts)
            .map(|i| start(share(i)))
            .collect::<Vec<_>>()
    };
    let mut rungs = vec![
        Rung {
            gentle: true,
            ..Rung::new(
                "slide-and-roll",
                "One ball slides with side and draw, rolls, rests",
                several(&lone),
            )
        },
        Rung {
            gentle: true,
            ..Rung::new(
                "two-ball-cuts",
                "One ball cuts another by 10 to 65 degrees",
                several(&cut),
            )
        },
        Rung {
            gentle: true,
            ..Rung::new(
                "three-cushions",
                "One ball with running english meets three cushions",
                several(&cushions),
            )
        },
        Rung::new(LOOSE, "One ball runs into five loose ones", several(&loose)),
    ];
    rungs.push(Rung::new(
        LOOSENED,
        "Nine-ball break, a tenth of a millimetre between the balls of the rack",
        several(&loosened),
    ));
    rungs.extend(library.iter().map(|named| of_library(named, effort)));
    let count = COURSEWORK_BALLS.min(effort.most_balls);
    let mut scene = gas(count, false, 0);
    scene.time_limit = if effort.quick { 0.2 } else { 0.5 };
    rungs.push(Rung {
        crowded: true,
        // Each tick the general solver notes where every ball is.
        finest: 960,
        ..Rung::new(
            GAS,
            &format!("{count} balls without friction in a closed box"),
            vec![scene],
        )
    });
    rungs
}

/// What a built-in scene is measured with.
fn of_library(named: &Named, effort: &Effort) -> Rung {
    let mut scene = named.scene.clone();
    match named.name.as_str() {
        BOARD => {
            let starts = (0..effort.starts as usize).map(|ball| many::alone(&scene, ball));
            Rung::new(BOARD, "One ball runs down a Galton board", starts.collect())
        }
        DAM => Rung {
            crowded: true,
            // As for the gas.
            finest: 240,
            ..Rung::new(
                DAM,
                "Three thousand balls let go on a tilted table",
                vec![many::let_go(&scene, 0)],
            )
        },
        name => {
            if matches!(scene.laws.motion, MotionLaw::Coursework(_)) {
                // The same start on a real table: what the model should have said.
                scene.laws = Laws::default();
            }
            scene.solver = Solver::Exact;
            Rung::new(name, &named.title, vec![scene])
        }
    }
}

fn moving(scene: &mut Scene, ball: usize, velocity: DVec3, spin: DVec3) {
    let state = &mut scene.balls[ball].state;
    state.velocity = velocity;
    state.angular_velocity = spin;
}

fn on(table: Preset) -> Scene {
    let mut scene = Scene::new(table.table(), Laws::default());
    scene.time_limit = 3.0;
    scene
}

/// A large floor: no cushion comes into play.
const FLOOR: Preset = Preset::Box {
    length: 20.0,
    width: 20.0,
};

fn lone(share: f64) -> Scene {
    let mut scene = on(FLOOR);
    let ball = scene.place("cue", Ball::POOL, 0.0, 0.0);
    let spin = DVec3::new(20.0 + 20.0 * share, 30.0, 60.0);
    moving(&mut scene, ball, DVec3::X * (1.0 + share), spin);
    scene.time_limit = 12.0;
    scene
}

fn cut(share: f64) -> Scene {
    let mut scene = on(FLOOR);
    let angle = (10.0 + 55.0 * share).to_radians();
    let reach = 2.0 * Ball::POOL.radius;
    let ball = scene.place("cue", Ball::POOL, -0.3 - 0.05 * share, 0.0);
    scene.place(
        "1",
        Ball::POOL,
        reach * libm::cos(angle),
        reach * libm::sin(angle),
    );
    moving(
        &mut scene,
        ball,
        DVec3::X * 2.0,
        DVec3::new(0.0, 20.0, -30.0),
    );
    scene
}

fn cushions(share: f64) -> Scene {
    let mut scene = on(Preset::Carom);
    let ball = scene.place("white", Ball::POOL, -1.0 + 0.1 * share, 0.3);
    moving(
        &mut scene,
        ball,
        DVec3::new(2.6, 0.0, -1.8),
        DVec3::new(-40.0, 35.0, -60.0),
    );
    scene.time_limit = 4.0;
    scene
}

fn loose(share: f64) -> Scene {
    let mut scene = on(Preset::Carom);
    let ball = scene.place("white", Ball::POOL, -0.9 - 0.05 * share, 0.02);
    for (name, x, z) in [
        ("1", 0.0, 0.0),
        ("2", 0.25, 0.12),
        ("3", 0.3, -0.1),
        ("4", 0.55, 0.25),
        ("5", 0.6, -0.3),
    ] {
        scene.place(name, Ball::POOL, x, z);
    }
    moving(
        &mut scene,
        ball,
        DVec3::X * 3.0,
        DVec3::new(0.0, 0.0, -50.0),
    );
    scene
}

fn loosened(share: f64) -> Scene {
    let mut scene = on(Preset::NineFoot);
    Rack::NineBall.place(&mut scene, Ball::POOL, 1e-4, 2);
    let cue = &mut scene.balls[0].state;
    cue.position += DVec3::new(-0.05 * share, 0.0, 0.15);
    let apex = scene.balls[1].state.position;
    let towards = (apex - scene.balls[0].state.position).normalize();
    moving(&mut scene, 0, 8.0 * towards, DVec3::ZERO);
    scene.time_limit = 12.0;
    scene
}
