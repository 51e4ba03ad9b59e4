//! The exact judges: closed forms and published numbers. One file a family.

mod collision;
mod cushion;
mod deflection;
mod simultaneous;
mod slide;
mod stroke;
mod symmetry;
mod throw;

use crate::report::judge::Family;

pub(super) use cushion::components;
pub(super) use deflection::shot;
pub(super) use simultaneous::frozen_pair;
pub(super) use throw::SPEEDS;

/// Every family, in the order of the table.
pub(super) const ALL: &[Family] = &[
    ("J1 J2 sliding", slide::rows),
    ("J3 J4 collision", collision::rows),
    ("J5 J6 J7 deflection", deflection::rows),
    ("J8 throw", throw::throw),
    ("J9 gearing and transfer", throw::transfer),
    ("J10 J17 simultaneous contacts", simultaneous::rows),
    ("J11 J12 stroke and squirt", stroke::rows),
    ("J13 massé", stroke::masse),
    ("cushions", cushion::rows),
    ("H15 H16 ball-ball laws", symmetry::ball_ball),
    ("H15 H16 cushion laws", symmetry::cushion),
];
