//! What is told about a run: record files and pictures, tables of judges, charts, and later of speed.

pub mod audit;
pub mod chart;
pub mod judge;
pub mod picture;
pub mod record_file;
