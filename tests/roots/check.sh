#!/bin/sh
# Generates ArduPilot's dialect and AutoQuad's into one crate and compiles it, every warning denied: the ids 150 and 152 are
# other messages in each, and what both include is one type.
# usage: check.sh MAVGEN DEFINITIONS, the folder with upstream's ardupilotmega.xml and what it includes
set -eu

[ $# -eq 2 ] || { echo "usage: check.sh MAVGEN DEFINITIONS" >&2; exit 2; }

cd "$(dirname "$0")/../.."
crate=$(mktemp -d)
trap 'rm -rf "$crate"' EXIT

mkdir "$crate/xml" "$crate/src"
cp -r "$2"/*.xml xml/autoquad.xml xml/overlay "$crate/xml"
"$1" generate "$crate/xml/ardupilotmega.xml" "$crate/xml/autoquad.xml" --overlay "$crate/xml/overlay/autoquad.xml" \
    --out "$crate/src/dialects" --deny-warnings

cat > "$crate/Cargo.toml" <<MANIFEST
[package]
name = "two-dialects"
version = "0.0.0"
edition = "2024"
publish = false

[dependencies]
mavlink-wire = { path = "$PWD/mavlink-wire" }

[workspace]
MANIFEST
cat > "$crate/src/lib.rs" <<'LIB'
//! Two dialects in one crate.
#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, unreachable_pub, clippy::all, rustdoc::all)]

/// Both.
#[rustfmt::skip]
pub mod dialects;

use dialects::{ardupilotmega as apm, autoquad as aq};
use mavlink_wire::Message;

#[expect(deprecated, reason = "SENSOR_OFFSETS is, and 150 stays its id")]
const _: () = {
    assert!(apm::SensorOffsets::ID == 150 && aq::AqTelemetryF::ID == 150);
    assert!(apm::Meminfo::ID == 152 && aq::AqEscTelemetry::ID == 152);
    assert!(apm::MavCmd::AQ_TELEMETRY.0 == 2 && aq::MavCmd::DO_SET_MODE.0 == 176);
};

/// What one dialect receives, the other sends.
pub fn forward(message: apm::Heartbeat) -> aq::Autoquad {
    message.into()
}
LIB
cargo clippy --quiet --manifest-path "$crate/Cargo.toml" --target-dir "$crate/target"
cargo doc --quiet --no-deps --manifest-path "$crate/Cargo.toml" --target-dir "$crate/target"
echo "ardupilotmega and autoquad in one crate: $(find "$crate/src/dialects" -name '*.rs' | wc -l) files, no warning"
