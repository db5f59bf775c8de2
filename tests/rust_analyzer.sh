#!/bin/sh
# Holds that rust-analyzer resolves what a build script generates: the names in examples/own-dialect's program lead through
# `include_dialect!`, the shim in OUT_DIR and the tree behind it to types, fields, constants and the views of an overlay.
#
# Not part of the gate, because rust-analyzer takes longer to build than all of it. With a toolchain that is new enough:
#     cargo install ra_ap_rust-analyzer        0.0.349 is the last that rustc 1.95 (then nightly) can build
# usage: rust_analyzer.sh [RUST_ANALYZER]
set -eu
cd "$(dirname "$0")/.."
analyzer=${1:-rust-analyzer}
crate=$(mktemp -d)
trap 'rm -rf "$crate"' EXIT

# A crate of its own: rust-analyzer indexes all members of a workspace.
cp -r examples/own-dialect/src examples/own-dialect/xml Cargo.lock "$crate"
sed "s|\"../../xml\"|\"$PWD/xml\"|" examples/own-dialect/build.rs > "$crate/build.rs"
cat > "$crate/Cargo.toml" <<MANIFEST
[package]
name = "own-dialect"
version = "0.0.0"
edition = "2024"

[dependencies]
mavlink-wire = { path = "$PWD/mavlink-wire" }

[build-dependencies]
mavgen = { path = "$PWD/mavgen" }

[workspace]
MANIFEST

log=$crate/log
(cd "$crate" && "$analyzer" scip . --output "$crate/index.scip" --exclude-vendored-libraries > "$log" 2>&1) || { cat "$log" >&2; exit 1; }

# The symbols that the program refers to, and the types that rust-analyzer gives its variables.
missing=0
while read -r name; do
    grep -qaF "$name" "$crate/index.scip" || { echo "rust-analyzer does not resolve: $name" >&2; missing=1; }
done <<'NAMES'
farm/dialect/Farm#Sprayer#
farm/dialect/impl#[Farm][Dialect]TABLE.
farm/dialect/impl#[Farm][`From<Heartbeat>`]from().
farm/enums/mav_type/impl#[MavType]HEXAROTOR.
farm/enums/spray_state/impl#[SprayState]ON.
farm/messages/heartbeat/Heartbeat#system_status.
farm/messages/sprayer/Sprayer#state.
farm/messages/sprayer/impl#[Sprayer][Message]DEFAULT.
farm/views/sprayer_tank/impl#[Sprayer]contents().
farm/views/sprayer_tank/impl#[SprayerTank]set_level().
let beat: Heartbeat
let mut tank: SprayerTank
let message: Farm
NAMES
[ "$missing" = 0 ] && echo "rust-analyzer resolves the generated tree"
