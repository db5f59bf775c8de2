#!/bin/sh
# The program `autoquad`, command by command, and what it writes read by pymavlink.
# usage: check.sh PYTHON
set -eu
cd "$(dirname "$0")/../.."
python=$1
cargo build --quiet -p autoquad
autoquad=$(realpath "${CARGO_TARGET_DIR:-target}/debug/autoquad")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A command that fails, and says this sentence.
refused() {
    sentence=$1
    shift
    if "$@" >"$scratch/said" 2>&1; then echo "accepted: $*" >&2; exit 1; fi
    grep -q "$sentence" "$scratch/said" || { cat "$scratch/said" >&2; exit 1; }
}

flight=$scratch/flight.tlog
"$autoquad" simulate --tlog "$flight" --motors 6 --seed 7 --start 2016-04-30T12:00:00Z
"$autoquad" csv "$flight" --out "$scratch/flight.csv"
"$autoquad" plot "$flight" --out "$scratch/flight.svg"
"$autoquad" plot "$flight" --out "$scratch/flight.png"
"$python" tests/autoquad/compare.py xml/autoquad.xml "$flight" "$scratch/flight.csv"
"$python" tests/autoquad/old_log.py "$flight" "$scratch/old.mavlink"
"$autoquad" salvage "$scratch/old.mavlink" --esc-version 30
"$autoquad" csv "$scratch/old.tlog" --out "$scratch/old.csv"
"$python" tests/autoquad/compare.py xml/autoquad.xml "$scratch/old.tlog" "$scratch/old.csv"

echo "what is wrong is said"
refused 'exists already' "$autoquad" simulate --tlog "$flight"
refused 'No such file' "$autoquad" csv "$scratch/none.tlog"
refused 'autoquad salvage' "$autoquad" csv "$scratch/old.mavlink"
refused 'called .svg or .png' "$autoquad" plot "$flight" --out "$scratch/flight.gif"
refused 'is a folder' "$autoquad" plot "$scratch"
head -c 5000 "$flight" >"$scratch/torn.tlog"
"$autoquad" csv "$scratch/torn.tlog" 2>&1 >/dev/null | grep -q 'bytes belong to no entry'
"$autoquad" csv "$flight" | head -1 | grep -q 'voltage (V)'
