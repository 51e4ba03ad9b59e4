//! The experiments: what others measured, beside every law that claims it. One file a family.

mod ball_ball;
mod cushion;
mod frozen;

use crate::report::judge::Family;

pub(super) use ball_ball::{oblique_speeds, throw_points};
pub(super) use cushion::{settled_normal, square_ratio};

/// Every family, in the order of the table.
pub(super) const ALL: &[Family] = &[
    ("E2 oblique hits", ball_ball::oblique),
    ("E3 square rebounds", cushion::square),
    ("E4 parting and rebound", cushion::sudo),
    ("E5 throw", ball_ball::throw),
    ("E6 head-on", ball_ball::head_on),
    ("E7 frozen pair", frozen::pair),
    ("E8 largest throw", ball_ball::largest_throw),
    ("E9 rising restitution", cushion::rising),
    ("E10 settled rebound", cushion::settled),
    ("E11 rules of thumb", ball_ball::thumb),
    ("E12 cue into a frozen pair", frozen::straight),
];
