//! What is told about a run: pictures, and later tables of judges and of speed.

pub mod picture;
