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

generate xml/autoquad.xml --overlay xml/overlay/autoquad.xml --commands feature=commands --out mavlink-autoquad/src/generated
generate xml/common.xml --messages "$(cat mavlink-services/messages.txt)" --commands never --out mavlink-services/src/generated
px4=mavlink-autoquad/msg
generate $px4/main --overlay $px4/esc.overlay.xml --older v2026_02=$px4/v2026_02 --older v1_14=$px4/v1_14 --name px4_msgs --out mavlink-autoquad/src/generated_px4
for folder in mavgen/tests/golden/*/msg; do
    folder=$(dirname "$folder")
    options=(--definition main)
    for file in "$folder"/*.overlay.xml; do [ -e "$file" ] && options+=(--overlay "$file"); done
    for older in $(ls -r "$folder/older" 2>/dev/null || true); do options+=(--older "$older=$folder/older/$older"); done
    generate "$folder/msg" "${options[@]}" --out "$folder/generated"
done
for main in mavgen/tests/golden/*/main.xml; do
    folder=$(dirname "$main")
    overlays=() roots=() commands=always
    for file in "$folder"/*.overlay.xml; do [ -e "$file" ] && overlays+=(--overlay "$file"); done
    for file in "$folder"/*.root.xml; do [ -e "$file" ] && roots+=("$file"); done
    [ -e "$folder/commands.feature" ] && commands=feature=$(cat "$folder/commands.feature")
    generate "$main" "${roots[@]}" "${overlays[@]}" --commands "$commands" --out "$folder/generated"
done
