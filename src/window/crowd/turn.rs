//! How a ball is turned, in 32 bits: the three smallest parts of a unit quaternion, ten bits each, and which part is
//! left out. Two turns nearer than a fifth of a degree may look the same.

use bevy::math::{Quat, Vec3};

/// No turn.
pub(super) const NONE: u32 = 3 | (511 << 2) | (511 << 12) | (511 << 22);

/// Packs a unit quaternion.
pub(super) fn pack(turn: Quat) -> u32 {
    let parts = turn.to_array();
    let mut most = 0;
    for i in 1..4 {
        if parts[i].abs() > parts[most].abs() {
            most = i;
        }
    }
    // q and -q are one turn, so the part left out may be taken as positive.
    let scale = 511.0 * std::f32::consts::SQRT_2 * parts[most].signum();
    let mut packed = most as u32;
    let mut shift = 2;
    for (i, part) in parts.into_iter().enumerate() {
        if i != most {
            let level = (part * scale).round().clamp(-511.0, 511.0) + 511.0;
            packed |= (level as u32) << shift;
            shift += 10;
        }
    }
    packed
}

/// The turn after this many seconds of a spin in rad/s.
pub(super) fn turned(turn: Quat, spin: Vec3, seconds: f32) -> Quat {
    let angle = spin.length() * seconds;
    if angle == 0.0 {
        return turn;
    }
    let (sin, cos) = libm::sincosf(0.5 * angle);
    let axis = spin * (sin * seconds / angle);
    (Quat::from_xyzw(axis.x, axis.y, axis.z, cos) * turn).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the shader does it.
    fn unpack(packed: u32) -> Quat {
        let most = (packed & 3) as usize;
        let small = [2, 12, 22].map(|shift| {
            let level = ((packed >> shift) & 1023) as f32;
            (level - 511.0) / (511.0 * std::f32::consts::SQRT_2)
        });
        let square: f32 = small.iter().map(|part| part * part).sum();
        let mut parts = [0.0; 4];
        parts[most] = (1.0 - square).max(0.0).sqrt();
        let mut rest = small.into_iter();
        for (i, part) in parts.iter_mut().enumerate() {
            if i != most {
                *part = rest.next().unwrap_or_default();
            }
        }
        Quat::from_array(parts)
    }

    #[test]
    fn a_packed_turn_comes_back_within_a_fifth_of_a_degree() {
        assert_eq!(pack(Quat::IDENTITY), NONE);
        let mut turn = Quat::IDENTITY;
        for i in 0..2000 {
            let i = i as f32;
            let spin = Vec3::new(1.0 + (0.7 * i) % 3.0, (1.3 * i) % 5.0 - 2.0, 0.5);
            turn = turned(turn, spin, 0.1);
            let way = Vec3::new(0.3, -0.5, 0.81).normalize();
            let off = (unpack(pack(turn)) * way).distance(turn * way);
            assert!(off < 3.5e-3, "{turn}: {off}");
        }
    }

    #[test]
    fn a_ball_that_rolls_its_circumference_is_as_it_was() {
        let spin = Vec3::new(0.0, 0.0, -10.0);
        let whole = std::f32::consts::TAU / 10.0;
        let mut turn = Quat::IDENTITY;
        for _ in 0..100 {
            turn = turned(turn, spin, whole / 100.0);
        }
        assert!((turn * Vec3::X).distance(Vec3::X) < 1e-4);
        // A quarter towards +x: the top goes forward.
        let quarter = turned(Quat::IDENTITY, spin, 0.25 * whole);
        assert!((quarter * Vec3::Y).distance(Vec3::X) < 1e-5);
    }
}
