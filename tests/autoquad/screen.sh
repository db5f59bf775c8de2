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
for _ in $(seq 50); do
    screen has-session 2>/dev/null || { echo "three screens are as they were"; exit 0; }
    sleep 0.1
done
echo "q does not quit" >&2
exit 1
