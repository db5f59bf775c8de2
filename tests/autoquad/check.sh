#!/bin/sh
# The program `autoquad`, command by command; what it writes and sends is read by pymavlink, its screen in tmux.
# usage: check.sh PYTHON
set -eu
cd "$(dirname "$0")/../.."
python=$1
scratch=$(mktemp -d)
# Ends what this script started, and nothing else.
running=
trap 'for process in $running; do kill "$process" 2>/dev/null || true; done; rm -rf "$scratch"' EXIT

# As the README says, but without optimisation: what the tests built already is used.
cargo install --quiet --debug --locked --path examples/autoquad --root "$scratch/installed"
autoquad=$scratch/installed/bin/autoquad

# A command that fails, and says this sentence.
refused() {
    sentence=$1
    shift
    if "$@" >"$scratch/said" 2>&1; then echo "accepted: $*" >&2; exit 1; fi
    grep -q "$sentence" "$scratch/said" || { cat "$scratch/said" >&2; exit 1; }
}

# A port of this machine that nobody has.
port() { "$python" -c 'import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

# A flight over a link: five times as fast, to this port.
fly() { "$autoquad" simulate "udpout:127.0.0.1:$1" --motors 6 --seed 7 --duration 60s --speed 5 2>"$scratch/flight" & running="$running $!"; }

# Waits until a command succeeds.
until_true() {
    for _ in $(seq 300); do
        if "$@" 2>/dev/null; then return; fi
        sleep 0.1
    done
    echo "never true: $*" >&2
    exit 1
}

is_larger() { [ "$(wc -c <"$1")" -gt "$2" ]; }

echo "recordings"
flight=$scratch/flight.tlog
"$autoquad" simulate --tlog "$flight" --motors 6 --seed 7 --duration 60s --rate 200 --start 2016-04-30T12:00:00Z
"$autoquad" csv "$flight" --out "$scratch/flight.csv"
"$python" tests/autoquad/compare.py xml/autoquad.xml "$flight" "$scratch/flight.csv"
"$autoquad" ulog "$flight"
"$autoquad" px4-log "$scratch/flight.ulg" | grep -q FAILURE_MOTOR_STUCK
"$autoquad" px4-log "$scratch/flight.ulg" --out "$scratch/px4.csv"
"$python" tests/autoquad/px4_log.py "$scratch/flight.ulg" "$scratch/px4.csv"
"$autoquad" plot "$flight" --out "$scratch/flight.svg"
"$autoquad" plot "$flight" --out "$scratch/flight.png"
"$autoquad" monitor "$flight" --plain >"$scratch/lines"
grep -q 'WARNING: disarmed' "$scratch/lines"
grep -q 'WARNING: silent' "$scratch/lines"
"$python" tests/autoquad/old_log.py "$flight" "$scratch/old.mavlink"
"$autoquad" salvage "$scratch/old.mavlink" --esc-version 30
"$autoquad" csv "$scratch/old.tlog" --out "$scratch/old.csv"
"$python" tests/autoquad/compare.py xml/autoquad.xml "$scratch/old.tlog" "$scratch/old.csv"

echo "links"
air=$(port)
"$autoquad" record "udpin:127.0.0.1:$air" "$scratch/recorded.tlog" 2>"$scratch/said" &
record=$!
running="$running $record"
fly "$air"
until_true is_larger "$scratch/recorded.tlog" 20000
kill -INT "$record"
wait "$record"
frames=$(sed -n 's/.*: \([0-9]*\) frames recorded/\1/p' "$scratch/said")
"$autoquad" csv "$scratch/recorded.tlog" --out "$scratch/recorded.csv"
"$python" tests/autoquad/compare.py xml/autoquad.xml "$scratch/recorded.tlog" "$scratch/recorded.csv" "$frames"
air=$(port)
fly "$air"
"$autoquad" monitor "udpin:127.0.0.1:$air" --plain --for 20s | grep -q 'esc 6: RUNNING'

echo 'the passphrase' >"$scratch/passphrase"
for sign in '' "$scratch/passphrase"; do
    air=$(port) ground=$(port)
    "$python" tests/autoquad/ground.py "$ground" xml/autoquad.xml "$flight" $sign >"$scratch/ground" 2>&1 &
    station=$!
    running="$running $station"
    until_true grep -q listening "$scratch/ground"
    "$autoquad" bridge "udpin:127.0.0.1:$air" "udpout:127.0.0.1:$ground" ${sign:+--sign "$sign"} --for 30s 2>"$scratch/said" &
    bridge=$!
    running="$running $bridge"
    fly "$air"
    wait "$station" || { cat "$scratch/ground" >&2; exit 1; }
    kill -INT "$bridge"
    wait "$bridge"
    tail -1 "$scratch/ground"
    cat "$scratch/said"
done

echo "the screen"
sh tests/autoquad/screen.sh "$autoquad" "$scratch"

echo "the pictures of the documentation"
sh tests/autoquad/pictures.sh "$autoquad" "$python" --check

echo "what is wrong is said"
refused 'exists already' "$autoquad" simulate --tlog "$flight"
refused 'exists already' "$autoquad" record udpin:127.0.0.1:0 "$flight"
refused 'No such file' "$autoquad" csv "$scratch/none.tlog"
refused 'autoquad salvage' "$autoquad" csv "$scratch/old.mavlink"
refused 'called .svg or .png' "$autoquad" plot "$flight" --out "$scratch/flight.gif"
refused 'not a ULog file' "$autoquad" px4-log "$flight"
refused 'is a folder' "$autoquad" plot "$scratch"
refused 'is what is read' "$autoquad" csv "$flight" --out "$flight" --force
refused 'is no terminal' "$autoquad" monitor "$flight"
refused 'udpin' "$autoquad" monitor udp:0.0.0.0:14550 --plain
refused 'no device' "$autoquad" monitor serial:/dev/none:57600 --plain
refused 'nobody answers' "$autoquad" bridge tcpout:127.0.0.1:1 udpout:127.0.0.1:1
refused 'No such file' "$autoquad" bridge udpin:127.0.0.1:0 udpout:127.0.0.1:1 --sign "$scratch/none"
"$autoquad" monitor udpin:127.0.0.1:0 --plain --for 6s 2>&1 | grep -q 'no data for 5 s; waiting'
head -c 5000 "$flight" >"$scratch/torn.tlog"
"$autoquad" csv "$scratch/torn.tlog" 2>&1 >/dev/null | grep -q 'bytes belong to no entry'
"$autoquad" csv "$flight" | head -1 | grep -q 'voltage (V)'
