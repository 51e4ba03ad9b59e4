//! The experiments: what others measured, beside every law that claims it. One file a family.

mod ball_ball;
mod cushion;
mod frozen;
mod presets;

use crate::report::judge::{Family, Work};

pub(super) use ball_ball::{oblique_speeds, throw_points};
pub(super) use cushion::{settled_normal, square_ratio};
pub use presets::Named;
pub(super) use presets::rows as preset_rows;

/// Every family, in the order of the table.
pub(super) const ALL: &[Family] = &[
    ("E2 oblique hits", Work::Laws(ball_ball::oblique)),
    ("E3 square rebounds", Work::Laws(cushion::square)),
    ("E4 parting and rebound", Work::Laws(cushion::sudo)),
    ("E5 throw", Work::Laws(ball_ball::throw)),
    ("E6 head-on", Work::Laws(ball_ball::head_on)),
    ("E7 frozen pair", Work::Shots(frozen::pair)),
    ("E8 largest throw", Work::Laws(ball_ball::largest_throw)),
    ("E9 rising restitution", Work::Laws(cushion::rising)),
    ("E10 settled rebound", Work::Laws(cushion::settled)),
    ("E11 rules of thumb", Work::Shots(ball_ball::thumb)),
    ("E12 cue into a frozen pair", Work::Shots(frozen::straight)),
];
