"""Compares the table of `autoquad csv` with what pymavlink and a packed C structure read in the same tlog.

usage: compare.py XML TLOG TABLE [FRAMES]; with FRAMES, the tlog has so many.
"""

import csv
import ctypes
import datetime
import sys
from pathlib import Path

from recording import load, messages


class Status(ctypes.LittleEndianStructure):
    """AutoQuad's esc32CanStatus_t; `last` are errors or a temperature."""

    _pack_ = 1
    _fields_ = [
        ("state", ctypes.c_uint64, 3),
        ("vin", ctypes.c_uint64, 12),
        ("amps", ctypes.c_uint64, 14),
        ("rpm", ctypes.c_uint64, 15),
        ("duty", ctypes.c_uint64, 8),
        ("last", ctypes.c_uint64, 9),
        ("code", ctypes.c_uint64, 3),
    ]


STATES = ["DISARMED", "STOPPED", "NOCOMM", "STARTING", "RUNNING"]


def expected(module, log):
    """The rows that the table has to have: floats as floats, the others as text."""
    for time, message in messages(module, log):
        if message.get_type() != "AQ_ESC_TELEMETRY":
            continue
        for slot in range(message.num_in_seq):
            bits = message.data0[slot] | message.data1[slot] << 32
            age = message.status_age[slot]
            silent = age == 0xFFFF or bits == 0
            status = Status.from_buffer_copy(bits.to_bytes(8, "little"))
            measures = message.data_version[slot] >= 30
            yield {
                "unix_time (s)": f"{time // 1_000_000}.{time % 1_000_000:06}",
                "uptime (s)": message.time_boot_ms / 1000,
                "system_id": str(message.get_srcSystem()),
                "esc": str(message.escid[slot]),
                "state": "SILENT" if silent else STATES[status.state],
                "voltage (V)": "" if silent else status.vin / 100,
                "current (A)": "" if silent else status.amps / 100,
                "speed (rpm)": "" if silent else str(status.rpm),
                "temperature (degC)": "" if silent or not measures else status.last / 4 - 32,
                "errors": "" if silent or measures else str(status.last),
                "age (ms)": "" if age == 0xFFFF else str(age),
            }


def differs(row, name, value):
    """Whether a cell is not what it should be."""
    return not abs(float(row[name] or "nan") - value) <= 1e-6 if isinstance(value, float) else row[name] != value


def main():
    xml, log, table, *frames = sys.argv[1:]
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    module, recorded = load(xml), Path(log).read_bytes()
    count = sum(1 for _ in messages(module, recorded))
    if frames and count != int(frames[0]):
        sys.exit(f"{log}: {count} frames, not {frames[0]}")
    wanted = list(expected(module, recorded))
    if len(rows) != len(wanted) or not rows:
        sys.exit(f"{table}: {len(rows)} rows, not {len(wanted)}")
    for number, (row, values) in enumerate(zip(rows, wanted), 2):
        wrong = [name for name, value in values.items() if differs(row, name, value)]
        iso = datetime.datetime.fromisoformat(row["time"]).timestamp()
        if wrong or abs(iso - float(row["unix_time (s)"])) > 1e-5:
            sys.exit(f"{table}:{number}: {wrong}: {row}, not {values}")
    print(f"{len(rows)} rows of {Path(table).name} are what pymavlink reads in {count} frames")


if __name__ == "__main__":
    main()
