//! A path as the search for contacts needs it.

use glam::DVec3;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::contact::Track;
use crate::physics::exact::predict::Next;
use crate::physics::laws::motion::Piece;
use crate::physics::record::PathPiece;

/// What the search for contacts needs of a ball. The first of its two cache lines is what others ask for: the whole of a
/// straight level path, and of any other how it may be met. The second is for its own events.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(128))]
pub(super) struct Flight {
    /// Place in plan at `since`, m.
    x: f64,
    z: f64,
    /// Velocity in plan at `since`, m/s.
    x_speed: f64,
    z_speed: f64,
    pub(super) since: f64,
    pub(super) until: f64,
    pub(super) radius: f64,
    /// How many paths the ball has had.
    pub(super) count: u32,
    /// Without acceleration, on the slate: its height is its radius.
    pub(super) level: bool,
    /// It glides without spin for ever: there is no more to its path than is here.
    pub(super) plain: bool,
    pub(super) moves: bool,
    pub(super) flies: bool,
    pub(super) in_play: bool,
    pub(super) body: Ball,
    /// The next event found for it.
    pub(super) next: Next,
}

/// A straight level path seen from now.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glide {
    x: f64,
    z: f64,
    x_speed: f64,
    z_speed: f64,
    radius: f64,
}

impl Flight {
    /// Of the path number `count`.
    pub(super) fn new(body: &Ball, path: &PathPiece, count: u32) -> Self {
        let start = &path.piece.start;
        let level = path.piece.acceleration == DVec3::ZERO
            && start.position.y == body.radius
            && start.velocity.y == 0.0
            && start.motion.in_play()
            && !start.motion.flies();
        Self {
            x: start.position.x,
            z: start.position.z,
            x_speed: start.velocity.x,
            z_speed: start.velocity.z,
            since: path.time,
            until: path.time + path.piece.duration,
            radius: body.radius,
            count,
            level,
            plain: level
                && start.motion == Motion::Gliding
                && path.piece == Piece::uniform(*start)
                && start.angular_velocity == DVec3::ZERO,
            moves: start.motion.translates(),
            flies: start.motion.flies(),
            in_play: start.motion.in_play(),
            body: *body,
            next: Next::NEVER,
        }
    }

    /// The path that follows this one with this state now, if there is no more to it than is kept here. The ball glides,
    /// on a table without cloth.
    #[inline]
    pub(super) fn gliding(&self, state: &State, now: f64) -> Option<Self> {
        let plain = state.motion == Motion::Gliding
            && state.position.y == self.radius
            && state.velocity.y == 0.0
            && state.angular_velocity == DVec3::ZERO;
        plain.then_some(Self {
            x: state.position.x,
            z: state.position.z,
            x_speed: state.velocity.x,
            z_speed: state.velocity.z,
            since: now,
            until: f64::INFINITY,
            count: self.count.wrapping_add(1),
            level: true,
            plain: true,
            moves: true,
            in_play: true,
            ..*self
        })
    }

    /// The path of a ball that glides without spin.
    #[inline]
    pub(super) fn path(&self) -> PathPiece {
        PathPiece {
            time: self.since,
            piece: Piece::uniform(self.state(self.since)),
        }
    }

    /// The state of a ball that glides without spin.
    #[inline]
    pub(super) fn state(&self, now: f64) -> State {
        State {
            position: self.place(now),
            velocity: DVec3::new(self.x_speed, 0.0, self.z_speed),
            angular_velocity: DVec3::ZERO,
            motion: Motion::Gliding,
        }
    }

    /// Where a ball on a level path is now.
    #[inline]
    pub(super) fn place(&self, now: f64) -> DVec3 {
        let glide = self.glide(now);
        DVec3::new(glide.x, self.radius, glide.z)
    }

    /// A level path seen from now: the same numbers as [`Track::of`] its piece.
    #[inline]
    pub(super) fn glide(&self, now: f64) -> Glide {
        let age = now - self.since;
        Glide {
            x: self.x + age * self.x_speed,
            z: self.z + age * self.z_speed,
            x_speed: self.x_speed,
            z_speed: self.z_speed,
            radius: self.radius,
        }
    }
}

impl Glide {
    pub(super) fn track(&self) -> Track {
        Track {
            position: DVec3::new(self.x, self.radius, self.z),
            velocity: DVec3::new(self.x_speed, 0.0, self.z_speed),
            acceleration: DVec3::ZERO,
        }
    }

    /// Along x: place and speed.
    pub(super) fn along(&self) -> (f64, f64) {
        (self.x, self.x_speed)
    }

    /// Along z: place and speed.
    pub(super) fn across(&self) -> (f64, f64) {
        (self.z, self.z_speed)
    }

    /// The distance of two as a polynomial in time: the square of the gap, constant first. The same numbers as
    /// [`contact::pair`](crate::physics::contact::pair) finds.
    #[inline]
    pub(super) fn gap(&self, other: &Self) -> [f64; 3] {
        let (x, y, z) = (
            other.x - self.x,
            other.radius - self.radius,
            other.z - self.z,
        );
        let (x_speed, z_speed) = (other.x_speed - self.x_speed, other.z_speed - self.z_speed);
        let reach = self.radius + other.radius;
        [
            x * x + y * y + z * z - reach * reach,
            2.0 * (x * x_speed + z * z_speed),
            x_speed * x_speed + z_speed * z_speed,
        ]
    }

    /// Whether two certainly do not meet within `wait` seconds, and whether they may touch now: their gap is at most
    /// `touch`. A few products and no branches, because most of what many bodies ask ends here.
    #[inline]
    pub(super) fn passes(&self, other: &Self, wait: f64, touch: f64) -> (bool, bool) {
        let [gap, slope, square] = self.gap(other);
        let opens = slope >= 0.0;
        // Far enough from a double root for plain arithmetic.
        let misses = 1.001 * slope * slope < 4.0 * gap * square;
        // The curve lies above its tangent.
        let later = (1.0 - 1e-9) * gap + wait * slope > 0.0;
        (opens | misses | later, gap <= touch)
    }
}
