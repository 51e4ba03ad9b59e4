//! Massé: a billiards game and simulator.
//!
//! To simulate a shot, sweep a number over ten thousand of them, or put balls into an app of your own:
//! `docs/use-as-a-library.md`. The shortest way in is [`sim::play::play`], the next [`scenarios::sweep`].
//!
//! Rooms, one above the other; an import only ever points down:
//!
//! | room | what it holds |
//! |---|---|
//! | [`physics`] | pure laws, tables, scenes, records: f64, SI, no App |
//! | [`kept`] | files that a player keeps: whole or not at all |
//! | [`sim`] | the table as a Bevy world, headless: components, messages, the clock, the solvers as ordered systems |
//! | [`scenarios`] | scene files and the library of scenes |
//! | [`report`] | what is told about a run: record files, pictures |
//! | [`game`] | what the player aims, practice; no pixels |
//! | `window` | what a person sees and touches; feature `window` |
//! | [`cli`] | the command line, on top of all |

/// The guide, whose blocks of code are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../docs/use-as-a-library.md")]
mod guide {}

pub mod cli;
pub mod game;
pub mod kept;
pub mod physics;
pub mod report;
pub mod scenarios;
pub mod sim;
#[cfg(feature = "window")]
pub mod window;
