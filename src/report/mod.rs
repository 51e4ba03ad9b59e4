//! What is told about a run: record files and pictures, tables of judges, charts, speed against error.

pub mod audit;
pub mod catalogue;
pub mod chart;
pub mod heat_map;
pub mod judge;
pub mod picture;
pub mod raster;
pub mod record_file;
pub mod speed_and_error;
pub mod states;
