#!/usr/bin/env python3
"""Write what PX4's messages must be as bytes: payloads of CDR, records, and logs.

usage: make_px4.py MSG OUT [--check]
       make_px4.py --all FOLDER OUT

MSG has folders `main`, `v2026_02` and `v1_14` with EscStatus.msg and EscReport.msg.
rosbags makes the CDR and the type hashes; pyulog reads each log and has to write the
same bytes again. OUT is a folder: `esc_status.txt`, `NAME.ulg` for each definition, and
`infos.ulg`, which says something about itself.

`--all` writes one file OUT instead, with three random values of each message of a FOLDER.
`--check` writes nothing; it makes everything again and says which files of OUT differ.
Exit status: 0 fine, 1 OUT differs, 2 something is not as it has to be.

The files of text are lines of ASCII. A line that begins with `#`, or is empty, says nothing.

    message NAME DEFINITION TYPE_HASH CDR_LEN STRUCT_LEN RECORD_LEN
        What the lines below are of. Lengths are in bytes, that of CDR without header.
    format TEXT
        A format of a log, for the message first, then for each that it nests.
    value NAME CDR RECORD
        One value, as CDR with its header and as the record of a log, both in hexadecimal.
"""

import argparse
import hashlib
import math
import struct
import sys
import tempfile
import warnings
from pathlib import Path

import pyulog
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from uorb import SCALARS, Folder, topic_of

warnings.simplefilter("ignore")

DEFINITIONS = ["main", "v2026_02", "v1_14"]
RANDOM = 20
START = 123_456
NAN = float("nan")


class Different(Exception):
    """Two programs do not agree."""


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Write what PX4's messages must be as bytes.")
    parser.add_argument("--all", action="store_true", help="random values of all messages of a folder")
    parser.add_argument("--check", action="store_true", help="compare OUT, do not write it")
    parser.add_argument("msg", type=Path, metavar="MSG", help="the folder of definitions, or of messages")
    parser.add_argument("out", type=Path, metavar="OUT", help="the folder, or with --all the file")
    arguments = parser.parse_args()
    try:
        if arguments.all:
            made = {arguments.out: text(of_all(arguments.msg))}
        else:
            made = {arguments.out / name: content for name, content in of_esc_status(arguments.msg)}
    except Different as error:
        print(f"make_px4: {error}", file=sys.stderr)
        return 2
    if arguments.check:
        wrong = [str(path) for path, content in made.items() if not path.exists() or path.read_bytes() != content]
        print(f"make_px4: differs: {', '.join(wrong)}" if wrong else f"{len(made)} files are what is made")
        return 1 if wrong else 0
    for path, content in made.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    print(f"{len(made)} files written")
    return 0


def text(lines):
    """A file of lines, under what every file says."""
    head = ["# By tests/oracle/make_px4.py, rosbags 0.11.9 and pyulog 1.3.0. Do not edit."]
    return "".join(f"{line}\n" for line in [*head, *lines]).encode("ascii")


