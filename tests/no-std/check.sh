#!/bin/sh
# Builds the program, and lets it read two AQ_ESC_TELEMETRY frames (v1, v2), with a false start between them, and an
# AutoQuad's HEARTBEAT: 4 + 4 + 100.
set -eu
cd "$(dirname "$0")"
cargo build --release --locked
target=${CARGO_TARGET_DIR:-target}
frames='fe37002abe9840e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf00000000040009000700ffff01040401020304151e1f00d9ed
fefd
fd360000002abe98000040e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf00000000040009000700ffff01040401020304151e1f5ea1
fe090001010000000000020e000403a468'
seen=0
printf '%s' "$frames" | perl -ne 's/\s//g; print pack "H*", $_' | "$target/release/mavlink-no-std" || seen=$?
test "$seen" = 108 || { echo "expected 108, saw $seen"; exit 1; }
echo "no std, no alloc, no panic: saw $seen"
