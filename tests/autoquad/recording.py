"""Recordings read with the code that pymavlink generates from our definition."""

import struct
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "oracle"))

from dialect import load_module  # noqa: E402

TIME = struct.Struct(">Q")


def load(xml):
    """pymavlink's module for a definition."""
    with tempfile.TemporaryDirectory() as folder:
        return load_module(xml, "2.0", folder)


def messages(module, log):
    """Times in µs and messages of a tlog; it has nothing but whole entries, all with the right checksum."""
    connection = module.MAVLink(None)
    place = 0
    while place < len(log):
        (time,) = TIME.unpack_from(log, place)
        place += TIME.size
        header, payload = (12, log[place + 1]) if log[place] == 0xFD else (8, log[place + 1])
        signature = 13 if header == 12 and log[place + 2] & 1 else 0
        end = place + header + payload + signature
        yield time, connection.decode(bytearray(log[place:end]))
        place = end
