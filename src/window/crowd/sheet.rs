//! The sheet of bytes: 16 for each ball, packed on all threads.

use bevy::math::{DVec3, Quat, Vec3};
use bevy::tasks::ComputeTaskPool;

use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Velocity};
use crate::window::crowd::turn;

/// Bytes of a ball: x and z of the centre as f32, speed and spin as shares of the hottest, the turn.
const RECORD: usize = 16;
/// In place of speed and spin: the ball is not on the table.
const ABSENT: u32 = u32::MAX;
/// Balls packed by one thread at a time; fewer are not worth a second thread.
const CHUNK: usize = 16_384;
/// The records of all balls by number, and how each is turned.
#[derive(Default)]
pub(super) struct Sheet {
    bytes: Vec<u8>,
    /// Empty while nothing can spin.
    turns: Vec<Quat>,
}

impl Sheet {
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    pub fn count(&self) -> usize {
        self.bytes.len() / RECORD
    }

    /// Room for so many balls, none of them on the table yet.
    pub fn reset(&mut self, count: usize, spins: bool) {
        self.bytes.clear();
        self.bytes.resize(count * RECORD, u8::MAX);
        for record in self.bytes.chunks_exact_mut(RECORD) {
            record[12..].copy_from_slice(&turn::NONE.to_le_bytes());
        }
        self.turns.clear();
        self.turns
            .resize(if spins { count } else { 0 }, Quat::IDENTITY);
    }
}

/// What it takes to pack a ball.
#[derive(Clone, Copy)]
pub(super) struct Packing {
    /// One over what is hottest.
    pub per_speed: f32,
    pub per_spin: f32,
    /// Seconds since the last packing.
    pub seconds: f32,
    pub eye: Vec3,
    /// Square of the distance in m from which markings are not seen.
    pub seen: f32,
}

/// Sums over balls, for the scale of the colours.
#[derive(Clone, Copy, Default)]
pub(super) struct Sums {
    pub speed: f64,
    pub spin: f64,
    pub count: f64,
}

impl Sums {
    pub fn add(self, other: Self) -> Self {
        Self {
            speed: self.speed + other.speed,
            spin: self.spin + other.spin,
            count: self.count + other.count,
        }
    }
}

/// The columns of a few balls.
pub(super) struct Columns<'a> {
    pub index: &'a [BallIndex],
    pub position: &'a [Position],
    pub velocity: &'a [Velocity],
    pub spin: Option<&'a [AngularVelocity]>,
    pub motion: &'a [MotionKind],
}

impl Columns<'_> {
    /// Packs these balls into the records from number `first` on. Those that have no place there are counted.
    fn pack(
        &self,
        packing: &Packing,
        first: usize,
        bytes: &mut [u8],
        turns: &mut [Quat],
    ) -> (Sums, usize) {
        let (mut sums, mut strays) = (Sums::default(), 0);
        for k in 0..self.index.len() {
            let place = self.index[k].0.wrapping_sub(first);
            let Some(record) = bytes.chunks_exact_mut(RECORD).nth(place) else {
                strays += 1;
                continue;
            };
            if !self.motion[k].0.in_play() {
                record[8..12].copy_from_slice(&ABSENT.to_le_bytes());
                continue;
            }
            let at = self.position[k].0;
            let (x, z) = (at.x as f32, at.z as f32);
            let speed = length_squared(self.velocity[k].0);
            let mut rates = unorm(speed.sqrt() * packing.per_speed);
            sums.speed += f64::from(speed);
            sums.count += 1.0;
            if let Some(spin) = self.spin {
                let spin = spin[k].0;
                let square = length_squared(spin);
                rates |= unorm(square.sqrt() * packing.per_spin) << 16;
                sums.spin += f64::from(square);
                let away = Vec3::new(x, at.y as f32, z).distance_squared(packing.eye);
                // Far away nobody sees how a ball is turned.
                if away < packing.seen
                    && square > 0.0
                    && let Some(turn) = turns.get_mut(place)
                {
                    *turn = turn::turned(*turn, spin.as_vec3(), packing.seconds);
                    record[12..].copy_from_slice(&turn::pack(*turn).to_le_bytes());
                }
            }
            record[..4].copy_from_slice(&x.to_le_bytes());
            record[4..8].copy_from_slice(&z.to_le_bytes());
            record[8..12].copy_from_slice(&rates.to_le_bytes());
        }
        (sums, strays)
    }
}

fn length_squared(vector: DVec3) -> f32 {
    vector.as_vec3().length_squared()
}

/// A share from 0 to 1 in 16 bits, one step short of the most: that is for absent balls.
fn unorm(share: f32) -> u32 {
    // The cast saturates.
    ((share * 65_534.0 + 0.5) as u32).min(65_534)
}

