# A terminal for `autoquad monitor`, to be sourced: $scratch is a folder of its own.

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

# Starts the monitor in a terminal of this width and height, with or without colours.
monitor() {
    screen new-session -d -x "$1" -y "$2" "cd '$scratch' && env -u NO_COLOR $3 LC_ALL=C.UTF-8 '$autoquad' monitor $4"
}

# Waits until the monitor has ended, which it should have done by itself.
ended() {
    for _ in $(seq 50); do
        screen has-session 2>/dev/null || return 0
        sleep 0.1
    done
    echo "the monitor does not end" >&2
    exit 1
}

# The same of a recording, which is stopped at its begin.
start() {
    monitor "$1" "$2" "$3" flight.tlog
    shows 'play 1x'
    screen send-keys Space
    shows 'paused'
    screen send-keys Home
    shows '00:00'
}

# Goes on by ten seconds for each time that is named.
go() {
    for time; do
        screen send-keys Right
        shows "$time"
    done
}