class Messages:
    """The messages of a folder: values to bytes."""

    def __init__(self, path):
        self.folder = Folder(path)
        self._store = get_typestore(Stores.EMPTY)
        self._known = set()

    def need(self, message):
        """Makes rosbags know a message."""
        if message in self._known:
            return
        types = {}
        for name in self.folder.needs(message):
            if name not in self._known:
                definition = (self.folder.path / f"{name}.msg").read_text(encoding="utf-8")
                types.update(get_types_from_msg(definition, f"px4_msgs/msg/{name}"))
                self._known.add(name)
        self._store.register(types)

    def cdr(self, message, value):
        """A payload, by rosbags."""
        return bytes(self._store.serialize_cdr(self._typed(message, value), f"px4_msgs/msg/{message}"))

    def _typed(self, message, value):
        import numpy

        arguments = {}
        for field in self.folder.fields(message):
            content = value[field.name]
            if field.type not in SCALARS:
                each = [self._typed(field.type, one) for one in (content if field.count is not None else [content])]
                content = each if field.count is not None else each[0]
            elif field.count is not None:
                kind = {"char": "uint8", "bool": "bool"}.get(field.type, field.type)
                content = numpy.array(content, dtype=kind)
            arguments[field.name] = content
        return self._store.types[f"px4_msgs/msg/{message}"](**arguments)

    def lines(self, message, definition, values):
        """The lines of a message with these values: (name, value)."""
        self.need(message)
        _, length = self.folder.struct(message)
        record = self.folder.record_length(message)
        payloads = [(name, self.cdr(message, value), self.folder.image(message, value)) for name, value in values]
        type_hash = self._store.hash_rihs01(f"px4_msgs/msg/{message}")
        yield ""
        yield f"message {message} {definition} {type_hash} {len(payloads[0][1]) - 4} {length} {record}"
        for name in reversed(self.folder.needs(message)):
            yield f"format {self.folder.format(name, whole=name != message)}"
        for name, payload, image in payloads:
            yield f"value {name} {payload.hex()} {image[:record].hex()}"


class Random:
    """Numbers that are the same on every run: hashes of what they are for."""

    def __init__(self, seed):
        self._seed, self._count = seed, 0

    def bits(self, count):
        """So many bits."""
        self._count += 1
        digest = hashlib.sha256(f"{self._seed}/{self._count}".encode()).digest()
        return int.from_bytes(digest[:8], "little") & ((1 << count) - 1)

    def scalar(self, kind):
        """Any value of a scalar; of NaN there is one, since numpy keeps no other."""
        code = SCALARS[kind][0]
        if kind == "bool":
            return self.bits(1)
        size = struct.calcsize(code)
        value = struct.unpack(f"<{code}", self.bits(8 * size).to_bytes(size, "little"))[0]
        return NAN if isinstance(value, float) and math.isnan(value) else value

    def value(self, folder, message):
        """Any value of a message."""

        def one(field):
            return self.scalar(field.type) if field.type in SCALARS else self.value(folder, field.type)

        fields = folder.fields(message)
        return {
            field.name: one(field) if field.count is None else [one(field) for _ in range(field.count)]
            for field in fields
        }


def of_all(path):
    """Lines for all messages of a folder."""
    messages = Messages(path)
    for file in sorted(path.glob("*.msg")):
        message = file.stem
        values = [
            (f"random_{i}", Random(f"{message}/{i}").value(messages.folder, message)) for i in range(1, 4)
        ]
        yield from messages.lines(message, "newest", values)


# What four controllers of an AutoQuad say, of which the last has not been heard; and a value with every field distinct.
AUTOQUAD = {
    "timestamp": 123_456_000,
    "counter": 7,
    "esc_count": 4,
    "esc_connectiontype": 4,
    "esc_online_flags": 0b0111,
    "esc_armed_flags": 0b0011,
}
REPORT = {
    "timestamp": 0,
    "esc_errorcount": 0,
    "esc_rpm": 0,
    "esc_voltage": 0.0,
    "esc_current": 0.0,
    "esc_temperature": 0.0,
    "motor_temperature": 0,
    "esc_address": 0,
    "esc_cmdcount": 0,
    "esc_state": 0,
    "actuator_function": 0,
    "failures": 0,
    "esc_power": 0,
}
REPORTS = [
    {
        "timestamp": 123_452_000,
        "esc_errorcount": 17,
        "esc_rpm": 6543,
        "esc_voltage": 15.12,
        "esc_current": 8.73,
        "esc_temperature": NAN,
        "esc_address": 1,
        "esc_state": 4,
        "actuator_function": 101,
        "esc_power": 50,
    },
    {
        "timestamp": 123_447_000,
        "esc_rpm": 6601,
        "esc_voltage": 15.10,
        "esc_current": 9.01,
        "esc_temperature": 25.0,
        "esc_address": 4,
        "esc_state": 4,
        "actuator_function": 102,
        "esc_power": 51,
    },
    {
        "timestamp": 123_449_000,
        "esc_voltage": 15.09,
        "esc_temperature": 31.25,
        "esc_address": 2,
        "actuator_function": 103,
        "failures": 0x20,
    },
    {"esc_voltage": NAN, "esc_current": NAN, "esc_temperature": NAN, "esc_address": 3, "actuator_function": 104},
]
EDGE = {
    "timestamp": 0x0102_0304_0506_0708,
    "counter": 0xBEEF,
    "esc_count": 255,
    "esc_connectiontype": 0x7E,
    "esc_online_flags": 0xA5,
    "esc_armed_flags": 0x5A,
}


