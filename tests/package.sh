#!/bin/sh
# Packs the crates as for a registry, builds each from its archive alone, and documents them as docs.rs does.
set -eu
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml)

# Each is verified against the archives of the others in a registry that cargo makes for it. What came out of that is kept by
# its path, unpacked and compiled, and an earlier run would stand in: so here the path is always another, and nothing is left.
packaging=$scratch/target
registries=${CARGO_HOME:-$HOME/.cargo}/registry
trap 'find "$registries" -mindepth 2 -maxdepth 2 -name "-*" -newer "$scratch/start" -exec rm -rf {} +; rm -rf "$scratch"' EXIT
touch "$scratch/start"

# Builds each from its archive, with its default features.
CARGO_TARGET_DIR=$packaging cargo package --workspace --exclude autoquad --exclude mavlink-examples --exclude mavlink-conformance --exclude own-dialect --exclude px4-topics --exclude random-dialects

unpack() { tar -xzf "$packaging/package/$1-$version.crate" -C "$scratch"; }
holds() { for file; do [ -s "$scratch/$file" ] || { echo "$file is missing from the archive" >&2; exit 1; }; done; }

for crate in mavgen mavgen-cli mavlink-wire mavlink-services mavlink-autoquad; do
    unpack "$crate"
    holds "$crate-$version/README.md" "$crate-$version/LICENSE-MIT" "$crate-$version/LICENSE-APACHE"
done
autoquad=mavlink-autoquad-$version
holds "$autoquad/src/generated/mod.rs" "$autoquad/xml/overlay/autoquad.xml"
for xml in autoquad common standard minimal; do holds "$autoquad/xml/$xml.xml"; done

# The committed sources in the archive, which is what firmware builds.
cargo check --quiet --manifest-path "$scratch/$autoquad/Cargo.toml" --no-default-features \
    --config "patch.crates-io.mavlink-wire.path='$scratch/mavlink-wire-$version'" \
    --config "patch.crates-io.mavgen.path='$scratch/mavgen-$version'"

if cargo +nightly --version >/dev/null 2>&1; then
    export RUSTDOCFLAGS="--cfg docsrs -Dwarnings"
    cargo +nightly doc --quiet --no-deps -p mavgen -p mavlink-wire -p mavlink-services --all-features
    cargo +nightly doc --quiet --no-deps -p mavlink-autoquad --no-default-features --features commands,fast-crc
else
    echo "without a nightly toolchain the documentation is not built as docs.rs does"
fi