impl Columns<'_> {
    /// Packs every ball into its place.
    pub fn pack_all(&self, packing: &Packing, sheet: &mut Sheet) -> Sums {
        let (sums, strays) = self.pack_in_chunks(packing, sheet);
        if strays > 0 {
            // The rows of the table are not in the order of the numbers: one thread puts every ball in its place.
            let still = Packing {
                seconds: 0.0,
                ..*packing
            };
            self.pack(&still, 0, &mut sheet.bytes, &mut sheet.turns);
        }
        sums
    }

    /// Packs on all threads, as far as the rows are in the order of the numbers.
    fn pack_in_chunks(&self, packing: &Packing, sheet: &mut Sheet) -> (Sums, usize) {
        let pool = ComputeTaskPool::try_get().filter(|_| self.index.len() > CHUNK);
        let Some(pool) = pool else {
            return self.pack(packing, 0, &mut sheet.bytes, &mut sheet.turns);
        };
        let mut turns = sheet.turns.chunks_mut(CHUNK);
        let done = pool.scope(|scope| {
            for (chunk, bytes) in sheet.bytes.chunks_mut(CHUNK * RECORD).enumerate() {
                let turns = turns.next().unwrap_or_default();
                let first = chunk * CHUNK;
                let rows = first.min(self.index.len())..(first + CHUNK).min(self.index.len());
                let part = Columns {
                    index: &self.index[rows.clone()],
                    position: &self.position[rows.clone()],
                    velocity: &self.velocity[rows.clone()],
                    spin: self.spin.map(|spin| &spin[rows.clone()]),
                    motion: &self.motion[rows],
                };
                scope.spawn(async move { part.pack(packing, first, bytes, turns) });
            }
        });
        done.into_iter()
            .fold((Sums::default(), 0), |(sums, strays), (more, strayed)| {
                (sums.add(more), strays + strayed)
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Motion;

    const PACKING: Packing = Packing {
        per_speed: 0.5,
        per_spin: 0.1,
        seconds: 0.1,
        eye: Vec3::ZERO,
        seen: 1.0,
    };

    fn record(sheet: &Sheet, number: usize) -> [u32; 4] {
        let bytes = &sheet.bytes[RECORD * number..];
        std::array::from_fn(|word| {
            let four = &bytes[4 * word..4 * word + 4];
            u32::from_le_bytes([four[0], four[1], four[2], four[3]])
        })
    }

    fn packed(numbers: &[usize], motion: Motion) -> Sheet {
        let count = numbers.len();
        let index: Vec<_> = numbers.iter().map(|&number| BallIndex(number)).collect();
        let place = |number: usize| DVec3::new(0.5 * number as f64, 0.03, -0.25);
        let position: Vec<_> = numbers.iter().map(|&n| Position(place(n))).collect();
        let columns = Columns {
            index: &index,
            position: &position,
            velocity: &vec![Velocity(DVec3::new(0.6, 0.0, 0.8)); count],
            spin: Some(&vec![AngularVelocity(DVec3::new(0.0, 0.0, -5.0)); count]),
            motion: &vec![MotionKind(motion); count],
        };
        let mut sheet = Sheet::default();
        sheet.reset(count, true);
        let (_, strays) = columns.pack(&PACKING, 0, &mut sheet.bytes, &mut sheet.turns);
        assert_eq!(strays, 0);
        sheet
    }

    #[test]
    fn a_ball_lies_at_its_number_whatever_the_order_of_the_rows() {
        let sheet = packed(&[2, 0, 3, 1], Motion::Sliding);
        for number in 0..4 {
            let [x, z, rates, _] = record(&sheet, number);
            assert_eq!(f32::from_bits(x), 0.5 * number as f32);
            assert_eq!(f32::from_bits(z), -0.25);
            // Half of the hottest, both.
            assert_eq!(rates & 0xffff, 32_767);
            assert_eq!(rates >> 16, 32_767);
        }
    }

    #[test]
    fn only_balls_near_the_eye_are_turned() {
        let sheet = packed(&[0, 1, 2, 3], Motion::Rolling);
        let turned = turn::turned(Quat::IDENTITY, Vec3::new(0.0, 0.0, -5.0), 0.1);
        assert_eq!(record(&sheet, 0)[3], turn::pack(turned));
        assert_eq!(record(&sheet, 1)[3], turn::pack(turned));
        assert_eq!(record(&sheet, 3)[3], turn::NONE);
    }

    #[test]
    fn a_ball_out_of_play_is_absent() {
        let sheet = packed(&[0, 1], Motion::Pocketed);
        assert_eq!(record(&sheet, 1)[2], ABSENT);
        assert_ne!(unorm(1e9) << 16 | unorm(1e9), ABSENT);
    }
}
