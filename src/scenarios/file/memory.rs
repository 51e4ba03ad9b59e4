//! How much memory there is for balls.

/// Bytes that one ball takes in all at most while its scene is read and laid out: name, entity, components, record.
pub(super) const BALL: u64 = 2048;

/// Bytes that can be had without swapping, where the system tells.
pub(super) fn available() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text
        .lines()
        .find(|line| line.starts_with("MemAvailable:"))?;
    let kibibytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes * 1024)
}
