//! How a ball moves on the screen: the simulation gives a state a tick, the screen wants one a frame.
//!
//! Positions and turns are kept in f64; [`place`] is the one system in which they become pixels.

use bevy::math::{DQuat, DVec3};
use bevy::prelude::*;

use crate::game::replay::Replay;
use crate::physics::ball::Motion;
use crate::physics::laws::motion::Cloth;
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, MotionKind, Position, Radius, Velocity};
use crate::sim::playfield::Playfield;
use crate::window::render::balls::fall::Fall;
use crate::window::render::stage::Stage;

/// How the markings of a ball are turned.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Turn(pub DQuat);

/// Where a ball was drawn at the end of the last two ticks.
#[derive(Component, Clone, Copy, Debug)]
pub(super) struct Track {
    before: DVec3,
    now: DVec3,
    turned_before: Option<DQuat>,
    spin: DVec3,
    fall: Option<Fall>,
}

impl Track {
    pub fn at(position: DVec3) -> Self {
        Self {
            before: position,
            now: position,
            turned_before: None,
            spin: DVec3::ZERO,
            fall: None,
        }
    }
}

/// The drawn sphere of a ball: a child of the ball, so that it alone turns.
#[derive(Component)]
pub(in crate::window::render) struct Globe;

/// The shade below a ball.
#[derive(Component)]
pub(super) struct Shade;

/// A turn for a ball that nobody has touched yet: number up, a little askew, the same on every run.
pub(super) fn resting_turn(index: usize, name: &str) -> DQuat {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for byte in name.bytes().chain(index.to_le_bytes()) {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    let share = |bits: u64| f64::from((bits & 0xffff) as u32) / 65_535.0 - 0.5;
    let up = DQuat::from_axis_angle(DVec3::new(1.0, 1.0, 0.0).normalize(), std::f64::consts::PI);
    let lean = DQuat::from_rotation_z(0.55 + 0.7 * share(hash >> 16));
    let yaw = DQuat::from_rotation_y(1.6 * share(hash >> 32));
    yaw * lean * up
}

/// Follows the simulation, once a tick. A ball with spin turns by its spin, a ball without rolls along its way.
pub(super) fn follow(
    clock: Res<Clock>,
    playfield: Res<Playfield>,
    replay: Res<Replay>,
    mut shown: Local<f64>,
    mut balls: Query<(
        &Position,
        &Velocity,
        Option<&AngularVelocity>,
        &Radius,
        &MotionKind,
        &mut Track,
        &mut Turn,
    )>,
) {
    // A replay runs at its own rate, backwards too.
    let step = match &replay.0 {
        Some(playback) => playback.time - std::mem::replace(&mut *shown, playback.time),
        None => clock.tick,
    };
    for (position, velocity, spin, radius, motion, mut track, mut turn) in &mut balls {
        let here = position.0;
        let spin_now = spin.map_or_else(|| DVec3::Y.cross(velocity.0) / radius.0, |spin| spin.0);
        let falls = motion.0 == Motion::Pocketed;
        let at_rest = track.now == here && track.before == here && spin_now == DVec3::ZERO;
        if !falls && at_rest && track.spin == DVec3::ZERO && track.turned_before.is_none() {
            continue;
        }
        let mean = 0.5 * (track.spin + spin_now);
        track.before = track.now;
        track.turned_before = Some(turn.0);
        if falls {
            let start = track.now;
            let last = track.spin;
            let pocket = DVec3::new(here.x, 0.0, here.z);
            let fall = track.fall.get_or_insert_with(|| {
                let room = nearest_room(&playfield, pocket) - radius.0;
                // A table without cloth has no weight to fall by, but it has pockets.
                let weight = playfield.laws.motion.gravity();
                let gravity = weight.unwrap_or_else(|| Cloth::default().gravity);
                let velocity = last.cross(DVec3::Y) * radius.0;
                Fall::new(start, pocket, room, velocity, gravity)
            });
            fall.advance(clock.tick);
            track.now = fall.position;
            turn.0 = (DQuat::from_scaled_axis(last * step) * turn.0).normalize();
            continue;
        }
        track.fall = None;
        track.now = here;
        track.spin = spin_now;
        if clock.moving || mean != DVec3::ZERO {
            turn.0 = (DQuat::from_scaled_axis(mean * step) * turn.0).normalize();
        }
        if spin_now == DVec3::ZERO && track.before == track.now {
            track.turned_before = None;
        }
    }
}

/// Radius in m of the pocket a ball fell into.
fn nearest_room(playfield: &Playfield, at: DVec3) -> f64 {
    playfield
        .table
        .pockets
        .iter()
        .min_by(|a, b| {
            let away =
                |c: bevy::math::DVec2| c.distance_squared(bevy::math::DVec2::new(at.x, at.z));
            away(a.center).total_cmp(&away(b.center))
        })
        .map_or(0.05, |pocket| pocket.radius)
}

/// Puts every ball on the screen between its last two states.
pub(super) fn place(
    fixed: Res<Time<Fixed>>,
    stage: Res<Stage>,
    mut balls: Query<(&Track, &Turn, &Children, &mut Transform, &mut Visibility)>,
    mut globes: Query<&mut Transform, (With<Globe>, Without<Track>)>,
    mut shades: Query<&mut Visibility, (With<Shade>, Without<Track>)>,
) {
    let share = fixed.overstep_fraction_f64();
    for (track, turn, children, mut transform, mut visibility) in &mut balls {
        let at = track.before.lerp(track.now, share).as_vec3();
        if transform.translation != at {
            transform.translation = at;
        }
        let seen = if track.fall.as_ref().is_some_and(Fall::is_over) {
            Visibility::Hidden
        } else {
            Visibility::Inherited
        };
        visibility.set_if_neq(seen);
        let turned = track
            .turned_before
            .map_or(turn.0, |before| before.slerp(turn.0, share))
            .as_quat();
        let mut globes = globes.iter_many_mut(children);
        while let Some(mut globe) = globes.fetch_next() {
            if globe.rotation != turned {
                globe.rotation = turned;
            }
        }
        let mut shades = shades.iter_many_mut(children);
        while let Some(mut shade) = shades.fetch_next() {
            shade.set_if_neq(if track.fall.is_some() || stage.traces {
                Visibility::Hidden
            } else {
                Visibility::Inherited
            });
        }
    }
}
