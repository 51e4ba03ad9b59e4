//! The stepped solver: a fixed tick, the coursework's way done right.
//!
//! One tick is one run of the [`StepSchedule`], a chain of [`StepSystems`]: rebuild the grid, collide balls cell by cell,
//! collide with cushions in edge cells, resolve the contacts found in order of time, apply friction, move.
//!
//! Free motion inside a tick is the closed form of the motion law, so a lone ball is exact at any tick. A contact is
//! located inside the tick and resolved from the positions at that time. The coursework's way (`locate: false`) resolves
//! balls where the tick has left them, overlapped, pair by pair. Located contacts are resolved together with everything that
//! touches, and contacts that last by the same rules as in the exact solver.
//!
//! Which scenes go where: with [`crate::physics::scene::Stepped::crowd`] equal balls on the slate of a table without
//! pockets, thousands to a million, are worked on by [`crowd`], counted and not recorded. Everything else, with balls of
//! any size, pockets, messages and records, is worked on here.

mod bodies;
mod collide_balls;
mod collide_cushions;
mod contacts;
pub mod crowd;
mod friction;
mod grid;
mod impact;
mod movement;
mod resolve;
#[cfg(test)]
mod tests;
mod wedged;

pub use bodies::Bodies;
pub use grid::Grid;

use bevy::ecs::schedule::{ScheduleLabel, SingleThreadedExecutor};
use bevy::prelude::*;

use crate::physics::laws::motion::MotionLaw;
use crate::physics::scene::Solver;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::playfield::Playfield;

/// One tick of the stepped solver. Runs inside [`SimSystems::Advance`].
#[derive(ScheduleLabel, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StepSchedule;

/// The order of one tick.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StepSystems {
    /// Every ball is listed in every cell that its path of this tick touches. Runs in [`StepSchedule`].
    RebuildGrid,
    /// Contacts between balls are found, cell by cell. Runs in [`StepSchedule`].
    CollideBalls,
    /// Contacts with cushions and pockets are found, in the cells that hold any. Runs in [`StepSchedule`].
    CollideCushions,
    /// The contacts found are resolved in order of time, and those that follow from them. Runs in [`StepSchedule`].
    Resolve,
    /// Velocities and spins at the end of the tick; skipped on a table without friction. Runs in [`StepSchedule`].
    ApplyFriction,
    /// Positions at the end of the tick, written to the components. Runs in [`StepSchedule`].
    Move,
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(crowd::plugin)
        .init_schedule(StepSchedule)
        .init_resource::<grid::Grid>()
        .init_resource::<bodies::Bodies>()
        .init_resource::<contacts::Contacts>()
        .edit_schedule(StepSchedule, |schedule| {
            // The systems of a tick depend on each other: threads would only cost.
            schedule.set_executor(SingleThreadedExecutor::new());
        })
        .configure_sets(
            StepSchedule,
            (
                StepSystems::RebuildGrid,
                StepSystems::CollideBalls,
                StepSystems::CollideCushions,
                StepSystems::Resolve,
                StepSystems::ApplyFriction,
                StepSystems::Move,
            )
                .chain(),
        )
        .add_systems(
            StepSchedule,
            (
                (bodies::gather, grid::rebuild)
                    .chain()
                    .in_set(StepSystems::RebuildGrid),
                collide_balls::collide_balls.in_set(StepSystems::CollideBalls),
                collide_cushions::collide_cushions.in_set(StepSystems::CollideCushions),
                resolve::resolve.in_set(StepSystems::Resolve),
                friction::apply_friction
                    .in_set(StepSystems::ApplyFriction)
                    .run_if(has_friction),
                movement::move_balls.in_set(StepSystems::Move),
            )
                .distributive_run_if(not(crowd::is_crowd)),
        )
        .add_systems(
            StepSchedule,
            (
                crowd::take_up.in_set(StepSystems::RebuildGrid),
                // The passes from the grid to friction run tile by tile.
                crowd::advance.in_set(StepSystems::Resolve),
                crowd::write.in_set(StepSystems::Move),
            )
                .distributive_run_if(crowd::is_crowd),
        )
        .add_systems(
            FixedUpdate,
            advance
                .in_set(SimSystems::Advance)
                .run_if(is_stepped.and_then(is_moving)),
        );
}

fn is_stepped(playfield: Res<Playfield>) -> bool {
    matches!(playfield.solver, Solver::Stepped(_))
}

fn is_moving(clock: Res<Clock>) -> bool {
    clock.moving
}

fn has_friction(playfield: Res<Playfield>) -> bool {
    playfield.laws.motion != MotionLaw::Frictionless
}

/// Runs one tick.
pub(super) fn advance(world: &mut World) {
    world.run_schedule(StepSchedule);
    world.resource_mut::<Clock>().ticks += 1;
}
