//! Pure physics: f64, SI units, plain structs. No App, no World, nothing that draws.
//!
//! Frame: y is up and zero on the slate, x runs along the table towards the foot, z across it; the origin is the
//! middle of the playing surface. A resting ball's centre is at y = R. Angular velocity is right-handed.

pub mod airborne;
pub mod ball;
pub mod contact;
pub mod cue;
pub mod cue_path;
pub mod equipment;
pub mod exact;
pub mod laws;
pub mod record;
pub mod roots;
pub mod scene;
pub mod table;
