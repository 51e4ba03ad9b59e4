//! What expectations are made of, and what became of them, in words.

use std::fmt::{self, Display, Formatter};

use super::phrase::Word::{Apart, Ball, Count, Digits, Number, Pocket, Unit};
use super::phrase::{Phrase, Word, say};
use crate::physics::scene::Scene;
use crate::scenarios::expect::reading::{Ends, Shown};
use crate::scenarios::expect::{Contact, Expectation, Moment, Rail, Spot};

pub(super) fn ball(name: &str) -> Word {
    Ball(name.to_owned())
}

pub(super) fn pocket(name: &str) -> Word {
    Pocket(name.to_owned())
}

pub(super) fn contact(of: &Contact) -> Phrase {
    match of {
        Contact::Hit(a, b) => say!("contact-hit", "{a} meets {b}", a: ball(a), b: ball(b)),
        Contact::Rail(a) => say!("contact-rail", "{a} meets a cushion", a: ball(a)),
        Contact::RailAt(a, Rail::Head) => {
            say!("contact-rail-head", "{a} meets the head rail", a: ball(a))
        }
        Contact::RailAt(a, Rail::Foot) => {
            say!("contact-rail-foot", "{a} meets the foot rail", a: ball(a))
        }
        Contact::RailAt(a, Rail::Left) => {
            say!("contact-rail-left", "{a} meets the left rail", a: ball(a))
        }
        Contact::RailAt(a, Rail::Right) => {
            say!("contact-rail-right", "{a} meets the right rail", a: ball(a))
        }
        Contact::Falls(a) => say!("contact-falls", "{a} falls", a: ball(a)),
        Contact::FallsInto(a, into) => {
            say!("contact-falls-into", "{a} falls into {pocket}", a: ball(a), pocket: pocket(into))
        }
        Contact::Lands(a) => say!("contact-lands", "{a} lands", a: ball(a)),
        Contact::Leaves(a) => say!("contact-leaves", "{a} leaves the table", a: ball(a)),
    }
}

pub(super) fn moment(of: &Moment) -> Phrase {
    match of {
        Moment::Start => say!("moment-start", "the start"),
        Moment::End => say!("moment-end", "the end"),
        Moment::At(time) => say!("moment-at", "{time} s", time: Number(*time)),
        Moment::Hit(a, b) => {
            say!("moment-hit", "the hit of {a} and {b}", a: ball(a), b: ball(b))
        }
        Moment::After(a, b) => say!(
            "moment-after", "the moment after the hit of {a} and {b}", a: ball(a), b: ball(b)
        ),
        Moment::Rail(a, number) => say!(
            "moment-rail", "cushion {number} of {a}", a: ball(a), number: Count(*number as usize)
        ),
        Moment::AfterRail(a, number) => say!(
            "moment-after-rail", "the moment after cushion {number} of {a}",
            a: ball(a), number: Count(*number as usize),
        ),
        Moment::Rolls(a) => {
            say!("moment-rolls", "the moment when {a} begins to roll", a: ball(a))
        }
        Moment::Rests(a) => say!("moment-rests", "the rest of {a}", a: ball(a)),
        Moment::Falls(a) => say!("moment-falls", "the fall of {a}", a: ball(a)),
        Moment::Lands(a) => say!("moment-lands", "the landing of {a}", a: ball(a)),
    }
}

pub(super) fn spot(of: &Spot) -> Phrase {
    match of {
        Spot::Position(x, z) => {
            say!("spot-position", "x = {x} m, z = {z} m", x: Number(*x), z: Number(*z))
        }
        Spot::Diamonds(across, along) => say!(
            "spot-diamonds", "diamonds {across}, {along}",
            across: Number(*across), along: Number(*along),
        ),
        Spot::Start(a) => say!("spot-start", "the place where {a} began", a: ball(a)),
    }
}

/// A unit in words where it has any.
fn unit(name: &'static str) -> Word {
    match name {
        "times" => say!("unit-times", "times").into(),
        "degrees" => say!("unit-degrees", "degrees").into(),
        "m away" => say!("unit-away", "m away").into(),
        "m outside" => say!("unit-outside", "m outside").into(),
        name => Unit(name),
    }
}

/// The values that are allowed.
pub(super) fn ends(Ends(least, most): Ends, name: &'static str) -> Phrase {
    let (unit, number) = (unit(name), Number);
    match (least, most) {
        (Some(least), Some(most)) => say!(
            "range-both", "{least} to {most} {unit}",
            least: number(least), most: number(most), unit: unit,
        ),
        (Some(least), None) => {
            say!("range-least", "at least {least} {unit}", least: number(least), unit: unit)
        }
        (None, Some(most)) => {
            say!("range-most", "at most {most} {unit}", most: number(most), unit: unit)
        }
        (None, None) => say!("range-any", "anything"),
    }
}

/// What is said about a time only if it is not the whole run.
pub(super) fn between(from: &Moment, until: &Moment) -> Word {
    Apart(
        match (from.is_start(), until.is_end()) {
            (true, true) => None,
            (false, true) => Some(say!("span-after", "after {from}", from: moment(from))),
            (true, false) => Some(say!("span-before", "before {until}", until: moment(until))),
            (false, false) => Some(say!(
                "span-between", "between {from} and {until}",
                from: moment(from), until: moment(until),
            )),
        }
        .map(Box::new),
    )
}

/// What happened.
pub(super) fn seen(shown: &Shown, scene: &Scene) -> Phrase {
    match shown {
        Shown::Value(value, "times") => {
            say!("seen-value", "{value} {unit}", value: Number(*value), unit: unit("times"))
        }
        Shown::Value(value, name) => {
            say!("seen-value", "{value} {unit}", value: Digits(*value, 4), unit: unit(name))
        }
        Shown::Fell { pocket: at, time } => match scene.table.pockets.get(*at) {
            Some(found) => say!(
                "seen-fell", "it fell into {pocket} at {time} s",
                pocket: pocket(&found.name), time: Digits(*time, 3),
            ),
            None => say!("seen-happened", "it happened at {time} s", time: Digits(*time, 3)),
        },
        Shown::Left { time } => {
            say!("seen-left", "it left the table at {time} s", time: Digits(*time, 3))
        }
        Shown::Stayed => say!("seen-stayed", "it stayed on the table"),
        Shown::Steps { done, of } if done == of => say!("seen-so", "so it was"),
        Shown::Steps { done, of } => {
            say!("seen-steps", "{done} of {of} came", done: Count(*done), of: Count(*of))
        }
        Shown::Happened(Some(time)) => {
            say!("seen-happened", "it happened at {time} s", time: Digits(*time, 3))
        }
        Shown::Happened(None) => say!("seen-not", "it did not happen"),
        Shown::NoMoment => say!("seen-no-moment", "this moment never came"),
        Shown::NoDirection => say!("seen-no-direction", "it did not move then"),
        Shown::Beside(distance) => {
            say!("seen-beside", "it passed {distance} m beside", distance: Digits(*distance, 4))
        }
    }
}

impl Display for Contact {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        contact(self).fmt(f)
    }
}

impl Display for Moment {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        moment(self).fmt(f)
    }
}

impl Display for Expectation {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        self.wanted().fmt(f)
    }
}
