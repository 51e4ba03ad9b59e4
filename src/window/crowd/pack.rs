//! The balls as the graphics card gets them: 16 bytes each, packed once a frame. Here, and nowhere else, a crowd goes from
//! f64 to f32.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use bevy::math::{DVec3, Quat, Vec3};
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;
use bevy::tasks::ComputeTaskPool;

use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Radius, Velocity};
use crate::sim::playfield::Playfield;
use crate::window::crowd::turn;

/// Bytes of a ball: x and z of the centre as f32, speed and spin as shares of the hottest, the turn.
const RECORD: usize = 16;
/// In place of speed and spin: the ball is not on the table.
const ABSENT: u32 = u32::MAX;
/// Balls packed by one thread at a time; fewer are not worth a second thread.
const CHUNK: usize = 16_384;
/// Pixels that the radius of a ball has at least on the screen where its markings are seen.
const SEEN: f32 = 4.0;
/// How much hotter than the middle ball the hottest colour is.
const HOT: f32 = 2.5;

/// The balls of the crowd as they are drawn.
#[derive(Resource, Default)]
pub(super) struct Packed {
    /// The bytes.
    pub sheet: Sheet,
    /// Where they go.
    pub buffer: Option<AssetId<ShaderBuffer>>,
    /// Whether they are others than in the last frame.
    pub fresh: bool,
    /// Radius of every ball, m.
    pub radius: f32,
    /// Whether the balls can spin.
    pub spins: bool,
    /// What is drawn in the hottest colour.
    pub hottest: Rates,
    /// What the last packing took.
    pub fill: Duration,
    /// What the last copy to the graphics card took.
    pub upload: Lap,
    /// Tick of the clock at which they were packed.
    ticks: Option<u64>,
}

/// A time that another thread measures.
#[derive(Clone, Default)]
pub(super) struct Lap(Arc<AtomicU64>);

impl Lap {
    pub fn set(&self, time: Duration) {
        let nanos = u64::try_from(time.as_nanos()).unwrap_or(u64::MAX);
        self.0.store(nanos, Ordering::Relaxed);
    }

    pub fn get(&self) -> Duration {
        Duration::from_nanos(self.0.load(Ordering::Relaxed))
    }
}

/// A speed in m/s and a rate of spin in rad/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rates {
    pub speed: f32,
    pub spin: f32,
}

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
    fn reset(&mut self, count: usize, spins: bool) {
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
struct Packing {
    /// One over what is hottest.
    per_speed: f32,
    per_spin: f32,
    /// Seconds since the last packing.
    seconds: f32,
    eye: Vec3,
    /// Square of the distance in m from which markings are not seen.
    seen: f32,
}

/// Sums over balls, for the scale of the colours.
#[derive(Clone, Copy, Default)]
struct Sums {
    speed: f64,
    spin: f64,
    count: f64,
}

impl Sums {
    fn add(self, other: Self) -> Self {
        Self {
            speed: self.speed + other.speed,
            spin: self.spin + other.spin,
            count: self.count + other.count,
        }
    }
}

/// The columns of a few balls.
struct Columns<'a> {
    index: &'a [BallIndex],
    position: &'a [Position],
    velocity: &'a [Velocity],
    spin: Option<&'a [AngularVelocity]>,
    motion: &'a [MotionKind],
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

type Balls<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static Position,
        &'static Velocity,
        Option<&'static AngularVelocity>,
        &'static MotionKind,
        &'static Radius,
    ),
>;

/// Packs every ball of a crowd, if any has moved since the last frame.
pub(super) fn pack(
    mut packed: ResMut<Packed>,
    playfield: Res<Playfield>,
    clock: Res<Clock>,
    balls: Balls,
    camera: Query<(&Camera, &GlobalTransform), With<Camera3d>>,
) {
    let packed = &mut *packed;
    packed.fresh = false;
    if !playfield.solver.is_crowd() {
        if packed.sheet.count() > 0 {
            *packed = Packed::default();
        }
        return;
    }
    let start = Instant::now();
    let count = balls.iter().len();
    let laid_out = packed.sheet.count() != count || packed.ticks.is_none_or(|at| at > clock.ticks);
    if !laid_out && packed.ticks == Some(clock.ticks) && !playfield.is_changed() {
        return;
    }
    if let Some((_, _, _, spin, _, radius)) = balls.iter().next() {
        packed.radius = radius.0 as f32;
        packed.spins = spin.is_some();
    }
    if laid_out {
        packed.sheet.reset(count, packed.spins);
        packed.hottest = Rates::default();
    }
    let ticks = clock.ticks - packed.ticks.unwrap_or(clock.ticks).min(clock.ticks);
    let (eye, seen) = sight(&camera, packed.radius);
    let packing = Packing {
        per_speed: packed.hottest.speed.max(f32::MIN_POSITIVE).recip(),
        per_spin: packed.hottest.spin.max(f32::MIN_POSITIVE).recip(),
        seconds: (ticks as f64 * clock.tick) as f32,
        eye,
        seen: seen * seen,
    };
    let sums = pack_all(&balls, &packing, &mut packed.sheet);
    let first = packed.hottest == Rates::default();
    packed.hottest.follow(sums);
    if first {
        // The scale is known only now.
        let again = Packing {
            per_speed: packed.hottest.speed.max(f32::MIN_POSITIVE).recip(),
            per_spin: packed.hottest.spin.max(f32::MIN_POSITIVE).recip(),
            seconds: 0.0,
            ..packing
        };
        pack_all(&balls, &again, &mut packed.sheet);
    }
    packed.ticks = Some(clock.ticks);
    packed.fresh = true;
    packed.fill = start.elapsed();
}

/// Where the eye is, and how far it sees markings, m.
fn sight(camera: &Query<(&Camera, &GlobalTransform), With<Camera3d>>, radius: f32) -> (Vec3, f32) {
    let Ok((camera, place)) = camera.single() else {
        return (Vec3::ZERO, 0.0);
    };
    let height = camera.physical_target_size().map_or(0, |size| size.y) as f32;
    // Pixels of a length of 1 m that is 1 m away.
    let pixels = 0.5 * height * camera.clip_from_view().y_axis.y;
    (place.translation(), radius * pixels / SEEN)
}

fn pack_all(balls: &Balls, packing: &Packing, sheet: &mut Sheet) -> Sums {
    let mut sums = Sums::default();
    let Ok(tables) = balls.contiguous_iter() else {
        return sums;
    };
    for (index, position, velocity, spin, motion, _) in tables {
        let all = Columns {
            index,
            position,
            velocity,
            spin,
            motion,
        };
        let (done, strays) = all.pack_in_chunks(packing, sheet);
        sums = sums.add(done);
        if strays > 0 {
            // The rows of the table are not in the order of the numbers: one thread puts every ball in its place.
            let still = Packing {
                seconds: 0.0,
                ..*packing
            };
            all.pack(&still, 0, &mut sheet.bytes, &mut sheet.turns);
        }
    }
    sums
}

impl Columns<'_> {
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

impl Rates {
    /// Follows the middle of the balls slowly, so that colours do not flicker.
    fn follow(&mut self, sums: Sums) {
        let middle = |sum: f64| HOT * (sum / sums.count.max(1.0)).sqrt() as f32;
        let slowly = |known: f32, now: f32| {
            if known == 0.0 {
                now
            } else {
                known + 0.05 * (now - known)
            }
        };
        self.speed = slowly(self.speed, middle(sums.speed));
        self.spin = slowly(self.spin, middle(sums.spin));
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
