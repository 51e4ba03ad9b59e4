//! The audit of a run: what must hold after every event of whatever scene, by whichever solver.
//!
//! Energy never rises, momentum is kept where nothing but balls acts on balls, nothing overlaps, nobody leaves the table
//! except through a pocket or through the air, time never goes back. An [`Audit`] listens to the engine while it runs, or
//! reads a record afterwards, and keeps the worst of everything; what is too much is for the reader to say.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::exact::Watch;
use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::laws::cluster::{CONTACT_TIME, SLOW, STILL};
use crate::physics::record::{Event, EventKind, Participant, PathPiece, Record};
use crate::physics::scene::Scene;
use crate::physics::table::Ground;

/// Energy in J by which the pieces of a roll over the edge of a pocket are off between their ends, per kg: they leave the
/// arc by up to 0.05 mm.
const TIPPING: f64 = 1e-3;

/// Share of the energy of its spin by which they are off: a spin that turns with the edge is drawn straight through 0.12 rad.
const TURNING: f64 = 0.004;

/// Share of the energy of its way by which they are off: a velocity that turns by 0.12 rad is drawn straight.
const BENDING: f64 = 0.12 * 0.12;

/// The worst that was seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// Largest rise of the energy at one event beyond what lasting contacts and rolls over an edge may add, as a share of
    /// the most energy there ever was.
    pub energy: f64,
    /// Largest change of momentum in an impact of nothing but balls, as a share of the momentum that moved.
    pub momentum: f64,
    /// Deepest overlap of two balls in m.
    pub overlap: f64,
    /// Deepest overlap of a ball on the slate and a cushion in m.
    pub cushion: f64,
    /// Longest step back in time in s.
    pub back: f64,
    /// Balls on the slate that were found where no slate is.
    pub left: u32,
    /// States that are not finite.
    pub not_finite: u32,
    /// Events.
    pub events: u64,
}

/// Listens, and keeps the worst.
#[derive(Clone, Debug)]
pub struct Audit<'s> {
    scene: &'s Scene,
    paths: Vec<PathPiece>,
    gravity: f64,
    /// Time of the last event or piece.
    time: f64,
    energy: f64,
    most_energy: f64,
    /// Energy after the last event of this instant, and what all of its contacts may add; nothing if there was no event.
    after: Option<(f64, f64)>,
    /// Change of momentum at this instant, and how much of it moved at all.
    momentum: (DVec3, f64),
    /// Momentum of balls at this instant that is too little to tell from rest: such a ball is stopped.
    still: f64,
    /// Whether a ball was struck at this instant.
    struck: bool,
    /// Whether anything but two balls met at this instant.
    others: bool,
    /// Energy in J by which balls that tipped at the last event were off; nothing if none did.
    tipped: Option<f64>,
    worst: Worst,
}

impl<'s> Audit<'s> {
    /// Begins with the balls as the scene has them.
    #[must_use]
    pub fn new(scene: &'s Scene) -> Self {
        let path = |ball: &crate::physics::scene::SceneBall| {
            let state = scene.laws.motion.classify(&ball.ball, ball.state);
            PathPiece {
                time: 0.0,
                piece: scene.laws.piece(&scene.table, &ball.ball, &state),
            }
        };
        let mut audit = Self {
            scene,
            paths: scene.balls.iter().map(path).collect(),
            gravity: scene.laws.motion.gravity().unwrap_or(0.0),
            time: 0.0,
            energy: 0.0,
            most_energy: 0.0,
            after: None,
            momentum: (DVec3::ZERO, 0.0),
            still: 0.0,
            struck: false,
            others: false,
            tipped: None,
            worst: Worst::default(),
        };
        audit.energy = audit.energy_at(0.0);
        audit.most_energy = audit.energy;
        audit
    }

