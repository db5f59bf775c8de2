#!/bin/sh
# Makes the pictures in docs/pictures: a screen of `autoquad monitor`, and a plot. With --check, they have to be as they are.
# usage: pictures.sh AUTOQUAD PYTHON [--check]
set -eu
autoquad=$(realpath "$1") python=$2 check=${3:-}
cd "$(dirname "$0")"
pictures=$PWD/../../docs/pictures
scratch=$(mktemp -d)
. ./tmux.sh
trap 'screen kill-server 2>/dev/null || true; rm -rf "$scratch"' EXIT

"$autoquad" simulate --tlog "$scratch/flight.tlog" --motors 6 --seed 4 --start 2016-04-30T12:00:00Z 2>/dev/null
"$autoquad" plot "$scratch/flight.tlog" --out "$scratch/plot.png" --size 1000x800 2>/dev/null
start 120 18 TERM=screen-256color
go 00:10 00:20 00:30 00:40 00:50 01:00 01:10 01:20 01:30
screen send-keys t
shows 'current (A)'
screen capture-pane -e -p | "$python" ./screen_to_svg.py 120 >"$scratch/monitor.svg"

for picture in monitor.svg plot.png; do
    if [ -z "$check" ]; then cp "$scratch/$picture" "$pictures"; fi
    cmp "$scratch/$picture" "$pictures/$picture"
done
