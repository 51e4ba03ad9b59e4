//! The balls as the graphics card gets them, packed once a frame into a [`Sheet`]. Here, and nowhere else, a crowd goes from
//! f64 to f32.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use bevy::math::Vec3;
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;

use crate::game::view::FirstEye;
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Radius, Velocity};
use crate::sim::playfield::Playfield;
use crate::window::crowd::sheet::{Columns, Packing, Sheet, Sums};

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
    camera: Query<(&Camera, &GlobalTransform), With<FirstEye>>,
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
fn sight(camera: &Query<(&Camera, &GlobalTransform), With<FirstEye>>, radius: f32) -> (Vec3, f32) {
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
        sums = sums.add(all.pack_all(packing, sheet));
    }
    sums
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