    /// The audit of a whole record.
    #[must_use]
    pub fn of(scene: &'s Scene, record: &Record) -> Worst {
        let mut pieces: Vec<(usize, PathPiece)> = Vec::new();
        for (ball, path) in record.paths.iter().enumerate() {
            pieces.extend(path.iter().map(|piece| (ball, *piece)));
        }
        pieces.sort_by(|a, b| a.1.time.total_cmp(&b.1.time));
        let mut audit = Self::new(scene);
        let mut next = pieces.into_iter().peekable();
        for event in &record.events {
            while let Some((ball, piece)) = next.next_if(|(_, piece)| piece.time <= event.time) {
                audit.piece(ball, &piece);
            }
            audit.event(event);
        }
        audit.worst()
    }

    /// What was seen so far.
    #[must_use]
    pub fn worst(&self) -> Worst {
        let mut ended = self.clone();
        ended.end_instant();
        ended.worst
    }

    /// Kinetic and potential energy of all balls in J, those at the bottom of pockets among them.
    fn energy_at(&self, time: f64) -> f64 {
        (0..self.paths.len())
            .map(|index| self.energy_of(index, &self.state(index, time)))
            .sum()
    }

    fn energy_of(&self, index: usize, state: &State) -> f64 {
        let ball = &self.scene.balls[index].ball;
        // On a slope it counts from below the lowest pocket: from the middle there could be none of it to take a share of.
        let (pull, table) = (self.scene.laws.motion.pull(), &self.scene.table);
        let lowest = pull.x.abs() * table.length + pull.z.abs() * table.width;
        let mut potential = self.scene.laws.motion.potential(ball, state) + ball.mass * lowest;
        if pull != DVec3::ZERO && !state.motion.in_play() {
            // It is put to the middle of its pocket, which may lie higher: what falls in has lost all.
            potential = 0.0;
        }
        ball.kinetic_energy(state) + potential
    }

    fn state(&self, ball: usize, time: f64) -> State {
        let path = &self.paths[ball];
        path.piece.at((time - path.time).max(0.0))
    }

    /// What lasting contacts may add at one event in J: they part with half the speed that their press gives them in a contact
    /// time, where there is weight with [`SLOW`] at least, and with a speed that is too little to tell from rest. Falls below
    /// the slate count from there.
    fn allowance(&self, event: &Event) -> f64 {
        event
            .participants()
            .map(|one| {
                let press = self.paths[one.ball].piece.acceleration.length();
                let least = if self.gravity > 0.0 { SLOW } else { 0.0 };
                let speed = (CONTACT_TIME * press.max(self.gravity)).max(least) + 4.0 * STILL;
                self.scene.balls[one.ball].ball.mass * speed * speed
            })
            .sum()
    }

    fn check_energy(&mut self, event: &Event) {
        let now = self.energy_at(event.time);
        let mut tips: Option<f64> = None;
        for (path, one) in self.paths.iter().zip(&self.scene.balls) {
            let start = &path.piece.start;
            if start.motion == Motion::Tipping {
                let spin = 0.5 * one.ball.inertia() * start.angular_velocity.length_squared();
                let way = 0.5 * one.ball.mass * start.velocity.length_squared();
                let drawn = TURNING * spin + BENDING * way;
                tips = Some(tips.unwrap_or(0.0) + drawn);
            }
        }
        let mut more = self.allowance(event);
        for drawn in [tips, self.tipped].into_iter().flatten() {
            let heaviest = self.scene.balls.iter().map(|ball| ball.ball.mass);
            more += TIPPING * heaviest.fold(0.0, f64::max) + drawn;
        }
        self.tipped = tips;
        self.struck |= matches!(event.kind, EventKind::Strike { .. });
        // All that meets at one instant is on its new path before the first event of it is told.
        let earlier = self.after.map_or(0.0, |(_, more)| more);
        self.after = Some((now, earlier + more));
    }

    fn check_room(&mut self, time: f64) {
        let states: Vec<State> = (0..self.paths.len())
            .map(|ball| self.state(ball, time))
            .collect();
        for (one, state) in states.iter().enumerate() {
            let ball = self.scene.balls[one].ball;
            if !state.is_finite() {
                self.worst.not_finite += 1;
            }
            if !state.motion.in_play() {
                continue;
            }
            for (two, other) in states.iter().enumerate().take(one) {
                if other.motion.in_play() {
                    let reach = ball.radius + self.scene.balls[two].ball.radius;
                    let overlap = reach - (state.position - other.position).length();
                    if !(self.is_given_back(state) || self.is_given_back(other)) {
                        self.worst.overlap = self.worst.overlap.max(overlap);
                    }
                }
            }
            if !state.motion.flies() {
                self.check_place(&ball, state);
            }
        }
    }

