#!/bin/sh
# The protocols against what nobody here wrote: MAVSDK and pymavlink, each as station of our vehicle and as vehicle of our station.
# usage: check.sh [PYTHON], one that has requirements.txt; without it, a virtual environment is made
set -eu
cd "$(dirname "$0")/../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python=${1:-}
if [ -z "$python" ]; then
    python3 -m venv "$scratch/venv"
    "$scratch/venv/bin/pip" install --quiet -r tests/services/requirements.txt
    python=$scratch/venv/bin/python
fi
cargo build --quiet -p mavlink-examples --bin vehicle
vehicle=${CARGO_TARGET_DIR:-target}/debug/vehicle

# Runs a command, and shows what it says; what MAVSDK logs only if it fails.
run() {
    "$@" > "$scratch/said" 2>&1 || { cat "$scratch/said"; exit 1; }
    grep -v '|\(Info \|Debug\|Warn \|Error\)\]' "$scratch/said"
}
run timeout 120 "$python" tests/services/mavsdk_station.py "$vehicle"
run timeout 120 "$python" tests/services/pymavlink_station.py "$vehicle"
export PEERS_PYTHON="$python"
run cargo test --quiet -p mavlink-services --features std --test peers --test old_station -- --ignored
