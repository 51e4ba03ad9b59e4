//! Rules: every rule with a record that shows it.

mod eight_ball;
mod nine_ball;
mod seen;
mod story;
mod straight;
mod ten_ball;
