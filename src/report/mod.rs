//! What is told about a run: record files and pictures, and later tables of judges and of speed.

pub mod picture;
pub mod record_file;
