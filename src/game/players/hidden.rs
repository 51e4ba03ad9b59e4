//! The raised cue: over the balls that hide the one that is on, or around them.
//!
//! A jump lets the cue ball fly over what is in the way; a massé, with the cue raised and english, bends its path around.
//! Geometry names the directions, rehearsals find the elevation and the speed. Where a game forbids jumps its rules say so
//! when they judge the rehearsal.

use crate::game::players::aiming;
use crate::game::players::chance::Lane;
use crate::game::players::idea::{Idea, Kind, Line, call_pot, call_safety};
use crate::game::players::ideas::View;
use crate::game::players::screen::level;
use crate::game::players::sight::{Seen, angle, toward};
use crate::game::players::thinking::Thinking;
use crate::physics::cue::Shot;

/// Hidden balls that are looked at, the nearest first.
const BALLS: usize = 3;

/// Room in diameters that a jump needs before the first ball in its way, to rise, and behind the last, to come down.
const ROOM: f64 = 1.5;

/// Directions of a jump at a ball, rad from a full hit times the angle at which it is missed.
const HITS: [f64; 3] = [0.0, 0.5, -0.5];

/// Elevations of the cue in rad of jumps.
const JUMP_ELEVATIONS: [f64; 3] = [0.55, 0.75, 0.95];

/// Speeds of the cue in m/s of jumps.
const JUMP_SPEEDS: [f64; 4] = [2.2, 3.0, 3.8, 5.0];

/// Elevations of the cue in rad of massés.
const CURVE_ELEVATIONS: [f64; 3] = [0.5, 0.8, 1.1];

/// Speeds of the cue in m/s of massés.
const CURVE_SPEEDS: [f64; 4] = [1.4, 2.0, 2.8, 3.8];

/// English of massés in R, to the side to which the ball is to bend, and height.
const CURVE_TIP: (f64, f64) = (0.4, -0.2);

/// How far in rad beyond the grazing line past the ball in the way a massé begins.
const CURVE_STARTS: [f64; 4] = [0.02, 0.1, 0.2, 0.32];

/// Least cosine of the cut angle of a jump that is to pot.
const FULL: f64 = 0.6;

