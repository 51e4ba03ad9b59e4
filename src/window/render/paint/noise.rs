//! Value noise that repeats without a seam.

/// Noise over the unit square that repeats in both directions, the same on every run.
pub(in crate::window::render) struct Noise {
    seed: u32,
}

impl Noise {
    pub fn new(seed: u32) -> Self {
        Self { seed }
    }

    /// One octave with this many cells across and down, −1 to 1.
    pub fn octave(&self, (u, v): (f32, f32), (across, down): (u32, u32)) -> f32 {
        let (x, y) = (u * across as f32, v * down as f32);
        let (x0, y0) = (x.floor(), y.floor());
        let ease = |t: f32| t * t * (3.0 - 2.0 * t);
        let (tx, ty) = (ease(x - x0), ease(y - y0));
        let at = |i: i32, j: i32| {
            let x = (x0 as i32 + i).rem_euclid(across as i32) as u32;
            let y = (y0 as i32 + j).rem_euclid(down as i32) as u32;
            self.lattice(x, y)
        };
        let top = at(0, 0) + tx * (at(1, 0) - at(0, 0));
        let bottom = at(0, 1) + tx * (at(1, 1) - at(0, 1));
        top + ty * (bottom - top)
    }

    /// Octaves of doubling fineness and half the height each, about −1 to 1.
    pub fn sum(&self, place: (f32, f32), (across, down): (u32, u32), octaves: u32) -> f32 {
        (0..octaves)
            .map(|i| self.octave(place, (across << i, down << i)) / (1 << i) as f32)
            .sum::<f32>()
            * 0.6
    }

    fn lattice(&self, x: u32, y: u32) -> f32 {
        let mut h = x
            .wrapping_mul(0x9e37_79b1)
            .wrapping_add(y.wrapping_mul(0x85eb_ca77))
            .wrapping_add(self.seed.wrapping_mul(0xc2b2_ae3d));
        h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
        h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
        h ^= h >> 15;
        (h >> 8) as f32 / (1 << 23) as f32 - 1.0
    }
}
