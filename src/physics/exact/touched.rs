//! What a ball has touched lately.

use crate::physics::exact::predict::Partner;

/// The last things that a ball touched, newest first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Touched {
    pub(super) what: [Partner; 4],
    pub(super) time: [f64; 4],
}

impl Touched {
    pub(super) const NOTHING: Self = Self {
        what: [Partner::Nothing; 4],
        time: [f64::NEG_INFINITY; 4],
    };

    pub(super) fn add(&mut self, what: Partner, time: f64) {
        let place = self.what.iter().position(|old| *old == what).unwrap_or(3);
        self.what[..=place].rotate_right(1);
        self.time[..=place].rotate_right(1);
        self.what[0] = what;
        self.time[0] = time;
    }

    pub(super) fn last(&self, what: Partner) -> f64 {
        let place = self.what.iter().position(|old| *old == what);
        place.map_or(f64::NEG_INFINITY, |place| self.time[place])
    }
}
