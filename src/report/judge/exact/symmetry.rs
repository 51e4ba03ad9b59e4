//! H15 and H16: what holds for every law and any impact, over [`IMPACTS`] random ones each: no energy is won, a mirror
//! image mirrors, a turned one turns, and other units give the same.

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::physics::ball::{Ball, State};
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cushion::CushionContact;
use crate::report::judge::Row;
use crate::report::judge::stand::{EDGE, ball_ball_laws, cushion_laws};

/// Random impacts per law.
const IMPACTS: usize = 100_000;

/// Share of the speeds before by which rounding may move the outcome.
const ROUNDING: f64 = 1e-13;

/// The same for a law without closed form: where friction just fails to hold a slip, rounding grows before it is forgotten.
const FOLLOWED: f64 = 1e-10;

/// A ball of some mass, its state on the slate, and the horizontal normal.
struct Draw(ChaCha8Rng);

impl Draw {
    fn new() -> Self {
        Self(ChaCha8Rng::seed_from_u64(15))
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.0.random_range(least..most)
    }

    fn ball(&mut self) -> (Ball, State) {
        let ball = Ball {
            mass: self.between(0.1, 0.25),
            ..Ball::POOL
        };
        let velocity = DVec3::new(self.between(-5.0, 5.0), 0.0, self.between(-5.0, 5.0));
        let spin = DVec3::new(
            self.between(-200.0, 200.0),
            self.between(-200.0, 200.0),
            self.between(-200.0, 200.0),
        );
        let mut state = State::at_rest(DVec3::Y * ball.radius);
        state.velocity = velocity;
        state.angular_velocity = spin;
        (ball, state)
    }

    fn normal(&mut self) -> DVec3 {
        turned(DVec3::X, self.between(0.0, std::f64::consts::TAU))
    }
}

/// The worst of one law.
#[derive(Default)]
struct Worst {
    energy: f64,
    mirror: f64,
    turn: f64,
    units: f64,
}

impl Worst {
    fn rows(&self, kind: &str, law: &str) -> Vec<Row> {
        let rounding = if law.starts_with("Mathavan") {
            FOLLOWED
        } else {
            ROUNDING
        };
        let source = "conservation and symmetry, 100 000 random impacts";
        [
            ("H15", "energy won, share", self.energy, 1e-12),
            ("H16", "mirror image differs by", self.mirror, ROUNDING),
            ("H16", "turned by 1.9 rad differs by", self.turn, rounding),
            ("H16", "in other units differs by", self.units, rounding),
        ]
        .into_iter()
        .map(|(judge, what, value, tolerance)| {
            Row::zero(
                &format!("{judge} {kind}: {what}"),
                law,
                value,
                tolerance,
                "",
            )
            .by(source)
        })
        .collect()
    }
}

fn turned(vector: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    DVec3::new(
        cos * vector.x + sin * vector.z,
        vector.y,
        cos * vector.z - sin * vector.x,
    )
}

fn turned_state(state: &State) -> State {
    State {
        velocity: turned(state.velocity, 1.9),
        angular_velocity: turned(state.angular_velocity, 1.9),
        ..*state
    }
}

/// z turned round; spin is an axial vector.
fn mirrored(state: &State) -> State {
    let (v, w) = (state.velocity, state.angular_velocity);
    State {
        velocity: DVec3::new(v.x, v.y, -v.z),
        angular_velocity: DVec3::new(-w.x, -w.y, w.z),
        ..*state
    }
}

/// Units in which lengths and times are 3.7 times the number and masses 0.3 times: speeds stay, spins shrink.
const LENGTH: f64 = 3.7;
const MASS: f64 = 0.3;

fn in_units(ball: &Ball, state: &State) -> (Ball, State) {
    let ball = Ball {
        mass: MASS * ball.mass,
        radius: LENGTH * ball.radius,
        ..*ball
    };
    let mut state = *state;
    state.position *= LENGTH;
    state.angular_velocity /= LENGTH;
    (ball, state)
}

