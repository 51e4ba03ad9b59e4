//! Why a scene cannot be played.

use std::fmt::{self, Display, Formatter};

use thiserror::Error;

/// The source of a range in brackets, nothing if there is none.
struct Because<'a>(&'a str);

impl Display for Because<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        if self.0.is_empty() {
            Ok(())
        } else {
            write!(f, " ({})", self.0)
        }
    }
}

/// Why a scene cannot be played. Every variant names the field and the value.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SceneError {
    /// No balls.
    #[error("balls: there are 0 balls, at least 1 is needed")]
    NoBalls,
    /// Two balls share a name.
    #[error("balls[{ball}].name: `{name}` is used twice")]
    DuplicateName {
        /// Index of the second ball.
        ball: usize,
        /// The name.
        name: String,
    },
    /// Two pockets share a name.
    #[error("table.pockets[{pocket}].name: `{name}` is used twice")]
    DuplicatePocket {
        /// Index of the second pocket.
        pocket: usize,
        /// The name.
        name: String,
    },
    /// A number is not finite or out of its range.
    #[error(
        "{field}: {value} is not allowed, it must be between {least} and {most}{}",
        Because(basis)
    )]
    OutOfRange {
        /// Path of the field.
        field: String,
        /// The value.
        value: f64,
        /// Smallest allowed value.
        least: f64,
        /// Largest allowed value.
        most: f64,
        /// Where the range comes from; may be empty.
        basis: &'static str,
    },
    /// A number is NaN or infinite.
    #[error("{field}: {value} is not a finite number")]
    NotFinite {
        /// Path of the field.
        field: String,
        /// The value.
        value: f64,
    },
    /// Two balls overlap.
    #[error("balls: `{first}` and `{second}` overlap by {overlap} m")]
    Overlap {
        /// One ball.
        first: String,
        /// The other.
        second: String,
        /// Depth in m.
        overlap: f64,
    },
    /// More balls than the table has room for.
    #[error(
        "balls: {count} balls in play cover {percent} % of the table, at most {most} % can be covered"
    )]
    TooDense {
        /// Balls in play.
        count: usize,
        /// Share of the table they cover, per cent.
        percent: f64,
        /// Largest share, per cent.
        most: f64,
    },
    /// The solver is asked for a crowd of what is none.
    #[error("{field}: {value} does not go with `solver.crowd: true`, allowed is {allowed}")]
    NotACrowd {
        /// Path of the field.
        field: String,
        /// The value.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A ball is inside a cushion.
    #[error("balls: `{ball}` is inside cushion {cushion} by {overlap} m")]
    InsideCushion {
        /// The ball.
        ball: String,
        /// Index of the cushion.
        cushion: usize,
        /// Depth in m.
        overlap: f64,
    },
    /// A ball lies outside the table.
    #[error("balls: `{ball}` at x = {x} m, z = {z} m is not on the table")]
    OffTable {
        /// The ball.
        ball: String,
        /// Position, m.
        x: f64,
        /// Position, m.
        z: f64,
    },
    /// The centre of a ball in play lies over a hole.
    #[error("balls: `{ball}` is over pocket `{pocket}`, {overlap} m inside its edge")]
    OverPocket {
        /// The ball.
        ball: String,
        /// The pocket.
        pocket: String,
        /// Distance from the edge of the hole, m.
        overlap: f64,
    },
    /// A wedged ball lies inside the edge of a pocket.
    #[error("balls: `{ball}` is inside the edge of pocket `{pocket}` by {overlap} m")]
    InsidePocket {
        /// The ball.
        ball: String,
        /// The pocket.
        pocket: String,
        /// Depth in m.
        overlap: f64,
    },
    /// A ball is not on the slate.
    #[error(
        "balls: `{ball}`: position.y is {height} m, a ball on the slate has y = radius = {radius} m"
    )]
    OffSlate {
        /// The ball.
        ball: String,
        /// Height of the centre, m.
        height: f64,
        /// Radius, m.
        radius: f64,
    },
    /// The noses do not hold a ball: it passes over them, or under.
    #[error(
        "balls: `{ball}`: radius {radius} m: the noses, {nose_height} m high, would not hold it"
    )]
    NotHeld {
        /// The ball.
        ball: String,
        /// Radius, m.
        radius: f64,
        /// Height of the noses, m.
        nose_height: f64,
    },
    /// A ball does not fall through a pocket: it would be wedged in it for ever.
    #[error(
        "balls: `{ball}`: radius {radius} m: pocket `{pocket}` takes at most {most} m; use `pocket: Capture` or smaller balls"
    )]
    TooLargeForPocket {
        /// The ball.
        ball: String,
        /// Radius, m.
        radius: f64,
        /// Name of the pocket.
        pocket: String,
        /// The largest radius that falls through it, m.
        most: f64,
    },
    /// The table is too small for a ball.
    #[error("table: {length} m x {width} m is smaller than ball `{ball}` of radius {radius} m")]
    TableTooSmall {
        /// Length, m.
        length: f64,
        /// Width, m.
        width: f64,
        /// The ball.
        ball: String,
        /// Radius, m.
        radius: f64,
    },
    /// The shot names a ball that is not there.
    #[error("shot.ball: there is no ball number {ball}, the scene has {count}")]
    NoSuchBall {
        /// Index asked for.
        ball: usize,
        /// Number of balls.
        count: usize,
    },
    /// The shot strikes a ball that is not on the table.
    #[error("shot.ball: `{ball}` is in a pocket")]
    StrikesPocketed {
        /// The ball.
        ball: String,
    },
    /// The exact solver needs closed forms.
    #[error(
        "solver: `Exact` cannot play motion law `Coursework`, which has no closed form; use `Stepped`"
    )]
    NotExact,
}
