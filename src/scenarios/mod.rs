//! What can be played: scene files, and the library of scenes that is built in.

pub mod file;
pub mod library;
