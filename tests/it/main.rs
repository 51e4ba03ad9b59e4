//! The tests of the house, in one binary: judges with known answers, properties of every law, tables of another program,
//! the map of the rooms, and the order of the systems.

mod architecture;
mod catalogue;
mod cli;
mod closeness;
#[cfg(feature = "window")]
mod controls;
#[cfg(feature = "window")]
mod crowd_view;
mod crowds;
mod cue_path;
mod equip;
mod exact;
mod faults;
#[cfg(feature = "window")]
mod film;
mod frames;
mod fuzz;
mod guides;
mod hard;
mod judge;
mod judges;
#[cfg(feature = "window")]
mod languages;
mod live_exact;
#[cfg(feature = "window")]
mod looks;
mod matches;
#[cfg(feature = "window")]
mod menu;
mod players;
mod practice;
mod presets;
mod properties;
mod record_files;
#[cfg(feature = "window")]
mod referee_words;
mod reference;
mod rules;
mod same_bits;
mod saved_tables;
mod scenarios;
mod scene_files;
mod schedules;
mod settings;
#[cfg(feature = "window")]
mod slow_motion;
mod spawned_balls;
mod speed_report;
mod studio;
mod turns;
#[cfg(feature = "window")]
mod window;
