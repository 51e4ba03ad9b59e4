//! What holds for every registered law and any input: energy never rises, momentum is kept, mirror images mirror, and a
//! number stays a number.
//!
//! A new variant of a law does not compile here until [`inputs`] knows how to vary its parameters.

mod ball_ball;
mod cushion;
mod free_motion;
pub mod inputs;
mod slate_and_cue;

use proptest::test_runner::Config;

/// Enough cases to meet every branch many times, few enough to take a second or two; `MASSE_CASES` asks for more.
fn cases() -> Config {
    let cases = std::env::var("MASSE_CASES")
        .ok()
        .and_then(|text| text.parse().ok());
    Config::with_cases(cases.unwrap_or(5000))
}

/// Fails unless the energy after is at most the energy before, but for rounding of all that went into it.
#[track_caller]
fn assert_no_gain(before: f64, after: f64) {
    assert!(
        after <= before * (1.0 + 1e-12),
        "energy rises from {before:e} J to {after:e} J"
    );
}
