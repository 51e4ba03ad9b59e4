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
        // The cast saturates: what is late is due at once.
        let page = ((contact.time - self.start) * self.per_second) as usize;
        if page > self.page {
            self.pages[page.min(PAGES - 1)].push(contact);
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
