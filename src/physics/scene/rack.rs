//! Racks of balls.

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;

use crate::physics::ball::Ball;
use crate::physics::scene::Scene;

/// How object balls are racked on the foot spot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rack {
    /// Fifteen balls: the 8 in the middle of the third row, a solid and a stripe in the back corners, the rest random.
    EightBall,
    /// Nine balls in a diamond: the 1 at the apex, the 9 in the middle, the rest random.
    NineBall,
}

impl Rack {
    /// Adds the rack and a cue ball on the head spot to a scene. `gap` is the distance in m between neighbours; 0 is a
    /// frozen rack. The same seed gives the same order on every platform.
    pub fn place(self, scene: &mut Scene, ball: Ball, gap: f64, seed: u64) {
        let head = scene.table.head_spot();
        scene.place("cue", ball, head.x, head.y);
        let spacing = 2.0 * ball.radius + gap;
        let apex = scene.table.foot_spot();
        for (number, row, place) in self.order(seed) {
            let x = apex.x + f64::from(row) * spacing * 0.5 * 3.0_f64.sqrt();
            let z = apex.y + f64::from(place) * 0.5 * spacing;
            scene.place(&number.to_string(), ball, x, z);
        }
    }

    /// Ball numbers with their row and their place across it in half spacings, apex first.
    fn order(self, seed: u64) -> Vec<(u8, i32, i32)> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let (widths, fixed): (&[i32], Vec<(usize, u8)>) = match self {
            Self::EightBall => {
                let mut corners = [
                    *pick(&mut rng, &[1, 2, 3, 4, 5, 6, 7]),
                    *pick(&mut rng, &[9, 10, 11, 12, 13, 14, 15]),
                ];
                corners.shuffle(&mut rng);
                (
                    &[1, 2, 3, 4, 5],
                    vec![(4, 8), (10, corners[0]), (14, corners[1])],
                )
            }
            Self::NineBall => (&[1, 2, 3, 2, 1], vec![(0, 1), (4, 9)]),
        };
        let places: Vec<(i32, i32)> = (0..)
            .zip(widths)
            .flat_map(|(row, &width)| (0..width).map(move |i| (row, 2 * i - (width - 1))))
            .collect();
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

fn pick<'a, T>(rng: &mut ChaCha8Rng, from: &'a [T]) -> &'a T {
    use rand::RngExt;
    &from[rng.random_range(0..from.len())]
}
