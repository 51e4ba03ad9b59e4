//! Massé: a billiards game and simulator.

pub mod physics;
