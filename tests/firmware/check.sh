#!/bin/sh
# Builds the crates for bare targets, and a firmware, which does not link if a panic can be reached. If there is QEMU, runs it:
# a batch of ESC telemetry (v1, then v2), a HEARTBEAT and pymavlink's command to shut down go in at its UART; what comes out is
# read with `mavgen decode`.
#
# Needs the targets of rustup, or its component rust-src, of which `core` is built then.
# usage: check.sh MAVGEN
set -eu
[ $# -eq 1 ] || { echo "usage: check.sh MAVGEN" >&2; exit 2; }
mavgen=$1
cd "$(dirname "$0")/../.."

core=
if ! rustc --print target-libdir --target thumbv7m-none-eabi | xargs test -d; then
    core="-Zbuild-std=core"
    # What builds `core` is not stable yet. The toolchain is.
    export RUSTC_BOOTSTRAP=1
fi

# Cortex-M0, which has no compare-and-swap, and RISC-V.
for target in thumbv6m-none-eabi riscv32imc-unknown-none-elf; do
    for features in "" "fast-crc embedded-io embedded-io-async signing serde defmt bitflags"; do
        cargo check --quiet $core --target "$target" -p mavlink-autoquad --no-default-features --features "$features"
        echo "$target: checked with features: ${features:-none}"
    done
done

cd tests/firmware
cargo build --release --locked $core
if ! command -v qemu-system-arm >/dev/null; then
    echo "the firmware links; without qemu-system-arm it is not run"
    exit 0
fi

frames='fe37002abe9840e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf00000000040009000700ffff01040401020304151e1f00d9ed
fd360000002abe98000040e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf00000000040009000700ffff01040401020304151e1f5ea1
fe090001010000000000020e000403a468
fd20000000ffbe4c000000000040000000000000000000000000000000000000000000000000f600010151ec'
out=$(mktemp)
trap 'rm -f "$out"' EXIT
printf '%s' "$frames" | perl -ne 's/\s//g; print pack "H*", $_' | timeout 60 cargo run --quiet --release --locked $core > "$out"

info='ESC_INFO { index: 0, time_usec: 123456000 us, counter: 1, count: 4, connection_type: ESC_CONNECTION_TYPE_CAN, info: 7, failure_flags: [0, 0, ESC_FAILURE_MOTOR_STUCK, 0], error_count: [17, 0, 0, 0], temperature: [unknown, 2500, 3125, unknown] cdegC }'
status='ESC_STATUS { index: 0, time_usec: 123456000 us, rpm: [6543, 6601, 0, 0] rpm, voltage: [15.12, 15.1, 15.09, NaN] V, current: [8.73, 9.01, 0.0, NaN] A }'
beat='HEARTBEAT { type: MAV_TYPE_GENERIC, autopilot: MAV_AUTOPILOT_GENERIC, base_mode: 0, custom_mode: 0, system_status: MAV_STATE_ACTIVE, mavlink_version: 3 }'
expected="1/99 #0 $info
1/99 #1 $status
1/99 #2 $info
1/99 #3 $status
1/99 #4 $beat"
said=$("$mavgen" decode ../../xml/autoquad.xml --input raw "$out" 2>/dev/null)
[ "$said" = "$expected" ] || { printf 'the firmware sent:\n%s\n' "$said" >&2; exit 1; }
echo "the firmware of a Cortex-M3 runs: 4 messages in, 5 out"
