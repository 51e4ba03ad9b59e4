//! Ideas from geometry: pots, banks, combinations, kicks and thin hits.

use glam::DVec2;

use crate::game::players::chance::{Eye, Lane};
use crate::game::players::idea::{Idea, Kind, Line, call_pot, call_safety};
use crate::game::players::level::Skills;
use crate::game::players::sight::{Seen, Sight, angle, toward, wrapped};
use crate::game::rules::On;

/// How far in rad a bank may be off the mirror.
const BANK_ERROR: f64 = 0.15;

/// How far in rad the first ball of a combination may be off the eye's line.
const COMBINATION_ERROR: f64 = 0.05;

/// How far in rad a kick may be off the mirror.
const KICK_ERROR: f64 = 0.14;

/// Longest way in m of the first ball of a combination.
const COMBINATION_WAY: f64 = 0.8;

/// Where a ball is hit for a safety: offset of the way of the cue ball from its centre, in the sum of the radii.
const THICKNESSES: [f64; 9] = [0.0, 0.3, -0.3, 0.6, -0.6, 0.85, -0.85, 0.96, -0.96];

/// Thicknesses at which a ball is hit for a carom.
const CAROM_THICKNESSES: u32 = 18;

/// Directions that are tried for a carom off a cushion first.
const CAROM_KICKS: u32 = 60;

/// Everything that is needed to have ideas.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The balls.
    pub sight: &'a Sight,
    /// The player's eye.
    pub eye: &'a Eye,
    /// What is on.
    pub on: &'a On,
    /// The cue ball where it lies, or where it would be put.
    pub cue: Seen,
    /// Where it would be put, if it is in hand.
    pub spot: Option<DVec2>,
    /// What the player thinks of.
    pub skills: &'a Skills,
}

/// The four cushions as mirrors: normal towards the middle and distance of the centre of a ball of this radius that
/// touches it.
fn mirrors(sight: &Sight, radius: f64) -> [(DVec2, f64); 4] {
    let at = sight.half - radius;
    [
        (DVec2::NEG_X, at.x),
        (DVec2::X, at.x),
        (DVec2::NEG_Y, at.y),
        (DVec2::Y, at.y),
    ]
}

fn mirrored(point: DVec2, (normal, distance): (DVec2, f64)) -> DVec2 {
    point - 2.0 * (point.dot(normal) + distance) * normal
}

/// Where the way to a mirrored point meets the mirror.
fn turning_point(from: DVec2, image: DVec2, (normal, distance): (DVec2, f64)) -> Option<DVec2> {
    let (a, b) = (from.dot(normal) + distance, image.dot(normal) + distance);
    (a > 1e-6 && b < -1e-6).then(|| from + a / (a - b) * (image - from))
}

