//! Random tables and where balls lie on them: in corners, in jaws, at cushions, frozen to each other, in the air.

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use proptest::sample::select;

use masse::physics::ball::{Ball, State};
use masse::physics::scene::{Scene, SceneBall};
use masse::physics::table::{Arc, Cushion, Preset, Table};

use crate::properties::inputs::component;

/// A table by name, a small box, or a box with pegs.
pub fn table() -> impl Strategy<Value = Table> {
    let size = || 0.3..2.0_f64;
    let pegs = prop::collection::vec((-0.5..0.5_f64, -0.5..0.5_f64, 0.0..0.1_f64), 0..6);
    prop_oneof![
        3 => select(Preset::NAMED.to_vec()).prop_map(|preset| preset.table()),
        1 => (size(), size()).prop_map(|(length, width)| Preset::Box { length, width }.table()),
        1 => (size(), size(), pegs).prop_map(|(length, width, pegs)| {
            let mut table = Preset::Box { length, width }.table();
            table.cushions.extend(pegs.into_iter().map(|(x, z, radius)| {
                let center = DVec2::new(x * length, z * width);
                Cushion::Arc(Arc { center, radius })
            }));
            table
        }),
    ]
}

/// Where a ball is put.
#[derive(Clone, Debug)]
pub enum Place {
    /// Anywhere, as shares of the table.
    Anywhere(f64, f64),
    /// This far from two sides.
    Corner(f64, f64),
    /// This far from the nose at a share of its length.
    AtCushion(usize, f64, f64),
    /// In this direction from the middle of a pocket, as shares of its radius.
    AtPocket(usize, f64, f64),
    /// Touching an earlier ball, or this far from it, in this direction.
    At(usize, f64, f64),
}

pub fn place() -> impl Strategy<Value = Place> {
    let gap = || prop_oneof![3 => Just(0.0), 1 => Just(1e-12), 1 => Just(1e-9), 1 => 0.0..0.01_f64];
    let angle = || {
        prop_oneof![
            2 => -3.2..3.2_f64,
            1 => select(vec![0.0, std::f64::consts::FRAC_PI_3, std::f64::consts::FRAC_PI_2, std::f64::consts::PI]),
        ]
    };
    let share = || -0.5..0.5_f64;
    prop_oneof![
        3 => (share(), share()).prop_map(|(x, z)| Place::Anywhere(x, z)),
        1 => (gap(), gap()).prop_map(|(x, z)| Place::Corner(x, z)),
        2 => (any::<usize>(), 0.0..1.0_f64, gap()).prop_map(|(i, along, gap)| Place::AtCushion(i, along, gap)),
        2 => (any::<usize>(), angle(), 1.0..2.2_f64).prop_map(|(i, angle, far)| Place::AtPocket(i, angle, far)),
        4 => (any::<usize>(), angle(), gap()).prop_map(|(i, angle, gap)| Place::At(i, angle, gap)),
    ]
}

/// A ball that a scene may get.
#[derive(Clone, Debug)]
pub struct Guest {
    pub place: Place,
    /// Radius in m and decimal logarithm of the mass in kg; `None` is a pool ball.
    pub body: Option<(f64, f64)>,
    pub spins: bool,
    pub velocity: (f64, f64),
    pub spin: (f64, f64, f64),
    /// Height over the slate and upward velocity.
    pub flies: Option<(f64, f64)>,
}

pub fn guest() -> impl Strategy<Value = Guest> {
    let still = || {
        (
            prop_oneof![1 => Just(0.0), 1 => component(30.0)],
            prop_oneof![1 => Just(0.0), 1 => component(30.0)],
        )
    };
    let spin = || prop_oneof![2 => Just(0.0), 1 => component(500.0)];
    (
        place(),
        prop::option::weighted(0.4, (0.01..0.05_f64, -3.0..3.0_f64)),
        prop::bool::weighted(0.9),
        still(),
        (spin(), spin(), spin()),
        prop::option::weighted(0.1, (0.0..0.3_f64, -3.0..3.0_f64)),
    )
        .prop_map(|(place, body, spins, velocity, spin, flies)| Guest {
            place,
            body,
            spins,
            velocity,
            spin,
            flies,
        })
}

/// Puts a ball into a scene where it can be; a guest that has no room is left out.
pub fn seat(scene: &mut Scene, guest: &Guest, one_kind: bool) {
    let mut ball = Ball {
        spins: guest.spins,
        ..Ball::POOL
    };
    if let Some((radius, power)) = guest.body.filter(|_| !one_kind) {
        ball.radius = radius;
        ball.mass = libm::pow(10.0, power);
    }
    let plan = |state: &State| DVec2::new(state.position.x, state.position.z);
    let toward = |angle: f64| DVec2::new(libm::cos(angle), libm::sin(angle));
    let (table, reach) = (&scene.table, scene.table.reach(ball.radius));
    let half = 0.5 * DVec2::new(table.length, table.width);
    let point = match guest.place {
        Place::Anywhere(x, z) => 2.0 * half * DVec2::new(x, z),
        Place::Corner(x, z) => half - DVec2::splat(reach) - DVec2::new(x, z),
        Place::AtCushion(index, along, gap) => {
            match &table.cushions[index % table.cushions.len()] {
                Cushion::Line(line) => {
                    let foot = line.from + along * (line.to - line.from);
                    let normal = (line.to - line.from).perp().normalize();
                    let inward = if normal.dot(-foot) < 0.0 {
                        -normal
                    } else {
                        normal
                    };
                    foot + (reach + gap) * inward
                }
                Cushion::Arc(arc) => arc.center + (arc.radius + reach + gap) * toward(6.3 * along),
            }
        }
        Place::AtPocket(index, angle, far) if !table.pockets.is_empty() => {
            let pocket = &table.pockets[index % table.pockets.len()];
            pocket.center + far * pocket.radius * toward(angle)
        }
        Place::AtPocket(_, angle, far) => 0.3 * far * half * toward(angle),
        Place::At(_, x, z) if scene.balls.is_empty() => 0.1 * DVec2::new(x, z),
        Place::At(index, angle, gap) => {
            let other = &scene.balls[index % scene.balls.len()];
            let sum = ball.radius + other.ball.radius;
            let rise = ball.radius - other.state.position.y;
            let apart = (sum * sum - rise * rise).max(0.0).sqrt() + gap;
            plan(&other.state) + apart * toward(angle)
        }
    };
    let mut state = State::at_rest(DVec3::new(point.x, ball.radius, point.y));
    state.velocity = DVec3::new(guest.velocity.0, 0.0, guest.velocity.1);
    if ball.spins {
        state.angular_velocity = DVec3::new(guest.spin.0, guest.spin.1, guest.spin.2);
    }
    if let Some((height, up)) = guest
        .flies
        .filter(|_| scene.laws.motion.gravity().is_some())
    {
        state.position.y += height;
        state.velocity.y = up;
    }
    scene.balls.push(SceneBall {
        name: scene.balls.len().to_string(),
        ball,
        state,
    });
    if scene.check().is_err() {
        scene.balls.pop();
    }
}
