#!/bin/sh
# Fails if decoding a message of any kind, or finding its frame, needs more stack than promised (`src/lib.rs` has the limits):
# unoptimised and at opt-level z, here and on a Cortex-M3, which QEMU runs, if there are both. Fails as well if a signing key is left
# on the stack, or in what has sent or received it: unoptimised, at opt-level z and 3.
#
# The Cortex-M3 needs its target of rustup, or its component rust-src, of which `core` is built then.
set -eu
cd "$(dirname "$0")"

for profile in dev release; do
    echo "this machine, profile $profile"
    cargo run --quiet --locked --profile "$profile" --features host --bin host
done

for profile in dev release fast; do
    echo "keys, profile $profile"
    cargo run --quiet --locked --profile "$profile" --features keys --bin keys
done

target=thumbv7m-none-eabi
core=
if ! rustc --print target-libdir --target "$target" | xargs test -d; then
    [ -d "$(rustc --print sysroot)/lib/rustlib/src/rust/library" ] || exit 0
    core="-Zbuild-std=core"
    # What builds `core` is not stable yet. The toolchain is.
    export RUSTC_BOOTSTRAP=1
fi
if ! command -v qemu-system-arm >/dev/null; then
    echo "without qemu-system-arm the Cortex-M3 is not measured"
    exit 0
fi
for profile in dev release; do
    echo "Cortex-M3, profile $profile"
    timeout 600 cargo run --quiet --locked --profile "$profile" $core --target "$target" --features cortex-m --bin cortex-m
done
