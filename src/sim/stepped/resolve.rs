//! Resolves the contacts of a tick in order of time, and those that follow from them.

use bevy::prelude::*;

use crate::physics::airborne;
use crate::physics::ball::State;
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::record::{Event, EventKind, Participant, PathPiece};
use crate::sim::messages::{Failed, MotionChanged, PathTurned, Pocketed, Struck, Touched};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;
use crate::sim::stepped::collide_cushions;
use crate::sim::stepped::contacts::{Contact, Contacts, Kind};
use crate::sim::stepped::grid::Grid;
use crate::sim::stepped::impact::Impact;

/// Impacts of one ball in one tick after which its contacts no longer bounce (e = 0): a row of balls that rattles
/// between neighbours comes to rest against them instead of colliding for ever.
pub(super) const BOUNCES: u32 = 64;
/// Impacts of one ball in one tick after which it meets nothing more until the next tick.
pub(super) const IMPACTS: u32 = 512;

/// Runs through the queue.
#[expect(
    clippy::too_many_arguments,
    reason = "one writer for each kind of message"
)]
pub(super) fn resolve(
    mut grid: ResMut<Grid>,
    mut bodies: ResMut<Bodies>,
    mut contacts: ResMut<Contacts>,
    playfield: Res<Playfield>,
    mut touched: MessageWriter<Touched>,
    mut pocketed: MessageWriter<Pocketed>,
    mut changed: MessageWriter<MotionChanged>,
    mut turned: MessageWriter<PathTurned>,
    mut failed: MessageWriter<Failed>,
    mut struck: MessageReader<Struck>,
    mut impact: Local<Impact>,
) {
    let struck = struck.read().last().map(|struck| struck.0.first.ball);
    let begins = bodies.locate && bodies.start == 0.0;
    let mut push = struck.filter(|_| begins);
    let mut loose = begins.then_some(());
    loop {
        impact.clear();
        let time = if loose.take().is_some() {
            impact.let_loose_go(&mut bodies, &grid, &playfield);
            0.0
        } else if let Some(index) = push.take() {
            if let Some(ball) = bodies.all.iter().position(|body| body.index == index) {
                impact.push_off(&mut bodies, &grid, &playfield, ball);
            }
            0.0
        } else if let Some(contact) = contacts.next(&bodies) {
            if contact.kind.other().is_some() && bodies.locate {
                impact.meet(&mut bodies, &grid, &playfield, &contact);
            } else {
                impact
                    .events
                    .push(happen(&mut bodies, &playfield, &contact));
                impact.changed.push(contact.ball);
                impact.changed.extend(other(&contact));
            }
            contact.time
        } else {
            break;
        };
        for &ball in &impact.changed {
            let body = &bodies.all[ball];
            turned.write(PathTurned {
                ball: body.index,
                piece: PathPiece {
                    time: bodies.start + body.since,
                    piece: body.piece,
                },
            });
        }
        for &ball in &impact.changed {
            grid.list(&mut bodies, ball, time);
        }
        for &ball in &impact.changed {
            look_ahead(&grid, &bodies, &mut contacts, &playfield, ball, time);
        }
        for event in impact.events.drain(..) {
            match event.kind {
                EventKind::Pocketed { .. } => {
                    pocketed.write(Pocketed(event));
                }
                EventKind::Motion { .. } => {
                    changed.write(MotionChanged(event));
                }
                _ => {
                    touched.write(Touched(event));
                }
            }
        }
    }
    if let Some((ball, reason)) = contacts.failure.take() {
        failed.write(Failed {
            time: bodies.start,
            reason: format!("ball {}: {reason}", bodies.all[ball].index),
        });
    }
}

fn other(contact: &Contact) -> Option<usize> {
    match contact.kind {
        Kind::Ball(other, _) => Some(other),
        _ => None,
    }
}

/// Finds what the new path of a ball leads to.
fn look_ahead(
    grid: &Grid,
    bodies: &Bodies,
    contacts: &mut Contacts,
    playfield: &Playfield,
    ball: usize,
    time: f64,
) {
    contacts.find_change(bodies, ball);
    let body = &bodies.all[ball];
    if !body.is_in_play() || body.impacts > IMPACTS {
        return;
    }
    grid.neighbours(bodies, ball, |other| {
        if bodies.all[other].impacts <= IMPACTS {
            contacts.find_pair(bodies, ball, other, time);
        }
    });
    collide_cushions::find(grid, bodies, contacts, playfield, ball, time);
}

/// Applies the law of a contact and puts the balls on their new paths.
fn happen(bodies: &mut Bodies, playfield: &Playfield, contact: &Contact) -> Event {
    let Contact {
        time, kind, ball, ..
    } = *contact;
    let laws = &playfield.laws;
    let table = &playfield.table;
    let before = bodies.all[ball].at(time);
    let body = bodies.all[ball].ball;
    let settled = |impacts: u32| (impacts >= BOUNCES).then_some(0.0);
    let mut event = Event {
        time: bodies.start + time,
        kind: EventKind::BallBall,
        first: Participant {
            ball: bodies.all[ball].index,
            before,
            after: before,
        },
        second: None,
        impulse: 0.0,
    };
    match kind {
        Kind::Change => {
            let after = laws.end(table, &body, &bodies.all[ball].piece);
            event.kind = EventKind::Motion {
                from: before.motion,
                to: after.motion,
            };
            event.first.after = after;
        }
        Kind::Pocket(pocket) => {
            (event.kind, event.first.after) =
                airborne::pass_edge(table, laws, &body, &before, pocket);
        }
        Kind::Landing(landing) => {
            (event.kind, event.first.after, event.impulse) =
                airborne::land(table, laws, &body, &before, landing);
        }
        Kind::Cushion(cushion) => {
            let nose = &table.cushions[cushion];
            let restitution = settled(bodies.all[ball].impacts);
            let rebound = laws
                .cushion
                .meet(table, nose, (&body, &before), restitution);
            event.kind = EventKind::Cushion { cushion };
            event.impulse = rebound.impulse;
            event.first.after = laws.settled(table, &body, &rebound.state);
            bodies.all[ball].impacts += 1;
        }
        Kind::Ball(other, _) => {
            let second = bodies.all[other].at(time);
            let second_body = bodies.all[other].ball;
            let mut meeting = PairContact::between(&before, &second);
            meeting.restitution = settled(bodies.all[ball].impacts.max(bodies.all[other].impacts));
            let outcome =
                laws.ball_ball
                    .collide((&body, &before), (&second_body, &second), &meeting);
            event.impulse = outcome.impulse;
            event.first.after = laws.settled(table, &body, &outcome.first);
            let after = laws.settled(table, &second_body, &outcome.second);
            event.second = Some(Participant {
                ball: bodies.all[other].index,
                before: second,
                after,
            });
            bodies.all[ball].impacts += 1;
            bodies.all[other].impacts += 1;
            follow(bodies, playfield, other, &after, time);
        }
    }
    follow(bodies, playfield, ball, &event.first.after, time);
    event
}

fn follow(bodies: &mut Bodies, playfield: &Playfield, ball: usize, state: &State, time: f64) {
    bodies.all[ball].follow(playfield, state, time);
}
