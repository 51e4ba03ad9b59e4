//! The components of a crowd: taken up when somebody has written them, written after a tick.

use std::time::Instant;

use bevy::ecs::change_detection::Tick;
use bevy::ecs::system::SystemChangeTick;
use bevy::prelude::*;

use crate::physics::ball::{Ball, State};
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::messages::Failed;
use crate::sim::playfield::Playfield;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::field::{Field, share};
use crate::sim::stepped::crowd::tiles::Tiles;
use crate::sim::stepped::crowd::{Census, Crowd, Kind, Pass, book};

/// When the components of a crowd are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mirror {
    /// After every tick.
    #[default]
    EveryTick,
    /// When asked for with [`Crowd::ask`], and when everything has come to rest.
    WhenAsked,
}

type Read<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        Ref<'static, Position>,
        Ref<'static, Velocity>,
        Option<Ref<'static, AngularVelocity>>,
        &'static Mass,
        &'static Radius,
        Ref<'static, MotionKind>,
    ),
>;

type Write<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static mut Position,
        &'static mut Velocity,
        Option<&'static mut AngularVelocity>,
        &'static mut MotionKind,
    ),
>;

/// Reads the components, if they are not as the crowd has left them.
pub(in crate::sim::stepped) fn take_up(
    mut crowd: ResMut<Crowd>,
    mut census: ResMut<Census>,
    playfield: Res<Playfield>,
    clock: Res<Clock>,
    balls: Read,
    mut failed: MessageWriter<Failed>,
) {
    let written = crowd.written.filter(|_| !playfield.is_changed());
    if written.is_some_and(|tick| is_untouched(&balls, tick)) {
        return;
    }
    match read(&crowd, &balls) {
        Ok((ball, count, states)) => {
            census.balls = states.len();
            census.contacts_in_all = 0;
            census.repeated = 0;
            crowd.lay_out(&playfield, ball, count, &states);
        }
        Err(reason) => {
            failed.write(Failed {
                time: clock.time(),
                reason,
            });
        }
    }
}

fn is_untouched(balls: &Read, written: Tick) -> bool {
    let untouched = |ticks: &[Tick]| ticks.iter().all(|tick| *tick == written);
    balls.contiguous_iter().is_ok_and(|mut tables| {
        tables.all(|(_, position, velocity, spin, _, _, motion)| {
            untouched(position.changed_ticks_slice())
                && untouched(velocity.changed_ticks_slice())
                && spin.is_none_or(|spin| untouched(spin.changed_ticks_slice()))
                && untouched(motion.changed_ticks_slice())
        })
    })
}

/// The constants of every ball, the number of balls with those out of play, and the states of those in play.
fn read(crowd: &Crowd, balls: &Read) -> Result<(Ball, usize, Vec<(u32, State)>), String> {
    let mut every: Option<Ball> = None;
    let mut count = 0;
    let mut states = Vec::with_capacity(balls.iter().len());
    for (index, position, velocity, spin, mass, radius, motion) in balls {
        let touched = crowd.written != Some(velocity.last_changed())
            || crowd.written != Some(position.last_changed());
        let (ball, mut state) =
            ball_and_state(&position, &velocity, spin.as_deref(), mass, radius, &motion);
        if crowd.behind && !touched {
            state = crowd.state(index.0).unwrap_or(state);
        }
        if every.is_some_and(|every| every != ball) {
            return Err(format!(
                "ball {} is not like the others: the balls of a crowd are equal",
                index.0
            ));
        }
        if state.motion.flies() {
            return Err(format!(
                "ball {} flies: a crowd stays on the slate",
                index.0
            ));
        }
        every = Some(ball);
        count = count.max(index.0 + 1);
        if state.motion.in_play() {
            states.push((index.0 as u32, state));
        }
    }
    let ball = every.ok_or("there are no balls")?;
    Ok((ball, count, states))
}

/// Writes the components.
pub(in crate::sim::stepped) fn write(
    mut crowd: ResMut<Crowd>,
    mut census: ResMut<Census>,
    mut balls: Write,
    ticks: SystemChangeTick,
) {
    let lap = Instant::now();
    let wanted = crowd.mirror == Mirror::EveryTick || crowd.asked || !crowd.is_moving();
    if !(wanted && crowd.behind) {
        return;
    }
    let threads = crowd.threads();
    let Some(ball) = crowd.ball else { return };
    match &crowd.field {
        Some(Kind::Gliding(field)) => write_all(field, &ball, threads, &mut balls),
        Some(Kind::Rubbed(field)) => write_all(field, &ball, threads, &mut balls),
        None => return,
    }
    crowd.behind = false;
    crowd.asked = false;
    crowd.written = Some(ticks.this_run());
    book(&mut census, Pass::Mirror, lap);
}

/// Balls written at a time by one thread.
const CHUNK: usize = 16_384;

fn write_all<B: Body>(field: &Field<B>, ball: &Ball, threads: usize, balls: &mut Write) {
    let Ok(tables) = balls.contiguous_iter_mut() else {
        return;
    };
    for (index, mut position, mut velocity, mut spin, mut motion) in tables {
        let mut spins = spin.as_deref_mut().map(|spin| spin.chunks_mut(CHUNK));
        let chunks: Vec<_> = index
            .chunks(CHUNK)
            .zip(position.chunks_mut(CHUNK))
            .zip(velocity.chunks_mut(CHUNK))
            .zip(motion.chunks_mut(CHUNK))
            .map(|chunk| (chunk, spins.as_mut().and_then(Iterator::next)))
            .collect();
        let mut scratch = vec![(); threads];
        share(threads, chunks, &mut scratch, |(), (chunk, mut spin)| {
            let (((index, position), velocity), motion) = chunk;
            for k in 0..index.len() {
                let Some(state) = state(&field.tiles, ball, index[k]) else {
                    continue;
                };
                position[k] = Position(state.position);
                velocity[k] = Velocity(state.velocity);
                motion[k] = MotionKind(state.motion);
                if let Some(spin) = &mut spin {
                    spin[k] = AngularVelocity(state.angular_velocity);
                }
            }
        });
    }
}

#[inline]
fn state<B: Body>(tiles: &Tiles<B>, ball: &Ball, index: BallIndex) -> Option<State> {
    let [tile, slot] = *tiles.places.get(index.0)?;
    let tile = tiles.all.get(tile as usize)?;
    Some(tile.bodies[slot as usize].state(ball, 0.0))
}
