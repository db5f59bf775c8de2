#!/bin/sh
# Drives `autoquad monitor` in a terminal of tmux, and compares its screens with tests/autoquad/screens.
# usage: screen.sh AUTOQUAD SCRATCH [--bless]
set -eu
cd "$(dirname "$0")"
autoquad=$1 scratch=$2 bless=${3:-}
command -v tmux >/dev/null || apt-get install -yqq --no-install-recommends tmux >/dev/null

# A server of its own, so that nobody's sessions are touched.
screen() { tmux -S "$scratch/tmux" -f /dev/null "$@"; }
trap 'screen kill-server 2>/dev/null || true' EXIT

# Waits until the screen has this text.
shows() {
    for _ in $(seq 100); do
        if screen capture-pane -p | grep -q -- "$1"; then return; fi
        sleep 0.1
    done
    echo "the screen never shows: $1" >&2
    screen capture-pane -p >&2
    exit 1
}

# Compares the screen with what it was.
same() {
    screen capture-pane -p | sed 's/ *$//' >"$scratch/screen"
    if [ -n "$bless" ]; then cp "$scratch/screen" "screens/$1"; fi
    diff "screens/$1" "$scratch/screen"
}

"$autoquad" simulate --tlog "$scratch/screen.tlog" --motors 8 --seed 3 --start 2016-04-30T12:00:00Z 2>/dev/null
ln -sf "$scratch/screen.tlog" "$scratch/flight.tlog"
screen new-session -d -x 100 -y 24 "cd '$scratch' && NO_COLOR=1 LC_ALL=C.UTF-8 exec '$autoquad' monitor flight.tlog"
shows 'play 1x'
screen send-keys Space
shows 'paused'
screen send-keys Home
shows '00:00'
for second in 10 20 30 40 50; do
    screen send-keys Right
    shows "00:$second"
done
same running
for second in 1:00 1:10 1:20 1:30; do
    screen send-keys Right
    shows "0$second"
done
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
