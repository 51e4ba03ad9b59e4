//! The contacts of a stretch of time in order, as a calendar: one short list for each fraction of the stretch.

/// What will happen to a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Its kind of motion changes.
    Change,
    /// It meets the cushion of this index.
    Cushion(u32),
    /// It meets this ball of the patch.
    Ball(u32),
}

/// One thing that will happen if no path changes before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    /// Seconds since the start of the stretch.
    pub time: f64,
    /// Which of two contacts at the same time comes first: kind, then numbers of the scene, never an index of a patch.
    pub order: u64,
    /// The ball, as an index of the patch.
    pub ball: u32,
    pub kind: Kind,
    /// The paths of the two balls it was found for.
    pub versions: [u32; 2],
}

impl Contact {
    /// The order of a change of motion, a cushion or a ball at the same time.
    pub fn order(kind: u64, other: u32, ball: u32) -> u64 {
        kind << 62 | u64::from(other) << 31 | u64::from(ball)
    }

    fn is_before(&self, other: &Self) -> bool {
        self.time < other.time || (self.time == other.time && self.order < other.order)
    }
}

const END: u32 = u32::MAX;

#[derive(Debug, Default)]
pub(super) struct Calendar {
    contacts: Vec<(Contact, u32)>,
    days: Vec<u32>,
    per_second: f64,
    today: usize,
}

impl Calendar {
    /// An empty calendar from now to `horizon` seconds, for about so many contacts.
    pub fn reset(&mut self, horizon: f64, expected: usize) {
        let days = expected.clamp(16, 1 << 20);
        self.contacts.clear();
        self.days.clear();
        self.days.resize(days + 1, END);
        self.per_second = if horizon > 0.0 {
            days as f64 / horizon
        } else {
            0.0
        };
        self.today = 0;
    }

    #[inline]
    pub fn push(&mut self, contact: Contact) {
        let day = ((contact.time * self.per_second) as usize)
            .min(self.days.len() - 1)
            .max(self.today);
        let index = self.contacts.len() as u32;
        self.contacts.push((contact, self.days[day]));
        self.days[day] = index;
    }

    /// The earliest contact that is still fresh; stale ones are dropped.
    #[inline]
    pub fn pop(&mut self, is_fresh: impl Fn(&Contact) -> bool) -> Option<Contact> {
        while self.today < self.days.len() {
            let (mut best, mut before_best) = (END, END);
            let (mut before, mut at) = (END, self.days[self.today]);
            while at != END {
                let (contact, next) = &self.contacts[at as usize];
                let next = *next;
                if is_fresh(contact) {
                    if best == END || contact.is_before(&self.contacts[best as usize].0) {
                        (best, before_best) = (at, before);
                    }
                    before = at;
                } else {
                    self.unlink(before, next);
                }
                at = next;
            }
            if best != END {
                let (contact, next) = self.contacts[best as usize];
                self.unlink(before_best, next);
                return Some(contact);
            }
            self.today += 1;
        }
        None
    }

    fn unlink(&mut self, before: u32, next: u32) {
        if before == END {
            self.days[self.today] = next;
        } else {
            self.contacts[before as usize].1 = next;
        }
    }
}
