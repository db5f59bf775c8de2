#!/usr/bin/env python3
"""Compare a log of PX4 that `autoquad ulog` wrote, and its CSV by `autoquad px4-log`, with what pyulog reads.

usage: px4_log.py ULG CSV

pyulog also has to write the same bytes again. Exit status: 0 fine, 1 something differs.
"""

import csv
import sys
import tempfile
from pathlib import Path

from pyulog import ULog


def main():
    """The command."""
    log, table = Path(sys.argv[1]), Path(sys.argv[2])
    read = ULog(str(log))
    with tempfile.TemporaryDirectory() as folder:
        again = Path(folder) / "again.ulg"
        read.write_ulog(str(again))
        same(again.read_bytes(), log.read_bytes(), "bytes that pyulog writes again")
    data = read.get_dataset("esc_status").data
    with table.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    expected = []
    for i, timestamp in enumerate(data["timestamp"]):
        for k in range(12):
            report = {name: data[f"esc[{k}].{name}"][i] for name in ("esc_rpm", "timestamp", "actuator_function", "esc_errorcount")}
            if report["actuator_function"]:
                seconds = f"{timestamp // 1_000_000}.{timestamp % 1_000_000:06}"
                motor = report["actuator_function"] - 100
                expected.append((seconds, str(motor), str(report["esc_rpm"]), str(report["esc_errorcount"])))
    found = [(row["time (s)"], row["motor"], row["speed (rpm)"], row["errors"]) for row in rows]
    same(found, expected, "rows")
    print(f"{len(data['timestamp'])} messages, {len(rows)} reports: pyulog reads the same, and writes the same bytes")


def same(found, expected, what):
    """Fails if two things differ."""
    if found != expected:
        sys.exit(f"px4_log: {what} differ")


if __name__ == "__main__":
    main()
