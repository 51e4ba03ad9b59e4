//! What a referee sees in a record: first contacts, cushions reached, balls potted, hung or driven off.
//!
//! Everything is derived from the events and the closed-form paths of the record; nothing is sampled.

use glam::DVec2;

use crate::physics::ball::Motion;
use crate::physics::laws::motion::Piece;
use crate::physics::record::{Event, EventKind, Participant, Record};
use crate::physics::scene::Scene;

/// Two contacts within this time in s came together: no referee could tell which was first.
pub const TIE: f64 = 1e-6;

/// Two things nearer than this in m are frozen to each other. Balls that came to rest against something lie within some
/// micrometres of it.
pub const FROZEN: f64 = 5e-5;

/// Time in s after which a ball that hung motionless at a pocket no longer falls by the shot (WPA rules of play 2025,
/// balls settling into place).
pub const HANGS: f64 = 5.0;

/// A ball in a pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Potted {
    /// Index of the ball.
    pub ball: usize,
    /// Index of the pocket.
    pub pocket: usize,
    /// When, s.
    pub time: f64,
}

/// A cushion that a ball was driven to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// When, s.
    pub time: f64,
    /// Index of the cushion.
    pub cushion: usize,
}

/// A record under the eyes of a referee.
#[derive(Clone, Debug)]
pub struct Facts<'a> {
    /// The table before the stroke.
    pub scene: &'a Scene,
    /// What happened.
    pub record: &'a Record,
    /// Index of the cue ball.
    pub cue: usize,
    /// When the cue ball first met another ball, s.
    pub first_time: Option<f64>,
    /// The balls that it met then: several if they came together.
    pub first: Vec<usize>,
    /// Every ball that fell, the cue ball too, in order of time.
    pub potted: Vec<Potted>,
    /// Every ball that left the table, the cue ball too.
    pub off: Vec<usize>,
    /// Balls that hung for longer than [`HANGS`] and then fell by themselves: they are put back where they hung.
    pub fell_late: Vec<(usize, DVec2)>,
}

impl<'a> Facts<'a> {
    /// Looks at the record of a stroke with this cue ball.
    #[must_use]
    pub fn new(scene: &'a Scene, record: &'a Record, cue: usize) -> Self {
        let mut facts = Self {
            scene,
            record,
            cue,
            first_time: None,
            first: Vec::new(),
            potted: Vec::new(),
            off: Vec::new(),
            fell_late: Vec::new(),
        };
        let met: Vec<(f64, usize)> = facts.met_by(cue).collect();
        for (time, other) in met {
            let first = *facts.first_time.get_or_insert(time);
            if time - first <= TIE && !facts.first.contains(&other) {
                facts.first.push(other);
            }
        }
        for (ball, placed) in scene.balls.iter().enumerate() {
            if !placed.state.motion.in_play() {
                continue;
            }
            let Some(end) = record.end.get(ball) else {
                continue;
            };
            match end.motion {
                Motion::OffTable => facts.off.push(ball),
                _ => facts.look_for_pot(ball),
            }
        }
        facts.potted.sort_by(|a, b| a.time.total_cmp(&b.time));
        facts
    }

    /// Adds a ball that lies in a pocket at the end, or is about to.
    fn look_for_pot(&mut self, ball: usize) {
        let end = &self.record.end[ball];
        let plan = DVec2::new(end.position.x, end.position.z);
        let last = self
            .events_of(ball)
            .filter_map(|event| match event.kind {
                EventKind::Pocketed { pocket } => Some((event.time, pocket)),
                _ => None,
            })
            .last();
        if end.motion == Motion::Pocketed {
            let (time, pocket) = last.unwrap_or((self.record.end_time, self.pocket_at(plan)));
            match self.hung_until(ball, time) {
                Some(spot) => self.fell_late.push((ball, spot)),
                None => self.potted.push(Potted { ball, pocket, time }),
            }
        } else if let Some(pocket) = self.over_hole(plan) {
            // Only another ball holds it up there: it falls when that is lifted.
            let time = self.record.end_time;
            self.potted.push(Potted { ball, pocket, time });
        }
    }

    /// Where a ball hung motionless for longer than [`HANGS`] before it fell at this time without being touched again.
    fn hung_until(&self, ball: usize, fell: f64) -> Option<DVec2> {
        let rest = self
            .events_of(ball)
            .filter(|event| event.time < fell)
            .filter(|event| {
                !matches!(
                    event.kind,
                    EventKind::Motion { to, .. } if to.translates()
                )
            })
            .last()?;
        let EventKind::Motion {
            to: Motion::Rest, ..
        } = rest.kind
        else {
            return None;
        };
        let place = rest.first.after.position;
        (fell - rest.time > HANGS).then_some(DVec2::new(place.x, place.z))
    }

