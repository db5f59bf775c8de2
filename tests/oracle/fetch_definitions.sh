#!/bin/sh
# Copy the XML files that the crate `mavlink` 0.21.0 carries (upstream's 20 dialects) into DIR, and its recording log.tlog.
# usage: fetch_definitions.sh DIR
#
# Cargo gets the crate from wherever it is configured to get crates.
set -eu

[ $# -eq 1 ] || { echo "usage: fetch_definitions.sh DIR" >&2; exit 2; }

crate=$(mktemp -d)
trap 'rm -rf "$crate"' EXIT

mkdir "$crate/src"
: > "$crate/src/lib.rs"
cat > "$crate/Cargo.toml" <<'MANIFEST'
[package]
name = "definitions"
version = "0.0.0"
edition = "2024"
publish = false

[dependencies]
mavlink = "=0.21.0"

[workspace]
MANIFEST

cargo vendor --quiet --manifest-path "$crate/Cargo.toml" "$crate/vendor" > "$crate/configuration"
mkdir -p "$1"
cp "$crate"/vendor/mavlink/mavlink/message_definitions/v1.0/*.xml "$1"
cp "$crate"/vendor/mavlink/tests/log.tlog "$1"
