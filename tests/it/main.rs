//! The tests of the house, in one binary: judges with known answers and properties of every law.

mod closeness;
mod frames;
mod judges;
mod properties;
mod schedules;
