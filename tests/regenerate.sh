#!/usr/bin/env bash
# Writes anew what is committed and comes from mavgen: the dialect of mavlink-autoquad, the messages of mavlink-services and the goldens. Review it like code.
# usage: regenerate.sh [MAVGEN]; without one it is built.
set -euo pipefail

cd "$(dirname "$0")/.."
mavgen=${1:-}
if [ -z "$mavgen" ]; then
    cargo build --quiet --package mavgen-cli
    mavgen=${CARGO_TARGET_DIR:-target}/debug/mavgen
fi

# Says what went wrong, and nothing of warnings: the inputs are as they have to be.
generate() {
    local said
    said=$("$mavgen" generate "$@" 2>&1) || { printf '%s\n' "$said" >&2; exit 1; }
    grep -v ' 0 files written, .* 0 removed' <<<"${said##*$'\n'}" || true
}

generate xml/autoquad.xml --overlay xml/overlay/autoquad.xml --out mavlink-autoquad/src/generated
generate xml/common.xml --messages "$(cat mavlink-services/messages.txt)" --out mavlink-services/src/generated
for main in mavgen/tests/golden/*/main.xml; do
    folder=$(dirname "$main")
    overlays=() roots=()
    for file in "$folder"/*.overlay.xml; do [ -e "$file" ] && overlays+=(--overlay "$file"); done
    for file in "$folder"/*.root.xml; do [ -e "$file" ] && roots+=("$file"); done
    generate "$main" "${roots[@]}" "${overlays[@]}" --out "$folder/generated"
done
