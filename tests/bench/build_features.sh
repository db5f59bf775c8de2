#!/bin/sh
# Clean builds of a program that uses our committed sources, with each optional feature: what it costs to turn one on.
# Usage: build_features.sh [REPETITIONS]. Prints the least time of the whole build and of the dialect's crate alone, with
# their ratios to the build without features. Processor time, so that a busy machine matters less.
set -eu

repetitions=${1:-3}
export CARGO_INCREMENTAL=0
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
root=$(CDPATH='' cd -- "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
features="none commands serde defmt arbitrary bitflags mavlink-core all"

for feature in $features; do
    case $feature in
        none) list="" ;;
        all) list=', "commands", "serde", "defmt", "arbitrary", "bitflags", "mavlink-core"' ;;
        *) list=", \"$feature\"" ;;
    esac
    mkdir -p "$work/$feature/src"
    {
        printf '[workspace]\n[package]\nname = "consumer"\nversion = "0.0.0"\nedition = "2024"\n[dependencies]\n'
        printf 'mavlink-autoquad = { path = "%s/mavlink-autoquad", default-features = false, features = ["fast-crc"%s] }\n' "$root" "$list"
    } >"$work/$feature/Cargo.toml"
    printf 'fn main() {\n    println!("{}", mavlink_autoquad::autoquad::Heartbeat::default().mavlink_version);\n}\n' >"$work/$feature/src/main.rs"
    # So that every version is the one that the project is tested with.
    cp "$root/Cargo.lock" "$work/$feature/Cargo.lock"
    (cd "$work/$feature" && cargo fetch --quiet)
done

# Builds into a target folder; adds the processor seconds to a list.
timed() { # name, list
    (cd "$work/$1" && CARGO_TARGET_DIR="$work/target" /usr/bin/time -f '%U %S' -o "$work/time" cargo build --quiet --offline)
    awk '{ print $1 + $2 }' "$work/time" >>"$2"
}

for _ in $(seq "$repetitions"); do
    for feature in $features; do
        rm -rf "$work/target"
        timed "$feature" "$work/whole.$feature"
        (cd "$work/$feature" && cargo clean --quiet --offline --target-dir "$work/target" -p mavlink-autoquad)
        timed "$feature" "$work/crate.$feature"
    done
done

least() { sort -n "$1" | head -n 1; }

for feature in $features; do
    echo "$feature $(least "$work/whole.$feature") $(least "$work/whole.none") $(least "$work/crate.$feature") $(least "$work/crate.none")"
done | awk '{ printf "%-12s whole %6.2f s  ratio %.2f   crate %6.2f s  ratio %.2f\n", $1, $2, $2 / $3, $4, $4 / $5 }'