impl View<'_> {
    fn idea(&self, kind: Kind, line: Line, chance: f64) -> Idea {
        Idea {
            kind,
            spot: self.spot,
            call: crate::game::rules::Call::Nothing,
            line,
            chance,
        }
    }

    /// Direct pots, the likeliest first.
    #[must_use]
    pub fn pots(&self) -> Vec<Idea> {
        let mut ideas: Vec<Idea> = self
            .eye
            .lanes(self.sight, self.on, &self.cue)
            .into_iter()
            .map(|lane| {
                let chance = self.eye.chance(self.sight, &lane, &self.cue);
                let call = call_pot(self.on, lane.ball, lane.pocket);
                Idea {
                    call,
                    ..self.idea(Kind::Pot, Line::Send(lane), chance)
                }
            })
            .filter(|idea| idea.chance > 0.02)
            .collect();
        best_first(&mut ideas, self.skills.pots);
        ideas
    }

    /// Balls off one cushion into a pocket.
    #[must_use]
    pub fn banks(&self) -> Vec<Idea> {
        let mut ideas = Vec::new();
        if self.skills.banks == 0 {
            return ideas;
        }
        for ball in self.on.pot.iter().filter(|b| self.on.first.contains(b)) {
            let Some(seen) = self.sight.ball(*ball) else {
                continue;
            };
            for mirror in mirrors(self.sight, seen.radius) {
                for &pocket in &self.on.pockets {
                    ideas.extend(self.bank(seen, mirror, pocket));
                }
            }
        }
        best_first(&mut ideas, self.skills.banks);
        ideas
    }

    fn bank(&self, seen: &Seen, mirror: (DVec2, f64), pocket: usize) -> Option<Idea> {
        let mouth = self.eye.mouths.get(pocket)?;
        let goal = mouth.middle();
        let image = mirrored(goal, mirror);
        let turn = turning_point(seen.at, image, mirror)?;
        // Into a pocket of the cushion itself, or along it, nothing is banked.
        if (turn - goal).dot(mirror.0).abs() < 0.25 {
            return None;
        }
        let but = [seen.ball, self.cue.ball];
        let free = self.sight.is_free(seen.at, turn, seen.radius, but)
            && self.sight.is_free(turn, goal, seen.radius, but);
        let (_, half) = mouth.window(turn, seen.radius).filter(|_| free)?;
        let way = (turn - seen.at).try_normalize()?;
        let length = seen.at.distance(turn) + turn.distance(goal);
        let lane = Lane {
            ball: seen.ball,
            pocket,
            from: seen.at,
            angle: angle(way),
            half: half * turn.distance(goal) / length,
            ghost: seen.at - (seen.radius + self.cue.radius) * way,
        };
        let chance = 0.7 * self.eye.chance(self.sight, &lane, &self.cue);
        (chance > 0.01).then(|| Idea {
            call: call_pot(self.on, seen.ball, pocket),
            ..self.idea(Kind::Bank, self.search(&lane, BANK_ERROR), chance)
        })
    }

    /// The search for the angle of the cue ball that sends a ball along a lane, give or take an error in rad.
    fn search(&self, lane: &Lane, error: f64) -> Line {
        let way = lane.ghost - self.cue.at;
        let reach = (lane.from - lane.ghost).length();
        let cosine = way.dot(lane.from - lane.ghost) / (way.length() * reach).max(1e-9);
        Line::Search {
            angle: angle(way),
            spread: error * reach * cosine.max(0.2) / way.length().max(reach),
        }
    }

    /// A ball onto another that falls.
    #[must_use]
    pub fn combinations(&self) -> Vec<Idea> {
        let mut ideas = Vec::new();
        if self.skills.combinations == 0 {
            return ideas;
        }
        for second in self.on.pot.iter().filter_map(|&b| self.sight.ball(b)) {
            for first in self.on.first.iter().filter_map(|&b| self.sight.ball(b)) {
                if first.ball == second.ball || first.ball == self.cue.ball {
                    continue;
                }
                for &pocket in &self.on.pockets {
                    ideas.extend(self.combination(first, second, pocket));
                }
            }
        }
        best_first(&mut ideas, self.skills.combinations);
        ideas
    }

    fn combination(&self, first: &Seen, second: &Seen, pocket: usize) -> Option<Idea> {
        let lane = self.eye.lane(self.sight, second, pocket, first)?;
        let way = lane.ghost - first.at;
        let distance = way.length();
        let cosine = way.dot(toward(lane.angle)) / distance.max(1e-9);
        if distance > COMBINATION_WAY || (distance > 1e-3 && cosine < 0.4) {
            return None;
        }
        let way = if distance > 1e-3 {
            way / distance
        } else {
            toward(lane.angle)
        };
        let but = [first.ball, second.ball];
        if !self.sight.is_free(first.at, lane.ghost, first.radius, but) {
            return None;
        }
        let reach = first.radius + second.radius;
        let onto = Lane {
            ball: first.ball,
            pocket,
            from: first.at,
            angle: angle(way),
            half: lane.half * reach * cosine.max(0.4) / distance.max(reach),
            ghost: first.at - (first.radius + self.cue.radius) * way,
        };
        let chance = 0.9 * self.eye.chance(self.sight, &onto, &self.cue);
        (chance > 0.01).then(|| Idea {
            call: call_pot(self.on, second.ball, pocket),
            ..self.idea(
                Kind::Combination,
                self.search(&onto, COMBINATION_ERROR),
                chance,
            )
        })
    }

    /// The cue ball off one cushion or two to a ball that may be met first, the shortest ways first.
    #[must_use]
    pub fn kicks(&self, most: usize) -> Vec<Idea> {
        let mirrors = mirrors(self.sight, self.cue.radius);
        let mut ideas = Vec::new();
        for ball in &self.on.first {
            let Some(seen) = self.sight.ball(*ball).filter(|s| s.ball != self.cue.ball) else {
                continue;
            };
            for (i, &first) in mirrors.iter().enumerate() {
                if self.skills.kick_cushions >= 1 {
                    ideas.extend(self.kick(seen, &[first]));
                }
                for (_, &second) in mirrors.iter().enumerate().filter(|(j, _)| *j != i) {
                    if self.skills.kick_cushions >= 2 {
                        ideas.extend(self.kick(seen, &[first, second]));
                    }
                }
            }
        }
        best_first(&mut ideas, most);
        ideas
    }

    fn kick(&self, seen: &Seen, cushions: &[(DVec2, f64)]) -> Option<Idea> {
        let image = cushions
            .iter()
            .rev()
            .fold(seen.at, |point, mirror| mirrored(point, *mirror));
        let turn = turning_point(self.cue.at, image, cushions[0])?;
        let but = [seen.ball, self.cue.ball];
        let mut free = self.sight.is_free(self.cue.at, turn, self.cue.radius, but);
        if cushions.len() == 1 {
            free &= self.sight.is_free(turn, seen.at, self.cue.radius, but);
        }
        let length = self.cue.at.distance(image);
        let spread = KICK_ERROR * cushions.len() as f64;
        free.then(|| Idea {
            call: call_safety(self.on, seen.ball),
            ..self.idea(
                Kind::Kick,
                Line::Search {
                    angle: angle(image - self.cue.at),
                    spread,
                },
                1.0 / (length * cushions.len() as f64),
            )
        })
    }

    /// Hits of every thickness at balls that may be met first, the nearest balls first; `thin` asks for the thin ones too.
    #[must_use]
    pub fn hits(&self, balls: usize, thin: bool) -> Vec<Idea> {
        let mut near: Vec<&Seen> = self
            .on
            .first
            .iter()
            .filter_map(|&ball| self.sight.ball(ball))
            .filter(|seen| seen.ball != self.cue.ball)
            .collect();
        near.sort_by(|a, b| {
            let distance = |seen: &Seen| seen.at.distance_squared(self.cue.at);
            distance(a).total_cmp(&distance(b))
        });
        let mut ideas = Vec::new();
        let mut found = 0;
        for seen in near {
            if found == balls {
                break;
            }
            let before = ideas.len();
            for thickness in THICKNESSES.into_iter().take(if thin { 9 } else { 3 }) {
                ideas.extend(self.hit(seen, thickness));
            }
            found += usize::from(ideas.len() > before);
        }
        ideas
    }

    /// Hits of every thickness at every ball, and ways off a cushion first, for a score by the cue ball alone.
    #[must_use]
    pub fn caroms(&self) -> Vec<Idea> {
        let mut ideas = Vec::new();
        for seen in self.on.first.iter().filter_map(|&b| self.sight.ball(b)) {
            for i in 0..CAROM_THICKNESSES {
                let thickness =
                    0.95 * (2.0 * f64::from(i) / f64::from(CAROM_THICKNESSES - 1) - 1.0);
                ideas.extend(self.hit(seen, thickness));
            }
        }
        for i in 0..CAROM_KICKS {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(CAROM_KICKS);
            ideas.push(self.idea(Kind::Carom, Line::Along(angle), 0.0));
        }
        for idea in &mut ideas {
            // A hit is at least no foul; of a way off a cushion nothing is known.
            idea.chance = if idea.kind == Kind::Carom { 0.0 } else { 0.1 };
            idea.kind = Kind::Carom;
        }
        ideas
    }

    fn hit(&self, seen: &Seen, thickness: f64) -> Option<Idea> {
        let to = seen.at - self.cue.at;
        let (distance, reach) = (to.length(), seen.radius + self.cue.radius);
        let turn = libm::asin((thickness * reach / distance).clamp(-1.0, 1.0));
        let along = wrapped(angle(to) + turn);
        let run =
            (distance * libm::cos(turn) - reach * (1.0 - thickness * thickness).sqrt()).max(0.0);
        let meets = self.cue.at + run * toward(along);
        let free = self.sight.is_free(
            self.cue.at,
            meets,
            self.cue.radius,
            [seen.ball, self.cue.ball],
        );
        free.then(|| Idea {
            call: call_safety(self.on, seen.ball),
            ..self.idea(Kind::Safety, Line::Along(along), 0.0)
        })
    }
}

fn best_first(ideas: &mut Vec<Idea>, most: usize) {
    ideas.sort_by(|a, b| b.chance.total_cmp(&a.chance));
    ideas.truncate(most);
}
