//! Attacks that go on: random scenes for both solvers, damaged files, random command lines.
//!
//! The tests run a few cases of each. `MASSE_FUZZ=100000` asks for more, `MASSE_FUZZ_SEED=7` for others; a scene that fails is
//! written as a scene file into cargo's folder for tests, from where it goes to `tests/data/hard`, which is played
//! again for ever.

mod command_lines;
mod kept;
#[cfg(feature = "window")]
mod languages;
mod places;
mod saved_cases;
mod saved_tables;
mod scenes;
mod sound;
mod texts;
mod wedged;
pub(crate) mod whims;

use std::fmt::Debug;
use std::panic::{AssertUnwindSafe, catch_unwind};

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

fn number(variable: &str) -> Option<u64> {
    std::env::var(variable).ok()?.parse().ok()
}

/// Runs a test on random inputs, so many by default; one that panics fails like one that returns an error.
#[track_caller]
fn attack<S>(cases: u32, inputs: &S, test: impl Fn(S::Value) -> Result<(), String>)
where
    S: Strategy,
    S::Value: Debug,
{
    let asked = number("MASSE_FUZZ").and_then(|cases| u32::try_from(cases).ok());
    let config = Config {
        cases: asked.unwrap_or(cases),
        max_shrink_iters: 4000,
        ..Config::default()
    };
    let mut seed = [0; 32];
    seed[..8].copy_from_slice(&number("MASSE_FUZZ_SEED").unwrap_or(0).to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(config, rng);
    let outcome = runner.run(inputs, |input| {
        let outcome = catch_unwind(AssertUnwindSafe(|| test(input)));
        let outcome = outcome.unwrap_or_else(|_| Err("it panics".to_owned()));
        outcome.map_err(TestCaseError::fail)
    });
    if let Err(error) = outcome {
        panic!("{error}");
    }
}
