//! The exact judges: closed forms and published numbers. One file a family.

mod collision;
mod cushion;
mod deflection;
mod mathavan;
mod pocket;
mod simultaneous;
mod slate;
mod slide;
mod stroke;
mod symmetry;
mod throw;

use crate::report::judge::{Family, Work};

pub(super) use cushion::components;
pub(super) use deflection::shot;
pub(super) use simultaneous::frozen_pair;
pub(super) use symmetry::{ball_ball as random_balls, cushion as random_cushions};
pub(super) use throw::SPEEDS;

/// Every family, in the order of the table.
pub(super) const ALL: &[Family] = &[
    ("J1 J2 sliding", Work::Shots(slide::rows)),
    ("J3 J4 collision", Work::Laws(collision::rows)),
    ("J5 J6 J7 deflection", Work::Shots(deflection::rows)),
    ("J8 throw", Work::Laws(throw::throw)),
    ("J9 gearing and transfer", Work::Laws(throw::transfer)),
    (
        "J10 J17 simultaneous contacts",
        Work::Shots(simultaneous::rows),
    ),
    ("J11 J12 stroke and squirt", Work::Laws(stroke::rows)),
    ("J13 massé", Work::Shots(stroke::masse)),
    (
        "J14 cushion of nose and cloth",
        Work::Laws(mathavan::cushion),
    ),
    (
        "J15 balls pressed on the cloth",
        Work::Laws(mathavan::ball_ball),
    ),
    ("J16 bounces", Work::Shots(slate::rows)),
    ("J18 pockets", Work::Shots(pocket::rows)),
    ("J19 straight shot", Work::Shots(pocket::straight)),
    ("cushions", Work::Laws(cushion::rows)),
    ("H15 H16 ball-ball laws", Work::Laws(symmetry::ball_ball)),
    ("H15 H16 cushion laws", Work::Laws(symmetry::cushion)),
];
