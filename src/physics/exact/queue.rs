//! Which ball's next event comes first.
//!
//! A complete binary tree of winners over the times of all balls (a tournament; Rapaport 1980 uses a search tree, but
//! with one event a ball no tree has to be rebalanced). Setting a time costs at most log₂ n comparisons and usually far
//! fewer; nothing is allocated. Equal times: the ball with the smaller index wins.

/// The tournament.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    times: Vec<f64>,
    /// Winner below each node; node 1 is the root, nodes 2i and 2i + 1 are below node i.
    winners: Vec<u32>,
    leaves: usize,
}

impl Queue {
    /// Nobody has an event.
    pub(super) fn new(count: usize) -> Self {
        let leaves = count.next_power_of_two().max(2);
        let mut winners = vec![0; leaves];
        for node in (1..leaves).rev() {
            winners[node] = if node >= leaves / 2 {
                u32::try_from(2 * node - leaves).unwrap_or(u32::MAX)
            } else {
                winners[2 * node]
            };
        }
        Self {
            times: vec![f64::INFINITY; leaves],
            winners,
            leaves,
        }
    }

    /// The ball whose event comes first, and its time; infinite if nothing will ever happen.
    pub(super) fn first(&self) -> (usize, f64) {
        let ball = self.winners[1] as usize;
        (ball, self.times[ball])
    }

    /// Sets the time of a ball's next event.
    pub(super) fn set(&mut self, ball: usize, time: f64) {
        self.times[ball] = time;
        let mut node = (ball + self.leaves) >> 1;
        let mut winner = if self.times[ball | 1] < self.times[ball & !1] {
            ball | 1
        } else {
            ball & !1
        };
        loop {
            let old = self.winners[node] as usize;
            self.winners[node] = winner as u32;
            if node == 1 || (old == winner && winner != ball) {
                return;
            }
            let rival = self.winners[node ^ 1] as usize;
            let (left, right) = if node & 1 == 0 {
                (winner, rival)
            } else {
                (rival, winner)
            };
            winner = if self.times[right] < self.times[left] {
                right
            } else {
                left
            };
            node /= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;

    #[test]
    fn the_earliest_of_many_always_wins() {
        for count in [1, 2, 3, 9, 64, 100] {
            let mut queue = Queue::new(count);
            let mut times = vec![f64::INFINITY; count];
            let mut seed = 1_u64;
            for _ in 0..2000 {
                seed = seed
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                let ball = (seed >> 33) as usize % count;
                let time = ((seed >> 20) % 50) as f64;
                times[ball] = time;
                queue.set(ball, time);
                let least = times.iter().copied().fold(f64::INFINITY, f64::min);
                let first = times.iter().position(|t| *t == least).expect("one was set");
                assert_eq!(queue.first(), (first, least));
            }
        }
    }
}
