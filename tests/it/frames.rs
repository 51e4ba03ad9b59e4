//! The same state seen in a mirror, from another side of the table, or from a moving train.

use glam::DVec3;

use masse::physics::ball::State;

/// Mirrored in the plane z = 0: what was left is right. Spin is an axial vector.
pub fn mirrored(state: &State) -> State {
    let spin = state.angular_velocity;
    State {
        position: mirrored_vector(state.position),
        velocity: mirrored_vector(state.velocity),
        angular_velocity: DVec3::new(-spin.x, -spin.y, spin.z),
        motion: state.motion,
    }
}

/// An ordinary vector mirrored in the plane z = 0.
pub fn mirrored_vector(vector: DVec3) -> DVec3 {
    DVec3::new(vector.x, vector.y, -vector.z)
}

/// Turned about the vertical by this angle in rad.
pub fn rotated(state: &State, angle: f64) -> State {
    State {
        position: rotated_vector(state.position, angle),
        velocity: rotated_vector(state.velocity, angle),
        angular_velocity: rotated_vector(state.angular_velocity, angle),
        motion: state.motion,
    }
}

/// A vector turned about the vertical by this angle in rad.
pub fn rotated_vector(vector: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    DVec3::new(
        cos * vector.x + sin * vector.z,
        vector.y,
        cos * vector.z - sin * vector.x,
    )
}

/// How far apart two states are: m, m/s and R times rad/s, whichever is largest.
pub fn distance(first: &State, second: &State, radius: f64) -> f64 {
    (first.position - second.position)
        .length()
        .max((first.velocity - second.velocity).length())
        .max(radius * (first.angular_velocity - second.angular_velocity).length())
}

/// The size of the numbers of a state, against which rounding is to be measured.
pub fn size(state: &State, radius: f64) -> f64 {
    state.velocity.length() + radius * state.angular_velocity.length()
}
