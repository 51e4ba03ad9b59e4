//! The clock of a shot, and the stroke that starts it.

use bevy::prelude::*;

use crate::physics::record::{Event, EventKind, Participant, PathPiece};
use crate::physics::scene::{Solver, strike_with};
use crate::sim::SimSystems;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::messages::{AtRest, Failed, PathTurned, Strike, Struck};
use crate::sim::playfield::Playfield;

/// Time of the shot. It starts again at zero with every stroke and every new scene, and stands while nothing moves.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Length of a fixed tick in s.
    pub tick: f64,
    /// Ticks since the shot began.
    pub ticks: u64,
    /// Whether any ball moves.
    pub moving: bool,
}

impl Clock {
    /// Tick in s of the messages when the solver itself has none.
    pub const FRAME: f64 = 1.0 / 120.0;

    /// A clock at zero for this solver.
    #[must_use]
    pub fn new(solver: &Solver) -> Self {
        Self {
            tick: match solver {
                Solver::Stepped(stepped) => stepped.tick,
                Solver::Exact => Self::FRAME,
            },
            ticks: 0,
            moving: true,
        }
    }

    /// Seconds since the shot began, at the end of the last tick. A product, so that no rounding piles up.
    #[must_use]
    #[expect(
        clippy::cast_precision_loss,
        reason = "a shot has far fewer than 2^52 ticks"
    )]
    pub fn time(&self) -> f64 {
        self.ticks as f64 * self.tick
    }
}

impl Default for Clock {
    fn default() -> Self {
        Self::new(&Solver::default())
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Clock>().add_systems(
        FixedUpdate,
        (
            strike.in_set(SimSystems::Strike),
            (rest, halt).chain().in_set(SimSystems::Record),
        ),
    );
}

/// Every ball as the clock sees it.
type Balls<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static Position,
        &'static mut Velocity,
        Option<&'static mut AngularVelocity>,
        &'static Mass,
        &'static Radius,
        &'static mut MotionKind,
    ),
>;

/// Plays the first stroke asked for, if nothing moves.
pub(super) fn strike(
    mut strikes: MessageReader<Strike>,
    mut struck: MessageWriter<Struck>,
    mut turned: MessageWriter<PathTurned>,
    mut clock: ResMut<Clock>,
    playfield: Res<Playfield>,
    mut balls: Balls,
) {
    let Some(strike) = strikes.read().last().copied() else {
        return;
    };
    if balls.iter().any(|ball| !ball.6.0.is_still()) {
        return;
    }
    for (index, position, mut velocity, mut spin, mass, radius, mut motion) in &mut balls {
        if index.0 != strike.ball || !motion.0.in_play() {
            continue;
        }
        let (ball, before) =
            ball_and_state(position, &velocity, spin.as_deref(), mass, radius, &motion);
        let outcome = strike_with(
            &playfield.cue,
            &playfield.laws,
            &ball,
            &before,
            &strike.shot,
        );
        let after = outcome.state;
        velocity.0 = after.velocity;
        motion.0 = after.motion;
        if let Some(spin) = &mut spin {
            spin.0 = after.angular_velocity;
        }
        *clock = Clock::new(&playfield.solver);
        turned.write(PathTurned {
            ball: index.0,
            piece: PathPiece {
                time: 0.0,
                piece: playfield.laws.piece(&playfield.table, &ball, &after),
            },
        });
        struck.write(Struck(Event {
            time: 0.0,
            kind: EventKind::Strike {
                miscue: outcome.miscue,
            },
            first: Participant {
                ball: index.0,
                before,
                after,
            },
            second: None,
            impulse: outcome.impulse,
        }));
    }
}

/// Stops the clock when the last ball has come to rest.
pub(super) fn rest(
    mut clock: ResMut<Clock>,
    balls: Query<&MotionKind>,
    mut at_rest: MessageWriter<AtRest>,
) {
    if clock.moving && balls.iter().all(|motion| motion.0.is_still()) {
        clock.moving = false;
        at_rest.write(AtRest { time: clock.time() });
    }
}

/// Stops the clock when the solver has failed.
fn halt(mut clock: ResMut<Clock>, mut failed: MessageReader<Failed>) {
    if failed.read().count() > 0 {
        clock.moving = false;
    }
}
