#!/bin/sh
# Fuzzes: run.sh [SECONDS] [TARGET]... , all targets for a minute each if not told otherwise. Needs cargo-fuzz and a nightly compiler.
# FEATURES=--no-default-features fuzzes what firmware builds: another way through the parser.
# The corpus grows below the target directory; what breaks something is shown, and kept in artifacts/ there.
set -eu
cd "$(dirname "$0")"
seconds=${1:-60}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- dialect overlay msg ulog cdr parser decode signing command_station command_component heartbeat vehicle param_list param_access param_component mission_station mission_component
work=${CARGO_TARGET_DIR:-target}/fuzz
for target in "$@"; do
    corpus=$work/corpus/$target
    mkdir -p "$corpus" "$work/artifacts/$target"
    case $target in
        dialect)
            find ../../mavgen/tests ../hostile -name '*.xml' ! -name '*.overlay.xml' -size -16k | while read -r seed; do
                cp "$seed" "$corpus/$(echo "$seed" | tr / _)"
            done
            set -- -dict=mavlink.dict -max_len=16384 ;;
        overlay)
            find ../../mavgen/tests ../packed ../../xml -name '*.overlay.xml' -o -path '*/overlay/*.xml' | while read -r seed; do
                cp "$seed" "$corpus/$(echo "$seed" | tr / _)"
            done
            set -- -dict=mavlink.dict -max_len=16384 ;;
        msg)
            find ../../mavgen/tests/ui ../../mavlink-autoquad/msg -name '*.msg' | while read -r seed; do
                cat "$seed" "$(dirname "$seed")"/*.overlay.xml >"$corpus/$(echo "$seed" | tr / _)" 2>/dev/null || true
            done
            set -- -dict=mavlink.dict -max_len=8192 ;;
        ulog)
            cp ../vectors/px4/*.ulg "$corpus"
            set -- -max_len=4096 ;;
        cdr)
            # Payloads of each definition, which rosbags made.
            perl -ne 'if (/^value \S+ (\S+)/) { open my $f, ">", "'"$corpus"'/value-$."; print $f pack "H*", $1 }' ../vectors/px4/esc_status.txt
            set -- -max_len=512 ;;
        parser | decode)
            # One input a line: frames that pymavlink made, the last line several with damage between them.
            perl -ne 'chomp; open my $f, ">", "'"$corpus"'/frames-$."; print $f pack "H*", $_' seeds/frames.hex
            set -- -max_len=2048 ;;
        *)
            set -- -max_len=2048 ;;
    esac
    cargo +nightly fuzz run --fuzz-dir . ${FEATURES:-} "$target" "$corpus" -- \
        -artifact_prefix="$work/artifacts/$target/" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -print_final_stats=1 "$@"
done