    fn over_hole(&self, plan: DVec2) -> Option<usize> {
        let mut pockets = self.scene.table.pockets.iter();
        pockets.position(|pocket| plan.distance(pocket.center) < pocket.radius)
    }

    fn pocket_at(&self, plan: DVec2) -> usize {
        super::call::nearest_pocket(&self.scene.table, plan).unwrap_or(0)
    }

    /// The events of one ball, in order of time.
    pub fn events_of(&self, ball: usize) -> impl Iterator<Item = &'a Event> {
        let record: &'a Record = self.record;
        let takes_part = move |event: &&Event| event.participants().any(|who| who.ball == ball);
        record.events.iter().filter(takes_part)
    }

    /// Every contact of a ball with other balls: when, and with which.
    pub fn met_by(&self, ball: usize) -> impl Iterator<Item = (f64, usize)> {
        let record: &'a Record = self.record;
        record.events.iter().filter_map(move |event| {
            let second = event.second.as_ref()?;
            let is_meeting = event.kind == EventKind::BallBall;
            match (event.first.ball, second.ball) {
                (one, other) if one == ball && is_meeting => Some((event.time, other)),
                (other, one) if one == ball && is_meeting => Some((event.time, other)),
                _ => None,
            }
        })
    }

    /// Whether the ball is frozen to this cushion before the stroke.
    #[must_use]
    pub fn is_frozen_to(&self, ball: usize, cushion: usize) -> bool {
        let placed = &self.scene.balls[ball];
        let position = placed.state.position;
        self.gap(ball, cushion, DVec2::new(position.x, position.z)) <= FROZEN
    }

    /// Whether two balls are frozen to each other before the stroke.
    #[must_use]
    pub fn are_frozen(&self, one: usize, other: usize) -> bool {
        let (one, other) = (&self.scene.balls[one], &self.scene.balls[other]);
        let reach = one.ball.radius + other.ball.radius;
        one.state.motion.in_play()
            && other.state.motion.in_play()
            && one.state.position.distance(other.state.position) - reach <= FROZEN
    }

    fn gap(&self, ball: usize, cushion: usize, plan: DVec2) -> f64 {
        let table = &self.scene.table;
        let reach = table.reach(self.scene.balls[ball].ball.radius);
        table.cushions[cushion].nearest(plan).0 - reach
    }

    /// The cushions that a ball was driven to, in order of time. A ball that stays in touch with a cushion touches it
    /// once; one that was frozen to it before the stroke must leave it and come back.
    #[must_use]
    pub fn cushions_of(&self, ball: usize) -> Vec<Reached> {
        let mut reached: Vec<Reached> = Vec::new();
        let mut last: Vec<(usize, f64)> = (0..self.scene.table.cushions.len())
            .filter(|&cushion| self.is_frozen_to(ball, cushion))
            .map(|cushion| (cushion, 0.0))
            .collect();
        for event in self.events_of(ball) {
            let EventKind::Cushion { cushion } = event.kind else {
                continue;
            };
            let time = event.time;
            match last.iter_mut().find(|(known, _)| *known == cushion) {
                Some((_, since)) => {
                    let left = self.leaves(ball, cushion, *since, time);
                    *since = time;
                    if !left {
                        continue;
                    }
                }
                None => last.push((cushion, time)),
            }
            reached.push(Reached { time, cushion });
        }
        reached
    }

    /// Whether the ball was clear of the cushion at some moment between two times: looked for where each piece of its
    /// path begins, ends and is half over, which is where a parabola that leaves and comes back is farthest.
    fn leaves(&self, ball: usize, cushion: usize, from: f64, to: f64) -> bool {
        let mut times = vec![from, to];
        times.extend(
            self.record.paths[ball]
                .iter()
                .map(|path| path.time)
                .filter(|time| *time > from && *time < to),
        );
        times.sort_by(f64::total_cmp);
        let clear = |time: f64| {
            let place = self.record.state_at(ball, time).position;
            self.gap(ball, cushion, DVec2::new(place.x, place.z)) > FROZEN
        };
        times
            .windows(2)
            .any(|pair| clear(0.5 * (pair[0] + pair[1])) || (pair[1] < to && clear(pair[1])))
    }

    /// Whether any ball, the cue ball too, was driven to a cushion at or after the first contact.
    #[must_use]
    pub fn is_cushion_reached(&self) -> bool {
        let Some(first) = self.first_time else {
            return false;
        };
        (0..self.scene.balls.len())
            .flat_map(|ball| self.cushions_of(ball))
            .any(|reached| reached.time >= first)
    }

    /// How many balls, the cue ball not among them, were driven to a cushion.
    #[must_use]
    pub fn driven_to_cushions(&self) -> usize {
        (0..self.scene.balls.len())
            .filter(|&ball| ball != self.cue && !self.cushions_of(ball).is_empty())
            .count()
    }

    /// The object balls that fell.
    pub fn object_potted(&self) -> impl Iterator<Item = &Potted> {
        self.potted.iter().filter(|potted| potted.ball != self.cue)
    }

    /// The object balls that left the table.
    pub fn object_off(&self) -> impl Iterator<Item = usize> {
        self.off.iter().copied().filter(|&ball| ball != self.cue)
    }

    /// The pocket that took the cue ball.
    #[must_use]
    pub fn scratch(&self) -> Option<usize> {
        let mut potted = self.potted.iter();
        potted
            .find(|potted| potted.ball == self.cue)
            .map(|potted| potted.pocket)
    }

    /// How this ball fell, if it did.
    #[must_use]
    pub fn potted(&self, ball: usize) -> Option<&Potted> {
        self.potted.iter().find(|potted| potted.ball == ball)
    }

    /// Whether everybody could see this pot coming: the cue ball went straight to the ball, and the ball straight into
    /// its pocket, without another ball and without a cushion but the jaws of that pocket.
    #[must_use]
    pub fn is_obvious(&self, potted: &Potted) -> bool {
        let Some(first) = self.first_time else {
            return false;
        };
        let straight_to = self
            .cushions_of(self.cue)
            .iter()
            .all(|reached| reached.time >= first);
        let alone = self
            .met_by(potted.ball)
            .all(|(time, other)| other == self.cue && time - first <= TIE || time > potted.time);
        let pocket = &self.scene.table.pockets[potted.pocket];
        let straight_in = self.cushions_of(potted.ball).iter().all(|reached| {
            let place = self.record.state_at(potted.ball, reached.time).position;
            let distance = DVec2::new(place.x, place.z).distance(pocket.center);
            distance < 2.5 * pocket.radius
        });
        self.first.contains(&potted.ball) && straight_to && alone && straight_in
    }

    /// The least x in m that the centre of a ball ever had: how far it came towards the head.
    #[must_use]
    pub fn least_x(&self, ball: usize) -> f64 {
        let path = &self.record.paths[ball];
        let mut least = self.record.end[ball].position.x;
        for (index, piece) in path.iter().enumerate() {
            let until = path
                .get(index + 1)
                .map_or(self.record.end_time, |next| next.time);
            least = least.min(reach_on(&piece.piece, (until - piece.time).max(0.0)).0);
        }
        least
    }

    /// Whether the centre of the cue ball came beyond this x in m before it met another ball.
    #[must_use]
    pub fn crosses_before_contact(&self, line: f64) -> bool {
        let until = self.first_time.unwrap_or(self.record.end_time);
        let path = &self.record.paths[self.cue];
        path.iter().enumerate().any(|(index, piece)| {
            let end = path
                .get(index + 1)
                .map_or(until, |next| next.time.min(until));
            piece.time <= until && reach_on(&piece.piece, (end - piece.time).max(0.0)).1 > line
        })
    }

    /// What became of the cue ball by the stroke: the state after the tip left it.
    #[must_use]
    pub fn stroke(&self) -> Option<&'a Participant> {
        let record: &'a Record = self.record;
        let strike = |event: &&Event| matches!(event.kind, EventKind::Strike { .. });
        record.events.iter().find(strike).map(|event| &event.first)
    }
}

/// Least and greatest x of a piece within its first seconds.
fn reach_on(piece: &Piece, duration: f64) -> (f64, f64) {
    let (velocity, acceleration) = (piece.start.velocity.x, piece.acceleration.x);
    let turn = if acceleration == 0.0 {
        0.0
    } else {
        (-velocity / acceleration).clamp(0.0, duration)
    };
    let places = [0.0, turn, duration].map(|time| piece.position(time).x);
    let least = places.into_iter().fold(f64::INFINITY, f64::min);
    let greatest = places.into_iter().fold(f64::NEG_INFINITY, f64::max);
    (least, greatest)
}
