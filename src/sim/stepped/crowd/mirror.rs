//! The components of a crowd: taken up when somebody has written them, written after a tick.

use std::hint::black_box;
use std::time::Instant;

use bevy::ecs::change_detection::Tick;
use bevy::ecs::system::SystemChangeTick;
use bevy::prelude::*;

use crate::physics::ball::{Ball, State};
use crate::physics::laws::motion::MotionLaw;
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::messages::Failed;
use crate::sim::playfield::Playfield;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::census::Sums;
use crate::sim::stepped::crowd::field::Field;
use crate::sim::stepped::crowd::share::{light, share};
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
    ticks: SystemChangeTick,
    mut failed: MessageWriter<Failed>,
) {
    let now = ticks.this_run();
    let seen = crowd.seen.filter(|_| !playfield.is_changed());
    if seen.is_some_and(|seen| is_untouched(&balls, seen, now)) {
        return;
    }
    match read(&crowd, &balls, now) {
        Ok((ball, states)) => {
            census.balls = states.len();
            census.contacts_in_all = 0;
            census.late = 0;
            crowd.lay_out(&playfield, ball, &states);
            crowd.seen = Some(now);
        }
        Err(reason) => {
            failed.write(Failed {
                time: clock.time(),
                reason,
            });
        }
    }
}

fn is_untouched(balls: &Read, seen: Tick, now: Tick) -> bool {
    let untouched = |ticks: &[Tick]| ticks.iter().all(|tick| !tick.is_newer_than(seen, now));
    balls.contiguous_iter().is_ok_and(|mut tables| {
        tables.all(|(_, position, velocity, spin, _, _, motion)| {
            untouched(position.changed_ticks_slice())
                && untouched(velocity.changed_ticks_slice())
                && spin.is_none_or(|spin| untouched(spin.changed_ticks_slice()))
                && untouched(motion.changed_ticks_slice())
        })
    })
}

/// The constants of every ball, and the states of those in play.
fn read(crowd: &Crowd, balls: &Read, now: Tick) -> Result<(Ball, Vec<(u32, State)>), String> {
    let mut every: Option<Ball> = None;
    let mut states = Vec::with_capacity(balls.iter().len());
    for (index, position, velocity, spin, mass, radius, motion) in balls {
        let is_new = |tick: Tick| crowd.seen.is_none_or(|seen| tick.is_newer_than(seen, now));
        let touched = is_new(velocity.last_changed()) || is_new(position.last_changed());
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
        if state.motion.in_play() {
            states.push((index.0 as u32, state));
        }
    }
    let ball = every.ok_or("there are no balls")?;
    Ok((ball, states))
}

/// Writes the components, and sums up what is summed over balls.
pub(in crate::sim::stepped) fn write(
    mut crowd: ResMut<Crowd>,
    mut census: ResMut<Census>,
    playfield: Res<Playfield>,
    mut balls: Write,
    ticks: SystemChangeTick,
) {
    if !crowd.behind {
        return;
    }
    let lap = Instant::now();
    let threads = crowd.threads();
    let Some(ball) = crowd.ball else { return };
    let wanted = crowd.mirror == Mirror::EveryTick || crowd.asked;
    let crowd = &mut *crowd;
    let law = &playfield.laws.motion;
    let sums = match &mut crowd.field {
        Some(Kind::Gliding(field)) if wanted => write_all(field, (law, &ball), threads, &mut balls),
        Some(Kind::Single(field)) if wanted => write_all(field, (law, &ball), threads, &mut balls),
        Some(Kind::Rubbed(field)) if wanted => write_all(field, (law, &ball), threads, &mut balls),
        Some(Kind::Gliding(field)) => field.sums(law, &ball, threads),
        Some(Kind::Single(field)) => field.sums(law, &ball, threads),
        Some(Kind::Rubbed(field)) => field.sums(law, &ball, threads),
        None => return,
    };
    census.energy = sums.energy;
    census.potential = sums.potential;
    census.momentum = sums.momentum;
    census.speed = sums.speed.sqrt();
    book(&mut census, Pass::Mirror, lap);
    crowd.moves = sums.moves;
    if wanted || !sums.moves {
        if !wanted {
            match &mut crowd.field {
                Some(Kind::Gliding(field)) => write_all(field, (law, &ball), threads, &mut balls),
                Some(Kind::Single(field)) => write_all(field, (law, &ball), threads, &mut balls),
                Some(Kind::Rubbed(field)) => write_all(field, (law, &ball), threads, &mut balls),
                None => return,
            };
        }
        crowd.behind = false;
        crowd.asked = false;
        crowd.seen = Some(ticks.this_run());
    }
}

/// Balls written at a time by one thread.
const CHUNK: usize = 16_384;
/// Bodies asked for at a time.
const AHEAD: usize = 32;

fn write_all<B: Body>(
    field: &mut Field<B>,
    (law, ball): (&MotionLaw, &Ball),
    threads: usize,
    balls: &mut Write,
) -> Sums {
    let Ok(tables) = balls.contiguous_iter_mut() else {
        return Sums::default();
    };
    let mut all = Sums::default();
    let told = &*field;
    for (index, mut position, mut velocity, mut spin, mut motion) in tables {
        let mut spins = spin.as_deref_mut().map(|spin| spin.chunks_mut(CHUNK));
        let mut sums = vec![Sums::default(); index.len().div_ceil(CHUNK)];
        let chunks = index
            .chunks(CHUNK)
            .zip(position.chunks_mut(CHUNK))
            .zip(velocity.chunks_mut(CHUNK))
            .zip(motion.chunks_mut(CHUNK))
            .zip(&mut sums)
            .map(|chunk| (chunk, spins.as_mut().and_then(Iterator::next)));
        share(light(threads, index.len()), chunks, |(chunk, mut spin)| {
            let ((((index, position), velocity), motion), sums) = chunk;
            for k in 0..position.len() {
                if k % AHEAD == 0 {
                    // The bodies lie in another order: asked for at once, they come at once.
                    let some = index[k..].iter().take(AHEAD).map(|index| index.0);
                    let some = some.filter(|number| !told.is_as_told(*number));
                    let touched = some.filter_map(|number| told.body(number));
                    black_box(touched.map(B::touch).fold(0, |a, b| a ^ b));
                }
                let number = index[k].0;
                if told.is_as_told(number) {
                    continue;
                }
                let Some(state) = told.state(ball, number) else {
                    continue;
                };
                sums.count(law, ball, &state);
                position[k] = Position(state.position);
                velocity[k] = Velocity(state.velocity);
                motion[k] = MotionKind(state.motion);
                if let Some(spin) = &mut spin {
                    spin[k] = AngularVelocity(state.angular_velocity);
                }
            }
        });
        for sum in &sums {
            all.add(sum);
        }
    }
    field.told = true;
    all
}
