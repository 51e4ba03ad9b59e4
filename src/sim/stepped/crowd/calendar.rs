//! Contacts in order of time: a calendar of short stretches, of which only the one at hand is sorted.

use crate::sim::stepped::crowd::turned::Contact;

/// Stretches of a tick.
const PAGES: usize = 64;

/// What waits for its time.
#[derive(Debug, Default)]
pub(super) struct Calendar {
    pages: Vec<Vec<Contact>>,
    /// The page at hand, the earliest contact last, and its index.
    due: Vec<Contact>,
    page: usize,
    start: f64,
    per_second: f64,
}

impl Calendar {
    /// An empty calendar for a stretch of time.
    pub fn open(&mut self, start: f64, end: f64) {
        self.pages.resize_with(PAGES, Vec::new);
        self.page = 0;
        self.start = start;
        self.per_second = PAGES as f64 / (end - start);
    }

    #[inline]
    pub fn push(&mut self, contact: Contact) {
        // The cast saturates: what is late is due at once. What comes at the very end belongs to the last page.
        let page = ((contact.time - self.start) * self.per_second) as usize;
        let page = page.min(PAGES - 1);
        if page > self.page {
            self.pages[page].push(contact);
        } else {
            let sooner = |other: &Contact| other.is_after(&contact);
            let at = self.due.iter().rposition(sooner).map_or(0, |at| at + 1);
            self.due.insert(at, contact);
        }
    }

    /// Takes the earliest.
    #[inline]
    pub fn pop(&mut self) -> Option<Contact> {
        loop {
            if let Some(contact) = self.due.pop() {
                return Some(contact);
            }
            if self.page + 1 >= self.pages.len() {
                self.page = 0;
                return None;
            }
            self.page += 1;
            let page = &mut self.pages[self.page];
            if page.is_empty() {
                continue;
            }
            std::mem::swap(&mut self.due, page);
            let due = &mut self.due;
            for k in 1..due.len() {
                let contact = due[k];
                let mut at = k;
                while at > 0 && contact.is_after(&due[at - 1]) {
                    due[at] = due[at - 1];
                    at -= 1;
                }
                due[at] = contact;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::stepped::crowd::turned::Kind;

    fn contact(time: f64, ball: u32) -> Contact {
        Contact {
            time,
            ball,
            kind: Kind::Change,
            turns: [0; 2],
        }
    }

    #[test]
    fn contacts_come_in_order_of_time_whenever_they_are_put_in() {
        let mut calendar = Calendar::default();
        calendar.open(2.0, 3.0);
        for (time, ball) in [(2.9, 4), (2.1, 1), (2.101, 2), (1.5, 0)] {
            calendar.push(contact(time, ball));
        }
        let mut order = Vec::new();
        while let Some(next) = calendar.pop() {
            order.push(next.ball);
            match next.ball {
                1 => calendar.push(contact(2.5, 3)),
                // On the last page, and at the very end of the tick: it must not wait for the next one.
                4 => calendar.push(contact(2.999, 5)),
                5 => calendar.push(contact(3.0, 6)),
                _ => {}
            }
        }
        assert_eq!(order, [0, 1, 2, 3, 4, 5, 6]);
        calendar.open(3.0, 4.0);
        assert!(calendar.pop().is_none(), "nothing is left");
    }
}
