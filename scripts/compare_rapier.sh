#!/bin/sh
# The same frictionless gas in a crowd and in Rapier 2D, turn by turn in one run: time a tick, energy, overlap.
# Usage: scripts/compare_rapier.sh [THREADS]
set -eu
cd "$(dirname "$0")/.."
threads="${1:-2}"
target="${CARGO_TARGET_DIR:-target}"
cargo build --release --no-default-features --example time_crowd
cargo build --release --manifest-path benches/rapier/Cargo.toml --target-dir "$target/rapier"
for balls in 5750 50000 250000; do
    for turn in 1 2; do
        "$target/release/examples/time_crowd" "$balls" 50 120 gas "$threads"
        "$target/rapier/release/rapier-gas" "$balls" 50 120 "$threads"
    done
done