impl View<'_> {
    /// Jumps and massés at balls that cannot be met straight.
    #[must_use]
    pub fn raised(&self) -> Vec<Idea> {
        let mut ideas = Vec::new();
        for seen in self.hidden() {
            ideas.extend(self.jump_pots(seen));
            ideas.extend(self.jumps(seen));
            ideas.extend(self.curves(seen));
        }
        ideas
    }

    /// Balls that may be met first with something in the way, the nearest first.
    fn hidden(&self) -> Vec<&Seen> {
        let mut hidden: Vec<&Seen> = self
            .on
            .first
            .iter()
            .filter_map(|&ball| self.sight.ball(ball))
            .filter(|seen| seen.ball != self.cue.ball && !self.in_the_way(seen).is_empty())
            .collect();
        let distance = |seen: &Seen| seen.at.distance_squared(self.cue.at);
        hidden.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        hidden.truncate(BALLS);
        hidden
    }

    /// How far along the straight way to a ball the balls in the way of it lie, m, the nearest first.
    fn in_the_way(&self, to: &Seen) -> Vec<(f64, &Seen)> {
        let way = (to.at - self.cue.at).normalize_or_zero();
        let end = to.at.distance(self.cue.at);
        let mut found: Vec<(f64, &Seen)> = self
            .sight
            .balls
            .iter()
            .filter(|seen| ![to.ball, self.cue.ball].contains(&seen.ball))
            .map(|seen| ((seen.at - self.cue.at).dot(way), seen))
            .filter(|&(along, seen)| {
                let off = (seen.at - self.cue.at).perp_dot(way).abs();
                (0.0..end).contains(&along) && off < self.cue.radius + seen.radius
            })
            .collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        found
    }

    fn has_room_to_jump(&self, to: &Seen) -> bool {
        let room = ROOM * 2.0 * self.cue.radius;
        let found = self.in_the_way(to);
        match (found.first(), found.last()) {
            (Some((first, _)), Some((last, _))) => {
                *first > room && to.at.distance(self.cue.at) - last > room
            }
            _ => false,
        }
    }

    fn of(&self, kind: Kind, line: Line, call: crate::game::rules::Call) -> Idea {
        Idea {
            kind,
            spot: self.spot,
            call,
            line,
            chance: 0.0,
        }
    }

    /// Jumps that pot the ball.
    fn jump_pots(&self, seen: &Seen) -> Vec<Idea> {
        if !self.on.pot.contains(&seen.ball) || !self.has_room_to_jump(seen) {
            return Vec::new();
        }
        let lanes = self.on.pockets.iter();
        lanes
            .filter_map(|&pocket| self.eye.lane(self.sight, seen, pocket, &self.cue))
            .filter(|lane| {
                let to = (lane.ghost - self.cue.at).normalize_or_zero();
                to.dot(toward(lane.angle)) > FULL
            })
            .map(|lane| {
                let call = call_pot(self.on, lane.ball, lane.pocket);
                self.of(Kind::Jump, Line::Send(lane), call)
            })
            .collect()
    }

    /// Jumps that meet the ball.
    fn jumps(&self, seen: &Seen) -> Vec<Idea> {
        if !self.has_room_to_jump(seen) {
            return Vec::new();
        }
        let to = seen.at - self.cue.at;
        let missed = libm::asin(((seen.radius + self.cue.radius) / to.length()).min(1.0));
        let call = call_safety(self.on, seen.ball);
        HITS.into_iter()
            .map(|part| self.of(Kind::Jump, Line::Along(angle(to) + part * missed), call))
            .collect()
    }

    /// Ways past the first ball in the way on either side, to bend back from.
    fn curves(&self, seen: &Seen) -> Vec<Idea> {
        let Some((_, first)) = self.in_the_way(seen).first().copied() else {
            return Vec::new();
        };
        let to = first.at - self.cue.at;
        let missed = libm::asin(((first.radius + self.cue.radius) / to.length()).min(1.0));
        let call = call_safety(self.on, seen.ball);
        [1.0, -1.0]
            .into_iter()
            .map(|side| {
                let line = Line::Past {
                    angle: angle(to) + side * missed,
                    side,
                };
                self.of(Kind::Masse, line, call)
            })
            .collect()
    }
}

impl Thinking {
    /// Tries elevations and speeds of a jump. How sure it is shows when it is rehearsed with errors.
    pub(super) fn screen_jump(&mut self, idea: &Idea, angle: f64, lane: Option<&Lane>) {
        for elevation in JUMP_ELEVATIONS {
            let raised = self.raised(&Shot {
                elevation,
                ..level(angle)
            });
            for speed in JUMP_SPEEDS {
                let mut shot = Shot { speed, ..raised };
                if let Some(lane) = lane {
                    let found = aiming::heading(&mut self.rehearsal, self.on.cue, lane, &shot);
                    let Some(heading) = found else { continue };
                    shot.heading = heading;
                }
                self.try_raised(idea, shot, lane.is_some());
            }
        }
    }

    /// Tries elevations, speeds and beginnings of a massé that passes a ball along this angle and bends back.
    pub(super) fn screen_masse(&mut self, idea: &Idea, angle: f64, side: f64) {
        let (english, height) = CURVE_TIP;
        for elevation in CURVE_ELEVATIONS {
            for start in CURVE_STARTS {
                let raised = self.raised(&Shot {
                    heading: -(angle + side * start),
                    elevation,
                    // Angles in plan grow clockwise as seen from above: past the right, back to the left.
                    side: -side * english,
                    height,
                    speed: 1.0,
                });
                for speed in CURVE_SPEEDS {
                    self.try_raised(idea, Shot { speed, ..raised }, false);
                }
            }
        }
    }

    fn try_raised(&mut self, idea: &Idea, shot: Shot, pots: bool) {
        let Some(outcome) = self.rehearse(&idea.call, &shot, false) else {
            return;
        };
        if if pots { outcome.good } else { outcome.clean } {
            let value = 0.5 * (outcome.value + self.failed.1);
            self.note(idea, shot, value, 0.5);
        }
    }
}
