//! Rules: every rule with a record that shows it.

mod eight_ball;
mod seen;
mod story;
