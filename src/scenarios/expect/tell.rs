//! Expectations and what became of them, in words.

use std::fmt::{self, Display, Formatter};

use crate::physics::scene::Scene;
use crate::scenarios::expect::measure::Shown;
use crate::scenarios::expect::{Contact, Expectation, Moment, Rail, Spot};

impl Display for Contact {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::Hit(a, b) => write!(f, "`{a}` meets `{b}`"),
            Self::Rail(ball) => write!(f, "`{ball}` meets a cushion"),
            Self::RailAt(ball, rail) => {
                let side = match rail {
                    Rail::Head => "head",
                    Rail::Foot => "foot",
                    Rail::Left => "left",
                    Rail::Right => "right",
                };
                write!(f, "`{ball}` meets the {side} rail")
            }
            Self::Falls(ball) => write!(f, "`{ball}` falls"),
            Self::FallsInto(ball, pocket) => write!(f, "`{ball}` falls into {pocket}"),
            Self::Lands(ball) => write!(f, "`{ball}` lands"),
            Self::Leaves(ball) => write!(f, "`{ball}` leaves the table"),
        }
    }
}

impl Display for Moment {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::Start => write!(f, "the start"),
            Self::End => write!(f, "the end"),
            Self::At(time) => write!(f, "{time} s"),
            Self::Hit(a, b) => write!(f, "the hit of `{a}` and `{b}`"),
            Self::After(a, b) => write!(f, "the moment after the hit of `{a}` and `{b}`"),
            Self::Rail(ball, number) => write!(f, "cushion {number} of `{ball}`"),
            Self::AfterRail(ball, number) => {
                write!(f, "the moment after cushion {number} of `{ball}`")
            }
            Self::Rolls(ball) => write!(f, "the moment when `{ball}` begins to roll"),
            Self::Rests(ball) => write!(f, "the rest of `{ball}`"),
            Self::Falls(ball) => write!(f, "the fall of `{ball}`"),
            Self::Lands(ball) => write!(f, "the landing of `{ball}`"),
        }
    }
}

impl Display for Spot {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::Position(x, z) => write!(f, "x = {x} m, z = {z} m"),
            Self::Diamonds(across, along) => write!(f, "diamonds {across}, {along}"),
            Self::Start(ball) => write!(f, "the place where `{ball}` began"),
        }
    }
}

/// A range in words.
fn range(least: Option<f64>, most: Option<f64>, unit: &str) -> String {
    match (least, most) {
        (Some(least), Some(most)) => format!("{least} to {most} {unit}"),
        (Some(least), None) => format!("at least {least} {unit}"),
        (None, Some(most)) => format!("at most {most} {unit}"),
        (None, None) => "anything".to_owned(),
    }
}

/// What is said about a time only if it is not the whole run.
fn between(from: &Moment, until: &Moment) -> String {
    match (from.is_start(), until.is_end()) {
        (true, true) => String::new(),
        (false, true) => format!(" after {from}"),
        (true, false) => format!(" before {until}"),
        (false, false) => format!(" between {from} and {until}"),
    }
}

impl Display for Expectation {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&wanted(self))
    }
}

/// What is expected.
#[expect(clippy::too_many_lines, reason = "one arm for each kind")]
pub(super) fn wanted(expected: &Expectation) -> String {
    match expected {
        Expectation::Potted { ball, pocket } => match pocket {
            Some(pocket) => format!("`{ball}` falls into {pocket}"),
            None => format!("`{ball}` is potted"),
        },
        Expectation::Stays { ball } => format!("`{ball}` stays on the table"),
        Expectation::Order(contacts) => {
            let told: Vec<String> = contacts.iter().map(Contact::to_string).collect();
            told.join(", then ")
        }
        Expectation::Never(contact) => format!("never: {contact}"),
        Expectation::Count {
            of,
            least,
            most,
            until,
        } => {
            let ends = range(least.map(f64::from), most.map(f64::from), "times");
            format!("{of} {ends}{}", between(&Moment::Start, until))
        }
        Expectation::Near {
            ball,
            at,
            within,
            when,
        } => format!("`{ball}` is within {within} m of {at} at {when}"),
        Expectation::Inside {
            ball,
            least,
            most,
            when,
        } => format!(
            "`{ball}` is between x = {} m, z = {} m and x = {} m, z = {} m at {when}",
            least.0, least.1, most.0, most.1
        ),
        Expectation::Passes {
            ball,
            at,
            within,
            from,
            until,
        } => format!(
            "`{ball}` passes within {within} m of {at}{}",
            between(from, until)
        ),
        Expectation::Gap {
            ball,
            of,
            least,
            most,
            from,
            until,
        } => format!(
            "the smallest gap between `{ball}` and `{of}`{} is {}",
            between(from, until),
            range(*least, *most, "m")
        ),
        Expectation::Height {
            ball,
            least,
            most,
            from,
            until,
        } => format!(
            "`{ball}` rises{} {} over the slate",
            between(from, until),
            range(*least, *most, "m")
        ),
        Expectation::Over {
            ball,
            of,
            least,
            most,
        } => format!(
            "`{ball}` flies {} over the top of `{of}`",
            range(*least, *most, "m")
        ),
        Expectation::Speed {
            ball,
            least,
            most,
            when,
        } => format!(
            "the speed of `{ball}` at {when} is {}",
            range(*least, *most, "m/s")
        ),
        Expectation::Heading {
            ball,
            deg,
            within_deg,
            when,
        } => format!("`{ball}` moves along {deg} degrees, within {within_deg}, at {when}"),
        Expectation::Turns {
            ball,
            least,
            most,
            from,
            to,
        } => format!(
            "`{ball}` turns by {} between {from} and {to}",
            range(*least, *most, "degrees")
        ),
        Expectation::Travels {
            ball,
            least,
            most,
            from,
            to,
        } => format!(
            "`{ball}` travels {}{}",
            range(*least, *most, "m"),
            between(from, to)
        ),
        Expectation::Advances {
            ball,
            least,
            most,
            from,
            to,
        } => format!(
            "`{ball}` gets {} ahead{}",
            range(*least, *most, "m"),
            between(from, to)
        ),
        Expectation::Time { of, least, most } => {
            format!("{of} comes at {}", range(*least, *most, "s"))
        }
    }
}

/// What happened.
pub(super) fn seen(shown: &Shown, scene: &Scene) -> String {
    match shown {
        Shown::Value(value, "times") => format!("{value} times"),
        Shown::Value(value, unit) => format!("{value:.4} {unit}"),
        Shown::Fell { pocket, time } => {
            let name = scene
                .table
                .pockets
                .get(*pocket)
                .map_or("a pocket", |p| p.name.as_str());
            format!("it fell into {name} at {time:.3} s")
        }
        Shown::Left { time } => format!("it left the table at {time:.3} s"),
        Shown::Stayed => "it stayed on the table".to_owned(),
        Shown::Steps { done, of } if done == of => "so it was".to_owned(),
        Shown::Steps { done, of } => format!("{done} of {of} came"),
        Shown::Happened(Some(time)) => format!("it happened at {time:.3} s"),
        Shown::Happened(None) => "it did not happen".to_owned(),
        Shown::NoMoment => "this moment never came".to_owned(),
        Shown::NoDirection => "it did not move then".to_owned(),
        Shown::Beside(distance) => format!("it passed {distance:.4} m beside"),
    }
}