    fn check_place(&mut self, ball: &Ball, state: &State) {
        let table = &self.scene.table;
        let point = DVec2::new(state.position.x, state.position.z);
        if self.is_given_back(state) {
            return;
        }
        let reach = table.reach(ball.radius);
        for cushion in &table.cushions {
            let (distance, _) = cushion.nearest(point);
            self.worst.cushion = self.worst.cushion.max(reach - distance);
        }
        if table.beyond(point) > 0.0 && table.ground(point) == Ground::Off {
            self.worst.left += 1;
        }
    }

    /// Near a pocket a ball that comes back from its edge is put on the slate wherever that is, and what it then overlaps
    /// pushes it away.
    fn is_given_back(&self, state: &State) -> bool {
        let point = DVec2::new(state.position.x, state.position.z);
        let near = |pocket: &crate::physics::table::Pocket| {
            point.distance(pocket.center) < 2.0 * pocket.radius
        };
        self.scene.laws.pocket != crate::physics::laws::pocket::PocketLaw::Capture
            && self.scene.table.pockets.iter().any(near)
    }

    /// Closes the books of an instant: energy has not risen, and if nothing but balls met, their momentum is what it was.
    fn end_instant(&mut self) {
        if std::mem::take(&mut self.struck) {
            // A stroke is told before the path that it leads to: what it brought is known when the instant is over.
            self.energy = self.energy_at(self.time);
            self.most_energy = self.energy.max(self.most_energy);
            self.after = None;
        } else if let Some((now, more)) = self.after.take() {
            if self.most_energy > 0.0 {
                let rise = (now - self.energy - more) / self.most_energy;
                self.worst.energy = self.worst.energy.max(rise);
            }
            self.energy = now;
        }
        let (change, moved) = self.momentum;
        let pressed = matches!(self.scene.laws.ball_ball, BallBallLaw::Mathavan2014(_));
        if !self.others && !pressed && moved > 0.0 {
            // Two balls on the slate give what lifts or presses them to the slate.
            let level = DVec3::new(change.x, 0.0, change.z);
            let lost = level.length() - self.still;
            self.worst.momentum = self.worst.momentum.max(lost / moved);
        }
        self.momentum = (DVec3::ZERO, 0.0);
        self.still = 0.0;
        self.others = false;
    }

    fn pass_to(&mut self, time: f64) {
        if time != self.time {
            self.end_instant();
        }
        self.worst.back = self.worst.back.max(self.time - time);
        self.time = self.time.max(time);
    }
}

impl Watch for Audit<'_> {
    fn event(&mut self, event: &Event) {
        self.pass_to(event.time);
        self.worst.events += 1;
        // The slate takes up what throws a ball down on it, and rubs.
        let flies = |one: &Participant| one.before.motion.flies() || one.after.motion.flies();
        self.others |= event.kind != EventKind::BallBall || event.participants().any(flies);
        // A heavy one that a light one cannot move has no new path.
        for one in event.participants() {
            if self.paths[one.ball].time != event.time {
                self.still += self.scene.balls[one.ball].ball.mass * 4.0 * STILL;
            }
        }
        self.check_energy(event);
        self.check_room(event.time);
    }

    fn piece(&mut self, ball: usize, piece: &PathPiece) {
        self.pass_to(piece.time);
        let mass = self.scene.balls[ball].ball.mass;
        let before = self.state(ball, piece.time).velocity;
        let after = piece.piece.start.velocity;
        self.momentum.0 += mass * (after - before);
        self.momentum.1 += mass * (after.length() + before.length());
        self.still += mass * 4.0 * STILL;
        self.paths[ball] = *piece;
    }
}
