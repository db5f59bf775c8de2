#!/bin/sh
# Builds the crates for bare targets, and firmwares, which do not link if a panic can be reached, but for the one of async tasks: one
# has every machine of the services. If there is QEMU, runs three of them, and reads with `mavgen decode` what comes out of the UART.
# Into the gateway, and into the same of async tasks, go a batch of ESC telemetry (v1, then v2), a HEARTBEAT and pymavlink's command
# to shut down; into the component pymavlink's questions for parameters
# and commands. Prints what the services take: the flash of the component, and the RAM of each machine.
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
    cargo check --quiet $core --target "$target" -p mavlink-services --no-default-features
done

cd tests/firmware
cargo build --release --locked $core
built=${CARGO_TARGET_DIR:-target}/thumbv7m-none-eabi/release
bytes() { size -A "$built/$1" | awk '$1 ~ /^\.(text|rodata|data)/ { sum += $2 } END { print sum }'; }
flash=$(($(bytes component) - $(bytes empty)))
echo "a component with heartbeat, commands and 10 parameters: $flash bytes of flash, with the parser and the sender"
# Some percent above what was measured: more is a regression.
[ "$flash" -le 15500 ] || { echo "over the limit" >&2; exit 1; }
echo "RAM of the machines, in bytes:"
nm -S "$built/component" | awk '$4 ~ /^RAM_/ { print $2, substr($4, 5) }' | sort -k 2 | while read -r size name; do
    printf '%6d %s\n' "0x$size" "$(echo "$name" | sed 's/_/::/; s/_of_/ of /; s/_\([A-Z]\)/ of \1/')"
done
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
# Runs a firmware with these frames, and reads what it sent.
run() {
    printf '%s' "$2" | perl -ne 's/\s//g; print pack "H*", $_' | timeout 60 cargo run --quiet --release --locked $core --bin "$1" > "$out"
    "$mavgen" decode "../../xml/$3.xml" --input raw "$out" 2>/dev/null
}
info='ESC_INFO { index: 0, time_usec: 123456000 us, counter: 1, count: 4, connection_type: ESC_CONNECTION_TYPE_CAN, info: 7, failure_flags: [0, 0, ESC_FAILURE_MOTOR_STUCK, 0], error_count: [17, 0, 0, 0], temperature: [unknown, 2500, 3125, unknown] cdegC }'
status='ESC_STATUS { index: 0, time_usec: 123456000 us, rpm: [6543, 6601, 0, 0] rpm, voltage: [15.12, 15.1, 15.09, NaN] V, current: [8.73, 9.01, 0.0, NaN] A }'
beat='HEARTBEAT { type: MAV_TYPE_GENERIC, autopilot: MAV_AUTOPILOT_GENERIC, base_mode: 0, custom_mode: 0, system_status: MAV_STATE_ACTIVE, mavlink_version: 3 }'
expected="1/99 #0 $info
1/99 #1 $status
1/99 #2 $info
1/99 #3 $status
1/99 #4 $beat"
same() { [ "$1" = "$expected" ] || { printf 'the firmware sent:\n%s\n' "$1" >&2; exit 1; }; }
same "$(run gateway "$frames" autoquad)"
echo "the gateway on a Cortex-M3 runs: 4 messages in, 5 out"

expected="1/99 #0 $status
1/99 #1 $status
1/99 #2 $beat"
same "$(run tasks "$frames" autoquad)"
echo "its async tasks run as well: 4 messages in, 3 out"

frames='fd08000000ffbe140000ffff010142415544892a
fd17000001ffbe1700000600000001014d4f544f52530000000000000000000001358c
fd20000002ffbe4c00000000803f0000000000000000000000000000000000000000000000009001010142db
fd20000003ffbe4c000000000040000000000000000000000000000000000000000000000000f60001016333'
expected="1/1 PARAM_VALUE BAUD 115200
1/1 PARAM_VALUE MOTORS 6
1/1 COMMAND_ACK MAV_CMD_COMPONENT_ARM_DISARM MAV_RESULT_ACCEPTED
1/1 COMMAND_ACK MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN MAV_RESULT_ACCEPTED"
# Heartbeats come by the clock; of the others, what matters.
said=$(run component "$frames" common | perl -ne '
    print "$1 PARAM_VALUE $2" if m{^(1/1) .*PARAM_VALUE .*param_id: "(\w+)"};
    print " $1\n" if /parameter: bytewise (.*)/;
    print "$1 COMMAND_ACK $2 $3\n" if m{^(1/1) .*COMMAND_ACK .*command: (\w+), result: (\w+)}')
same "$said"
echo "the component on a Cortex-M3 runs: 4 messages in, 4 answers out"
