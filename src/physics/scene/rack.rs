//! Racks of balls.

use glam::DVec2;
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::physics::ball::Ball;
use crate::physics::scene::Scene;
use crate::physics::table::Table;

/// How the balls of a game are set up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Rack {
    /// Fifteen balls: the 8 in the middle of the third row, a solid and a stripe in the back corners, the rest random.
    EightBall,
    /// Nine balls in a diamond: the 1 at the apex on the foot spot, the 9 in the middle, the rest random.
    NineBall,
    /// The same diamond with the 9 on the foot spot.
    NineOnSpot,
    /// Ten balls in a triangle: the 1 at the apex, the 10 in the middle, the 2 and the 3 in the back corners.
    TenBall,
    /// Fifteen balls in any order.
    Straight,
    /// Fifteen reds behind the pink, six colours on their spots, the cue ball in the D.
    Snooker,
    /// Three balls: red on the foot spot, yellow on the head spot, white beside it.
    ThreeCushion,
}

/// The colours of snooker from the least to the greatest value.
pub const COLOURS: [&str; 6] = ["yellow", "green", "brown", "blue", "pink", "black"];

/// Gap in m that is left where balls are set up without touching.
const CLEAR: f64 = 5e-4;

/// Distance in m from the head spot to the ball beside it at the opening of three-cushion (UMB).
const BESIDE: f64 = 0.1825;

impl Rack {
    /// Every rack.
    pub const ALL: [Self; 7] = [
        Self::EightBall,
        Self::NineBall,
        Self::NineOnSpot,
        Self::TenBall,
        Self::Straight,
        Self::Snooker,
        Self::ThreeCushion,
    ];

    /// Adds the balls of this rack to a scene, the ball to strike first. `gap` is the distance in m between neighbours; 0 is
    /// a frozen rack. The same seed gives the same order on every platform.
    pub fn place(self, scene: &mut Scene, ball: Ball, gap: f64, seed: u64) {
        match self {
            Self::Snooker => snooker(scene, ball, gap),
            Self::ThreeCushion => three_cushion(scene, ball),
            _ => {
                let head = scene.table.head_spot();
                scene.place("cue", ball, head.x, head.y);
                let apex = self.apex(&scene.table, 2.0 * ball.radius + gap);
                for (number, row, place) in self.order(seed) {
                    let spot = at(apex, 2.0 * ball.radius + gap, row, place);
                    scene.place(&number.to_string(), ball, spot.x, spot.y);
                }
            }
        }
    }

    /// Where the balls of a triangle or diamond lie, apex first, x and z in m; nothing for games without numbers.
    #[must_use]
    pub fn places(self, table: &Table, radius: f64) -> Vec<DVec2> {
        let apex = self.apex(table, 2.0 * radius);
        places(self.widths())
            .map(|(row, place)| at(apex, 2.0 * radius, row, place))
            .collect()
    }

    fn apex(self, table: &Table, spacing: f64) -> DVec2 {
        let foot = table.foot_spot();
        match self {
            Self::NineOnSpot => at(foot, spacing, -2, 0),
            _ => foot,
        }
    }

    /// Balls of each row, apex first.
    fn widths(self) -> &'static [i32] {
        match self {
            Self::EightBall | Self::Straight => &[1, 2, 3, 4, 5],
            Self::NineBall | Self::NineOnSpot => &[1, 2, 3, 2, 1],
            Self::TenBall => &[1, 2, 3, 4],
            Self::Snooker | Self::ThreeCushion => &[],
        }
    }

    /// Ball numbers with their row and their place across it in half spacings, apex first.
    fn order(self, seed: u64) -> Vec<(u8, i32, i32)> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let fixed: Vec<(usize, u8)> = match self {
            Self::EightBall => {
                let mut corners = [
                    *pick(&mut rng, &[1, 2, 3, 4, 5, 6, 7]),
                    *pick(&mut rng, &[9, 10, 11, 12, 13, 14, 15]),
                ];
                corners.shuffle(&mut rng);
                vec![(4, 8), (10, corners[0]), (14, corners[1])]
            }
            Self::NineBall | Self::NineOnSpot => vec![(0, 1), (4, 9)],
            Self::TenBall => {
                let mut corners = [2, 3];
                corners.shuffle(&mut rng);
                vec![(0, 1), (4, 10), (6, corners[0]), (9, corners[1])]
            }
            Self::Straight | Self::Snooker | Self::ThreeCushion => Vec::new(),
        };
        let places: Vec<(i32, i32)> = places(self.widths()).collect();
        let count = u8::try_from(places.len()).unwrap_or(u8::MAX);
        let mut rest: Vec<u8> = (1..=count)
            .filter(|number| fixed.iter().all(|(_, other)| other != number))
            .collect();
        rest.shuffle(&mut rng);
        let mut rest = rest.into_iter();
        places
            .iter()
            .enumerate()
            .filter_map(|(index, &(row, place))| {
                let number = fixed
                    .iter()
                    .find(|(at, _)| *at == index)
                    .map(|&(_, number)| number)
                    .or_else(|| rest.next())?;
                Some((number, row, place))
            })
            .collect()
    }
}

/// Rows, and places across them in half spacings.
fn places(widths: &[i32]) -> impl Iterator<Item = (i32, i32)> {
    (0..)
        .zip(widths)
        .flat_map(|(row, &width)| (0..width).map(move |i| (row, 2 * i - (width - 1))))
}

fn at(apex: DVec2, spacing: f64, row: i32, place: i32) -> DVec2 {
    let x = apex.x + f64::from(row) * spacing * 0.5 * 3.0_f64.sqrt();
    DVec2::new(x, apex.y + f64::from(place) * 0.5 * spacing)
}

/// The spot of a colour of snooker; `None` if there is no such colour. Yellow lies at the right end of the D, seen from
/// baulk.
#[must_use]
pub fn colour_spot(table: &Table, colour: &str) -> Option<DVec2> {
    let baulk = table.baulk_spot();
    let aside = DVec2::new(0.0, table.d_radius());
    Some(match colour {
        "yellow" => baulk + aside,
        "green" => baulk - aside,
        "brown" => baulk,
        "blue" => DVec2::ZERO,
        "pink" => table.foot_spot(),
        "black" => table.black_spot(),
        _ => return None,
    })
}

fn snooker(scene: &mut Scene, ball: Ball, gap: f64) {
    let baulk = scene.table.baulk_spot();
    scene.place("cue", ball, baulk.x, 0.5 * scene.table.d_radius());
    let spacing = 2.0 * ball.radius + gap;
    let apex = scene.table.foot_spot() + DVec2::new(2.0 * ball.radius + CLEAR, 0.0);
    for (number, (row, place)) in (1..).zip(places(&[1, 2, 3, 4, 5])) {
        let spot = at(apex, spacing, row, place);
        scene.place(&format!("red {number}"), ball, spot.x, spot.y);
    }
    for colour in COLOURS {
        if let Some(spot) = colour_spot(&scene.table, colour) {
            scene.place(colour, ball, spot.x, spot.y);
        }
    }
}

fn three_cushion(scene: &mut Scene, ball: Ball) {
    let (head, foot) = (scene.table.head_spot(), scene.table.foot_spot());
    scene.place("white", ball, head.x, BESIDE);
    scene.place("yellow", ball, head.x, head.y);
    scene.place("red", ball, foot.x, foot.y);
}

fn pick<'a, T>(rng: &mut ChaCha8Rng, from: &'a [T]) -> &'a T {
    use rand::RngExt;
    &from[rng.random_range(0..from.len())]
}
