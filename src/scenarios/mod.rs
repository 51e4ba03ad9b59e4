//! What can be played: scene files, the library of scenes that is built in, and presets of equipment.

pub mod camera;
pub mod dial;
pub mod expect;
pub mod file;
pub mod library;
pub mod own;
pub mod preset;
pub mod search;
pub mod sensitivity;
pub mod share;
pub mod sweep;
