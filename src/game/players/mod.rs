//! Computer opponents.
//!
//! A [`Level`] is a hand and a head: how unsteady the strokes are, and what is thought of before them. [`Thinking`] goes
//! from a table and a state of the game to a [`Plan`], in steps that a task can run; [`choosing::choose`] answers the
//! choices that the rules offer; [`contest::execute`] is the stroke that comes of the plan. All of it is pure: the same
//! position, level and seed give the same stroke on every machine and any number of threads.

pub mod aiming;
pub mod chance;
pub mod choosing;
pub mod contest;
mod finals;
mod hidden;
pub mod idea;
pub mod ideas;
pub mod level;
pub mod noise;
mod opening;
pub mod plan;
pub mod rehearsal;
mod screen;
pub mod sight;
pub mod standings;
pub mod thinking;
pub mod worth;

pub use level::{Level, Skills};
pub use noise::{Deviation, Noise};
pub use plan::{Plan, Progress};
pub use thinking::Thinking;
