#!/bin/sh
# The same frictionless gas in a crowd and in Rapier 2D, turn by turn in one run: time a tick, energy, overlap, and how many
# times the processor time of the crowd Rapier takes.
# Usage: scripts/compare_rapier.sh [THREADS] [BALLS...]
set -eu
cd "$(dirname "$0")/.."
threads="${1:-2}"
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- 5750 50000 250000
target="${CARGO_TARGET_DIR:-target}"
cargo build --release --no-default-features --example time_crowd
cargo build --release --manifest-path benches/rapier/Cargo.toml --target-dir "$target/rapier"
for balls in "$@"; do
    for turn in 1 2; do
        ours=$("$target/release/examples/time_crowd" "$balls" 50 120 gas "$threads")
        theirs=$("$target/rapier/release/rapier-gas" "$balls" 50 120 "$threads")
        printf '%s\n%s\n' "$ours" "$theirs"
        printf '%s\n%s\n' "$ours" "$theirs" | awk -v balls="$balls" -v turn="$turn" '
            {
                for (i = 2; i <= NF; i++) {
                    if ($i == "ns" && $(i + 1) == "a") wall[$1 ~ /Rapier/] = $(i - 1)
                    if ($i == "ns" && $(i + 1) == "of") cpu[$1 ~ /Rapier/] = $(i - 1)
                }
            }
            END {
                printf "%d balls, turn %d: Rapier takes %.1f times the time and %.1f times the processor time\n",
                    balls, turn, wall[1] / wall[0], cpu[1] / cpu[0]
            }'
    done
done
