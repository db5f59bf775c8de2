#!/bin/sh
# Builds the program, and lets it read two AQ_ESC_TELEMETRY frames (v1, v2), with a false start between them, and an
# AutoQuad's HEARTBEAT: 4 + 4 + 100. With signatures, the MAVLink 2 frame also crosses a signed link: 1 more.
set -eu
cd "$(dirname "$0")"
target=${CARGO_TARGET_DIR:-target}
frames='fe37002abe9840e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf00000000040009000700ffff01040401020304151e1f00d9ed
fefd
fd360000002abe98000040e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf00000000040009000700ffff01040401020304151e1f5ea1
fe090001010000000000020e000403a468'

# What the program sees if it is built with these options.
check() {
    expected=$1
    shift
    cargo build --release --locked "$@"
    seen=0
    printf '%s' "$frames" | perl -ne 's/\s//g; print pack "H*", $_' | "$target/release/mavlink-no-std" || seen=$?
    test "$seen" = "$expected" || { echo "expected $expected, saw $seen"; exit 1; }
    echo "no std, no alloc, no panic: saw $seen"
}

check 108
check 109 --features signing
# The log has 4 and 12 motors, and the last status survives CDR.
check 125 --features px4
