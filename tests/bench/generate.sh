#!/bin/sh
# The generator as a build script runs it, unoptimised, beside mavlink-bindgen with rustfmt, optimised. Usage:
# generate.sh [ROUNDS]. The two are two programs, so their rounds cannot be interleaved: the optimised one runs first and last.
set -eu

cd "$(dirname -- "$0")"
cargo build --quiet --release --bin generate
cargo build --quiet --bin generate
target=${CARGO_TARGET_DIR:-target}
for profile in release debug release; do
    echo "$profile"
    "$target/$profile/generate" "${1:-7}"
done
