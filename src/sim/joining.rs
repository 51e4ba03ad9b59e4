//! Balls that others spawn, push or take away.
//!
//! Whoever spawns an entity with a [`Position`] has spawned a ball: what else a ball needs it gets here, at the beginning of
//! the next tick, and the shot begins anew with all balls as they are. The same happens when a ball is despawned, and when
//! a [`Restart`] asks for it. Balls of a scene that is loaded are complete and need none of this.

use bevy::prelude::*;

use crate::physics::scene::Scene;
use crate::sim::SimSystems;
use crate::sim::clock::{Clock, strike};
use crate::sim::components::{
    AngularVelocity, BallIndex, BallName, MotionKind, Position, Velocity,
};
use crate::sim::messages::{Failed, Restart};
use crate::sim::playfield::{BallQuery, Playfield, load_scene, snapshot};
use crate::sim::recorder::{Recorder, remember};

/// What a ball that has joined may lack or have with too many digits.
type Placed<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static mut Velocity,
        Option<&'static mut AngularVelocity>,
        &'static mut MotionKind,
    ),
>;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(
        FixedUpdate,
        begin_anew
            .in_set(SimSystems::Strike)
            .after(load_scene)
            .before(remember)
            .before(strike)
            .run_if(on_message::<Restart>.or_else(is_out_of_step)),
    );
}

/// Whether there are balls without a number, or numbers without a ball.
fn is_out_of_step(
    new: Query<(), (With<Position>, Without<BallIndex>)>,
    mut gone: RemovedComponents<BallIndex>,
    balls: Query<&BallIndex>,
) -> bool {
    // A scene that is laid out takes its forerunner's balls away, and leaves no gap.
    let gone = gone.read().count() > 0;
    let last = || balls.iter().map(|index| index.0 + 1).max().unwrap_or(0);
    !new.is_empty() || (gone && last() != balls.iter().len())
}

/// Numbers the balls and begins a shot with them as they are.
fn begin_anew(world: &mut World) {
    world.resource_mut::<Messages<Restart>>().clear();
    let were_still = {
        let mut kinds = world.query_filtered::<&MotionKind, With<BallIndex>>();
        kinds.iter(world).all(|kind| kind.0.is_still())
    };
    number(world);
    let scene = world.run_system_cached(label).ok().flatten();
    let Some(scene) = scene else {
        return;
    };
    // In the middle of a shot a ball may be where none could be put.
    let checked = if were_still {
        scene.check()
    } else {
        scene.check_numbers()
    };
    let failed = checked.err().map(|error| error.to_string());
    let clock = Clock {
        moving: failed.is_none(),
        ..Clock::new(&scene.solver)
    };
    world.insert_resource(clock);
    world.insert_resource(Recorder::start(&scene));
    // A crowd is packed again.
    world.resource_mut::<Playfield>().set_changed();
    if let Some(reason) = failed {
        world.write_message(Failed { time: 0.0, reason });
    }
}

/// Gives every ball its place in the order, the old ones first, and a name.
fn number(world: &mut World) {
    let mut query =
        world.query_filtered::<(Entity, Option<&BallIndex>, Option<&BallName>), With<Position>>();
    let mut balls: Vec<_> = query
        .iter(world)
        .map(|(entity, index, name)| (index.copied(), entity, name.cloned()))
        .collect();
    // Entities themselves sort backwards.
    balls.sort_unstable_by_key(|(index, entity, _)| (index.is_none(), *index, entity.index_u32()));
    let mut taken: Vec<String> = balls
        .iter()
        .filter_map(|(.., name)| name.as_ref().map(|name| name.0.clone()))
        .collect();
    taken.sort_unstable();
    let mut free = (0_usize..)
        .map(|number| number.to_string())
        .filter(|name| taken.binary_search(name).is_err());
    for (place, (index, entity, name)) in balls.into_iter().enumerate() {
        let mut ball = world.entity_mut(entity);
        if index != Some(BallIndex(place)) {
            ball.insert(BallIndex(place));
        }
        if name.is_none()
            && let Some(name) = free.next()
        {
            ball.insert(BallName(name));
        }
    }
}

/// Frees every ball's state of rounding and labels it with the motion that it deserves, as a scene that is laid out has
/// it. The table as a scene, if there is a ball on it.
fn label(playfield: Res<Playfield>, mut balls: ParamSet<(BallQuery, Placed)>) -> Option<Scene> {
    let mut scene = snapshot(&playfield, &balls.p0());
    for ball in &mut scene.balls {
        ball.state = scene.laws.motion.classify(&ball.ball, ball.state);
    }
    for (index, mut velocity, spin, mut kind) in &mut balls.p1() {
        let Some(ball) = scene.balls.get(index.0) else {
            continue;
        };
        velocity.set_if_neq(Velocity(ball.state.velocity));
        kind.set_if_neq(MotionKind(ball.state.motion));
        if let Some(mut spin) = spin {
            spin.set_if_neq(AngularVelocity(ball.state.angular_velocity));
        }
    }
    (!scene.balls.is_empty()).then_some(scene)
}