def edge(k):
    """Report k of the value in which every field is distinct."""
    return {
        "timestamp": (1 << 64) - 1 - k,
        "esc_errorcount": 0xFFFF_FF00 + k,
        "esc_rpm": k - (1 << 31),
        "esc_voltage": 11.5 + k,
        "esc_current": -0.25 * k,
        "esc_temperature": k - 40.5,
        "motor_temperature": k - 32768,
        "esc_address": 200 + k,
        "esc_cmdcount": 100 + k,
        "esc_state": 0x80 + k,
        "actuator_function": 101 + k,
        "failures": 0x0200 + k,
        "esc_power": k - 100,
    }


def of_esc_status(path):
    """Names and contents of the files about EscStatus."""
    lines = []
    for definition in DEFINITIONS:
        messages = Messages(path / definition)
        count = next(field.count for field in messages.folder.fields("EscStatus") if field.name == "esc")
        known = [{**REPORT, **report} for report in REPORTS]
        values = [
            ("autoquad", {**AUTOQUAD, "esc": known + [REPORT] * (count - len(known))}),
            ("edge", {**EDGE, "esc": [edge(k) for k in range(count)]}),
        ]
        for i in range(1, RANDOM + 1):
            value = Random(f"{definition}/{i}").value(messages.folder, "EscStatus")
            values.append((f"random_{i}", value))
        lines += messages.lines("EscStatus", definition, values)
        images = [messages.folder.image("EscStatus", value) for _, value in values[:2]]
        yield f"{definition}.ulg", log(messages.folder, images, [])
        if definition == "main":
            yield "infos.ulg", log(messages.folder, images, [("sys_name", "AutoQuad"), ("ver_hw", "M4")])
    yield "esc_status.txt", text(lines)


def record(kind, payload):
    """A record of a log."""
    return struct.pack("<HB", len(payload), ord(kind)) + payload


def log(folder, images, infos):
    """A log of EscStatus, which pyulog reads, and writes again as the same bytes."""
    made = b"ULog\x01\x12\x35\x01" + struct.pack("<Q", START) + record("B", bytes(40))
    for name in ("EscStatus", "EscReport"):
        made += record("F", folder.format(name, whole=name != "EscStatus").encode())
    for key, value in infos:
        key = f"char[{len(value)}] {key}".encode()
        made += record("I", bytes([len(key)]) + key + value.encode())
    made += record("A", struct.pack("<BH", 0, 0) + topic_of("EscStatus").encode())
    made += b"".join(record("D", struct.pack("<H", 0) + image) for image in images)
    with tempfile.TemporaryDirectory() as scratch:
        first, again = Path(scratch) / "first.ulg", Path(scratch) / "again.ulg"
        first.write_bytes(made)
        read = pyulog.ULog(str(first))
        read.write_ulog(str(again))
        if again.read_bytes() != made:
            raise Different("pyulog writes other bytes than those that it read")
        speeds = read.get_dataset("esc_status").data["esc[1].esc_rpm"].tolist()
        if speeds != [6601, 1 - (1 << 31)] or read.msg_info_dict != dict(infos):
            raise Different(f"pyulog reads {speeds} and {read.msg_info_dict}")
    return made


if __name__ == "__main__":
    sys.exit(main())
