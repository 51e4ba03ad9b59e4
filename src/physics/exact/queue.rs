//! Which ball's next event comes first.
//!
//! A tournament over the times of all balls, eight to a match, so that a match is one cache line and a million balls need
//! seven (Rapaport 1980 uses a binary search tree, but with one event a ball no tree has to be rebalanced). Setting a time
//! plays the matches upwards until one has the result that it had before, usually after one or two; nothing is
//! allocated. Equal times: the ball with the smaller index wins.

/// How many meet in a match.
const WIDE: usize = 8;

/// Times of the contestants of one match.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Match([f64; WIDE]);

impl Match {
    const EMPTY: Self = Self([f64::INFINITY; WIDE]);

    /// The least time if this place had that one. Read before it is written: a fresh number is slow to read back as a part
    /// of a wide one.
    #[inline]
    fn least_with(&self, place: usize, time: f64) -> f64 {
        let mut t = self.0;
        for (index, old) in t.iter_mut().enumerate() {
            *old = if index == place { time } else { *old };
        }
        let less = |a: f64, b: f64| if a < b { a } else { b };
        less(
            less(less(t[0], t[2]), less(t[4], t[6])),
            less(less(t[1], t[3]), less(t[5], t[7])),
        )
    }

    /// Who is first of those with this time.
    #[inline]
    fn winner(&self, time: f64) -> usize {
        let mut who = 0_u32;
        for (place, t) in self.0.iter().enumerate() {
            who |= u32::from(*t == time) << place;
        }
        (who.trailing_zeros() as usize) & (WIDE - 1)
    }
}

/// The tournament.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// Rounds, the final last; a contestant of the next is the least time of a match of this one.
    rounds: Vec<Vec<Match>>,
    first: f64,
}

impl Queue {
    /// Nobody has an event.
    pub(super) fn new(count: usize) -> Self {
        let mut matches = count.div_ceil(WIDE).max(1);
        let mut rounds = vec![vec![Match::EMPTY; matches]];
        while matches > 1 {
            matches = matches.div_ceil(WIDE);
            rounds.push(vec![Match::EMPTY; matches]);
        }
        Self {
            rounds,
            first: f64::INFINITY,
        }
    }

    /// The time of the first event; infinite if nothing will ever happen.
    #[inline]
    pub(super) fn first_time(&self) -> f64 {
        self.first
    }

    /// The ball whose event comes first; the first of all if nothing will ever happen.
    #[inline]
    pub(super) fn first(&self) -> usize {
        let mut place = 0;
        for round in self.rounds.iter().rev() {
            place = place * WIDE + round[place].winner(self.first);
        }
        place
    }

    /// A ball whose event comes early among the others: the best of those that the first met in the final. `None` where
    /// there was but one match.
    #[inline]
    pub(super) fn runner_up(&self) -> Option<usize> {
        let (last, earlier) = self.rounds.split_last()?;
        if earlier.is_empty() {
            return None;
        }
        let time = last[0].least_with(last[0].winner(self.first), f64::INFINITY);
        let mut place = last[0].winner(time);
        for round in earlier.iter().rev() {
            place = place * WIDE + round[place].winner(time);
        }
        Some(place)
    }

    /// Sets the time of a ball's next event.
    #[inline]
    pub(super) fn set(&mut self, ball: usize, time: f64) {
        let (mut place, mut time) = (ball, time);
        for round in &mut self.rounds {
            let game = &mut round[place / WIDE];
            let old = game.0[place % WIDE];
            let least = game.least_with(place % WIDE, time);
            game.0[place % WIDE] = time;
            // Who was not first and is not first changes nothing above.
            if old == time || (old > least && time > least) {
                return;
            }
            time = least;
            place /= WIDE;
        }
        self.first = time;
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;

    #[test]
    fn the_earliest_of_many_always_wins() {
        for count in [1, 2, 3, 8, 9, 64, 65, 100, 1000] {
            let mut queue = Queue::new(count);
            let mut times = vec![f64::INFINITY; count];
            let mut seed = 1_u64;
            for _ in 0..2000 {
                seed = seed
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                let ball = (seed >> 33) as usize % count;
                let time = match (seed >> 20) % 50 {
                    0 => f64::INFINITY,
                    time => time as f64,
                };
                times[ball] = time;
                queue.set(ball, time);
                let least = times.iter().copied().fold(f64::INFINITY, f64::min);
                let first = times.iter().position(|t| *t == least).expect("one was set");
                assert_eq!((queue.first(), queue.first_time()), (first, least));
            }
        }
    }
}
