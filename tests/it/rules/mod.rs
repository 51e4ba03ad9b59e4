//! Rules: every rule with a record that shows it.

mod command;
mod eight_ball;
mod general;
mod nine_ball;
mod seen;
mod snooker;
mod story;
mod straight;
mod ten_ball;
mod three_cushion;
mod wording;