/// Distance of two outcomes as a speed, spin counted at the surface.
fn apart(a: &State, b: &State, radius: f64) -> f64 {
    (a.velocity - b.velocity).length() + radius * (a.angular_velocity - b.angular_velocity).length()
}

fn size(ball: &Ball, state: &State) -> f64 {
    state.velocity.length() + ball.radius * state.angular_velocity.length()
}

pub(in crate::report::judge) fn ball_ball() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, law) in ball_ball_laws() {
        let mut draw = Draw::new();
        let mut worst = Worst::default();
        for _ in 0..IMPACTS {
            let (a, b, normal) = (draw.ball(), draw.ball(), draw.normal());
            let hit = |a: (Ball, State), b: (Ball, State), normal: DVec3| {
                let mut second = b.1;
                second.position = a.1.position + 2.0 * a.0.radius * normal;
                let contact = PairContact::between(&a.1, &second);
                let after = law.collide((&a.0, &a.1), (&b.0, &second), &contact);
                [after.first, after.second]
            };
            let after = hit(a, b, normal);
            let before = a.0.kinetic_energy(&a.1) + b.0.kinetic_energy(&b.1);
            let left = a.0.kinetic_energy(&after[0]) + b.0.kinetic_energy(&after[1]);
            worst.energy = worst.energy.max(left / before - 1.0);
            let scale = size(&a.0, &a.1) + size(&b.0, &b.1);
            let r = a.0.radius;
            let differ = |one: [State; 2], two: [State; 2]| {
                (apart(&one[0], &two[0], r) + apart(&one[1], &two[1], r)) / scale
            };
            let flipped = DVec3::new(normal.x, 0.0, -normal.z);
            let image = hit((a.0, mirrored(&a.1)), (b.0, mirrored(&b.1)), flipped);
            worst.mirror = worst
                .mirror
                .max(differ(image.map(|state| mirrored(&state)), after));
            let image = hit(
                (a.0, turned_state(&a.1)),
                (b.0, turned_state(&b.1)),
                turned(normal, 1.9),
            );
            worst.turn = worst
                .turn
                .max(differ(image, after.map(|state| turned_state(&state))));
            let image = hit(in_units(&a.0, &a.1), in_units(&b.0, &b.1), normal);
            let back = image.map(|mut state| {
                state.angular_velocity *= LENGTH;
                state
            });
            worst.units = worst.units.max(differ(back, after));
        }
        rows.extend(worst.rows("ball-ball", &name));
    }
    rows
}

pub(in crate::report::judge) fn cushion() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, law) in cushion_laws() {
        let mut draw = Draw::new();
        let mut worst = Worst::default();
        for _ in 0..IMPACTS {
            let (ball, state) = draw.ball();
            let normal = draw.normal();
            let height = draw.between(1.0, 1.5);
            let rebound = |(ball, state): (Ball, State), normal: DVec3| {
                let contact = CushionContact {
                    normal,
                    nose_height: height * ball.radius,
                    nose: EDGE,
                    restitution: None,
                };
                law.rebound(&ball, &state, &contact).state
            };
            let after = rebound((ball, state), normal);
            let (before, left) = (ball.kinetic_energy(&state), ball.kinetic_energy(&after));
            worst.energy = worst.energy.max(left / before - 1.0);
            let scale = size(&ball, &state);
            let differ = |one: &State, two: &State| apart(one, two, ball.radius) / scale;
            let image = rebound(
                (ball, mirrored(&state)),
                DVec3::new(normal.x, 0.0, -normal.z),
            );
            worst.mirror = worst.mirror.max(differ(&mirrored(&image), &after));
            let image = rebound((ball, turned_state(&state)), turned(normal, 1.9));
            worst.turn = worst.turn.max(differ(&image, &turned_state(&after)));
            let mut image = rebound(in_units(&ball, &state), normal);
            image.angular_velocity *= LENGTH;
            worst.units = worst.units.max(differ(&image, &after));
        }
        rows.extend(worst.rows("cushion", &name));
    }
    rows
}
