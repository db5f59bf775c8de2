#!/bin/sh
# Drives `autoquad monitor` in a terminal of tmux, and compares its screens with tests/autoquad/screens.
# usage: screen.sh AUTOQUAD SCRATCH [--bless]
set -eu
cd "$(dirname "$0")"
autoquad=$1 scratch=$2 bless=${3:-}
. ./tmux.sh

# Compares the screen with what it was.
same() {
    screen capture-pane -p | sed 's/ *$//' >"$scratch/screen"
    if [ -n "$bless" ]; then cp "$scratch/screen" "screens/$1"; fi
    diff "screens/$1" "$scratch/screen"
}

"$autoquad" simulate --tlog "$scratch/screen.tlog" --motors 8 --seed 3 --start 2016-04-30T12:00:00Z 2>/dev/null
ln -sf "$scratch/screen.tlog" "$scratch/flight.tlog"
start 100 24 NO_COLOR=1
go 00:10 00:20 00:30 00:40 00:50
same running
go 01:00 01:10 01:20 01:30
screen send-keys t
shows 'current (A)'
same failed
screen resize-window -x 20 -y 12
shows '  1 R'
same narrow
screen resize-window -x 10 -y 3
shows 'too small'
screen resize-window -x 100 -y 24
shows 'current (A)'
screen send-keys End
shows 'end 1x'
screen send-keys q
ended

# The same live: a vehicle comes, and goes.
port=$(python3 -c 'import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
monitor 80 24 NO_COLOR=1 "udpin:127.0.0.1:$port"
shows 'no data yet'
"$autoquad" simulate "udpout:127.0.0.1:$port" --motors 3 --duration 10s --speed 5 2>/dev/null
shows '/3 on'
shows 'no data for'
screen send-keys C-c
ended

# A terminal that goes away takes the monitor along.
monitor 80 24 NO_COLOR=1 "udpin:127.0.0.1:$port"
shows 'no data yet'
process=$(screen list-panes -F '#{pane_pid}')
screen kill-server
for _ in $(seq 50); do
    kill -0 "$process" 2>/dev/null || break
    sleep 0.1
done
if kill -0 "$process" 2>/dev/null; then echo "the monitor goes on without its terminal" >&2; kill -9 "$process"; exit 1; fi
echo "three screens are as they were, and a vehicle comes and goes"
