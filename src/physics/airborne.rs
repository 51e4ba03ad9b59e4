//! Balls that are off the flat of the slate: on what they come down, and what that does to them. Both solvers ask here.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::contact::{Track, flight};
use crate::physics::laws::Laws;
use crate::physics::laws::cluster::{Inside, Other, SLOW, inside, put_off};
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::record::EventKind;
use crate::physics::roots::RootError;
use crate::physics::table::{FLOOR, Ground, Nose, RAIL, Table};

/// How a fall ends, or is turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Landing {
    /// On the slate.
    Slate,
    /// Against the edge of this pocket.
    Rim(usize),
    /// Against the wall of this pocket below the slate, or its liner above.
    Wall(usize),
    /// On the bottom of this pocket.
    Bottom(usize),
    /// On a rail, or on the floor.
    Off,
}

impl Landing {
    /// What it is that touches, if the fall may go on.
    #[must_use]
    pub fn other(self) -> Option<Other> {
        match self {
            Self::Rim(pocket) => Some(Other::Rim(pocket as u32)),
            Self::Wall(pocket) => Some(Other::Wall(pocket as u32)),
            Self::Slate | Self::Bottom(_) | Self::Off => None,
        }
    }
}

fn plan(track: &Track, time: f64) -> DVec2 {
    let position = track.at(time);
    DVec2::new(position.x, position.z)
}

/// When within `horizon` s, and on what, a ball of this radius comes down if no cushion, pocket or ball is in its way.
/// A rail is as high as its nose and reaches [`RAIL`] m back.
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn ground(
    table: &Table,
    laws: &Laws,
    radius: f64,
    track: &Track,
    horizon: f64,
) -> Result<Option<(f64, Landing)>, RootError> {
    let floor = || -> Result<_, RootError> {
        let time = flight::fall(track, FLOOR + radius, horizon)?;
        Ok(time.map(|time| (time, Landing::Off)))
    };
    let is_over_rail = |time: f64| table.beyond(plan(track, time)) <= RAIL;
    if let Nose::Round { .. } = table.nose {
        let time = flight::fall(track, table.nose_height + radius, horizon)?;
        let is_off = |time: &f64| *time > 0.0 && table.ground(plan(track, *time)) == Ground::Off;
        if let Some(time) = time.filter(is_off) {
            return if is_over_rail(time) {
                Ok(Some((time, Landing::Off)))
            } else {
                floor()
            };
        }
    }
    let Some(time) = flight::fall(track, radius, horizon)? else {
        return Ok(None);
    };
    match table.ground(plan(track, time)) {
        Ground::Slate => Ok(Some((time, Landing::Slate))),
        Ground::Hole(pocket) if laws.pocket == PocketLaw::Capture => {
            Ok(Some((time, Landing::Bottom(pocket))))
        }
        Ground::Off if is_over_rail(time) => Ok(Some((time, Landing::Off))),
        // Over a hole the pocket comes first; the floor bounds the search for it.
        Ground::Hole(_) | Ground::Off => floor(),
    }
}

/// When within `horizon` s a ball with this motion meets the inside of a pocket. `ages` tells how many seconds ago it last
/// touched it; see [`put_off`].
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn pocket(
    table: &Table,
    laws: &Laws,
    index: usize,
    (radius, motion): (f64, Motion),
    track: &Track,
    horizon: f64,
    ages: impl Fn(Other) -> f64,
) -> Result<Option<(f64, Landing)>, RootError> {
    let PocketLaw::Rim(rim) = laws.pocket else {
        return Ok(None);
    };
    let hole = &table.pockets[index];
    let mut first = flight::fall(track, -hole.depth, horizon)?
        .filter(|time| plan(track, *time).distance(hole.center) < hole.radius)
        .map(|time| (time, Landing::Bottom(index)));
    if motion == Motion::Airborne {
        let until = first.map_or(horizon, |(time, _)| time);
        let wall = flight::wall(track, (table, hole), rim.edge, radius, until)?.map(|wait| {
            put_off(wait, ages(Other::Wall(index as u32)), |time| {
                flight::overlap_of_wall(track, hole, rim.edge, radius, time)
            })
        });
        let wall = wall.filter(|wait| *wait <= until);
        let until = wall.unwrap_or(until);
        // One that sinks into the edge slowly is let wait by the search itself.
        let edge = flight::rim(track, hole, rim.edge, radius, until)?;
        first = edge
            .map(|time| (time, Landing::Rim(index)))
            .or(wall.map(|time| (time, Landing::Wall(index))))
            .or(first);
    }
    Ok(first)
}

/// What a landing is called, the ball after it, and the impulse of the blow in N s; 0 where the fall ends.
#[must_use]
pub fn land(
    table: &Table,
    laws: &Laws,
    ball: &Ball,
    state: &State,
    landing: Landing,
) -> (EventKind, State, f64) {
    match landing {
        Landing::Slate => {
            let mut landed = laws.slate.land(ball, state);
            landed.position.y = ball.radius;
            let after = laws.motion.classify(ball, landed);
            let impulse = ball.mass * (after.velocity - state.velocity).length();
            (EventKind::Slate, after, impulse)
        }
        Landing::Rim(pocket) | Landing::Wall(pocket) => {
            let on_edge = matches!(landing, Landing::Rim(_));
            let kind = EventKind::Rim { pocket };
            let met = landing.other();
            let met = met.and_then(|what| inside(laws, table, (ball, state), what));
            let Some(Inside { normal, .. }) = met else {
                return (kind, *state, 0.0);
            };
            let after = laws.rattle((ball, state), on_edge, normal, None);
            let impulse = ball.mass * (after.velocity - state.velocity).dot(normal);
            (kind, laws.settled(table, ball, &after), impulse)
        }
        Landing::Bottom(pocket) => {
            let after = laws.pocket.captured(&table.pockets[pocket]);
            (EventKind::Pocketed { pocket }, after, 0.0)
        }
        Landing::Off => {
            let mut gone = State::at_rest(state.position);
            gone.motion = Motion::OffTable;
            (EventKind::OffTable, gone, 0.0)
        }
    }
}

/// Whether a ball that touches this part of a pocket comes and leaves too fast for lasting contact.
#[must_use]
pub fn is_fast(
    (table, laws, ball): (&Table, &Laws, &Ball),
    before: &State,
    after: &State,
    what: Other,
) -> bool {
    let met = inside(laws, table, (ball, before), what);
    met.is_some_and(|Inside { normal, .. }| {
        before.velocity.dot(normal) <= -SLOW && after.velocity.dot(normal) >= SLOW
    })
}

/// What happens to a ball on the slate whose centre passes the edge of a pocket.
#[must_use]
pub fn pass_edge(
    table: &Table,
    laws: &Laws,
    ball: &Ball,
    state: &State,
    pocket: usize,
) -> (EventKind, State) {
    let after = laws.drop(&table.pockets[pocket], ball, state);
    let kind = if after.motion == Motion::Pocketed {
        EventKind::Pocketed { pocket }
    } else {
        EventKind::Motion {
            from: state.motion,
            to: after.motion,
        }
    };
    (kind, after)
}
