#!/bin/sh
# The same frictionless gas in a crowd and in Rapier 2D, turn by turn in one run: time a tick, energy, overlap, and how many
# times the time of the crowd Rapier takes: at the same tick, and at finer ones that keep energy and distances better.
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
    for rate in 120 480 1920; do
        # The same time goes by at every rate.
        ours=$("$target/release/examples/time_crowd" "$balls" 50 120 gas "$threads")
        theirs=$("$target/rapier/release/rapier-gas" "$balls" $((50 * rate / 120)) "$rate" "$threads")
        printf '%s\n%s\n' "$ours" "$theirs"
        printf '%s\n%s\n' "$ours" "$theirs" | awk -v balls="$balls" -v rate="$rate" '
            {
                for (i = 2; i <= NF; i++) {
                    if ($i == "ns" && $(i + 1) == "a") wall[$1 ~ /Rapier/] = $(i - 1)
                    if ($i == "ns" && $(i + 1) == "of") cpu[$1 ~ /Rapier/] = $(i - 1)
                }
            }
            END {
                ticks = rate / 120
                printf "%d balls, crowd at 1/120 s, Rapier at 1/%d s: Rapier takes %.0f times the time and %.0f times the processor time\n",
                    balls, rate, ticks * wall[1] / wall[0], ticks * cpu[1] / cpu[0]
            }'
    done
done
