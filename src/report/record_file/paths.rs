//! The paths that follow from the events of a record.

use crate::physics::ball::State;
use crate::physics::record::{Event, PathPiece};
use crate::physics::scene::Scene;

/// The path of each ball, from its first state and the states after its events. The events must name balls of the scene.
pub(super) fn of_events(scene: &Scene, events: &[Event]) -> Vec<Vec<PathPiece>> {
    let mut paths: Vec<Vec<PathPiece>> = scene
        .balls
        .iter()
        .enumerate()
        .map(|(index, ball)| {
            let start = scene.laws.motion.classify(&ball.ball, ball.state);
            vec![piece(scene, index, 0.0, &start)]
        })
        .collect();
    for event in events {
        for participant in event.participants() {
            if bits(&participant.before) == bits(&participant.after) {
                continue;
            }
            let path = &mut paths[participant.ball];
            // A piece that ends where it began was never seen.
            if path.last().is_some_and(|last| last.time >= event.time) {
                path.pop();
            }
            path.push(piece(
                scene,
                participant.ball,
                event.time,
                &participant.after,
            ));
        }
    }
    paths
}

/// The piece of path that begins with this state.
pub(super) fn piece(scene: &Scene, ball: usize, time: f64, start: &State) -> PathPiece {
    PathPiece {
        time,
        piece: scene
            .laws
            .piece(&scene.table, &scene.balls[ball].ball, start),
    }
}

/// Whether each piece is the one that the motion law begins with its first state.
pub(super) fn follow_from_starts(scene: &Scene, ball: usize, path: &[PathPiece]) -> bool {
    path.iter()
        .all(|turn| piece(scene, ball, turn.time, &turn.piece.start) == *turn)
}

/// Whether two paths begin their pieces at the same times with the same states, bit for bit.
pub(super) fn same(one: &[PathPiece], other: &[PathPiece]) -> bool {
    let turn = |turn: &PathPiece| (turn.time.to_bits(), bits(&turn.piece.start));
    one.iter().map(turn).eq(other.iter().map(turn))
}

fn bits(state: &State) -> ([u64; 9], crate::physics::ball::Motion) {
    let (p, v, w) = (state.position, state.velocity, state.angular_velocity);
    let numbers = [p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z];
    (numbers.map(f64::to_bits), state.motion)
}
