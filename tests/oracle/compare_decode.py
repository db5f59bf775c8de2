#!/usr/bin/env python3
"""Compare what mavgen and pymavlink read in a telemetry log.

usage: compare_decode.py --mavgen COMMAND --log FILE.tlog [--expect N] XML...

For each definition, `COMMAND decode XML FILE --format json` must print what pymavlink's
code for the same definition decodes: every frame that it accepts, with time, sender,
sequence, name and every value, names of enums and flags taken back to numbers, floats
compared in their own width. A value is null if and only if the `invalid` attribute of
the XML, read here, says so. Exit status: 0 all equal, 1 something differs or fewer than
N messages of the first definition were there, 2 the usage is wrong.
"""

import argparse
import json
import math
import os
import shlex
import struct
import subprocess
import sys
from datetime import datetime, timedelta, timezone
from pathlib import Path
from xml.etree import ElementTree

from decoder import Decoder

LISTED = 20
"""Differences that are printed; more of them tell nothing new."""

TIME = struct.Struct(">Q")

LIMITS = {f"{kind}{bits}_MAX": (1 << bits - (kind == "INT")) - 1 for kind in ("INT", "UINT") for bits in (8, 16, 32, 64)}
LIMITS |= {f"INT{bits}_MIN": -(1 << bits - 1) for bits in (8, 16, 32, 64)}
LIMITS |= {f"UINT{bits}_MIN": 0 for bits in (8, 16, 32, 64)}


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Compare what mavgen and pymavlink read in a telemetry log.")
    parser.add_argument("--mavgen", required=True, type=shlex.split, metavar="COMMAND")
    parser.add_argument("--log", required=True, type=Path, metavar="FILE.tlog")
    parser.add_argument("--expect", type=int, default=1, metavar="N", help="at least so many messages (default: 1)")
    parser.add_argument("xml", nargs="+", type=Path, metavar="XML")
    arguments = parser.parse_args()
    counts, differing = [], 0
    for xml in arguments.xml:
        count, found = _compare(xml, arguments)
        print(f"{xml.stem}: {count} messages, {len(found)} differences")
        for line in found[:LISTED]:
            print(f"    {line}")
        counts.append(count)
        differing += bool(found)
    return 1 if differing or counts[0] < arguments.expect else 0


def _compare(xml, arguments):
    """How many messages pymavlink decodes, and every difference, one line of text each."""
    decoder, sentinels = Decoder(xml), _sentinels(xml)
    expected = [read for read in map(decoder.decode, *zip(*_frames(arguments.log.read_bytes()))) if read]
    command = [*arguments.mavgen, "decode", "--format", "json", xml, arguments.log]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode:
        return len(expected), [f"mavgen ended with {ended.returncode}: {ended.stderr}"]
    lines = (json.loads(line) for line in ended.stdout.splitlines())
    actual = [line for line in lines if line["verified"]]
    found = [] if len(actual) == len(expected) else [f"{len(actual)} messages instead of {len(expected)}"]
    for number, (theirs, ours) in enumerate(zip(expected, actual)):
        found += [f"message {number}, {theirs.name}: {line}" for line in _differences(theirs, ours, sentinels)]
    return len(expected), found


def _frames(log):
    """Times and frames, by the lengths that the headers name: the log must be whole."""
    position = 0
    while position < len(log):
        (time,) = TIME.unpack_from(log, position)
        start = position + TIME.size
        length, flags = log[start + 1], log[start + 2]
        size = {0xFE: 8 + length, 0xFD: 12 + length + 13 * (flags & 1)}[log[start]]
        yield time, log[start : start + size]
        position = start + size


def _differences(theirs, ours, sentinels):
    """What differs in one message."""
    time = datetime(1970, 1, 1, tzinfo=timezone.utc) + timedelta(microseconds=theirs.time)
    facts = {
        "time": time.strftime("%Y-%m-%dT%H:%M:%S.%fZ"),
        "unix_time": theirs.time / 1e6,
        "system_id": theirs.system,
        "component_id": theirs.component,
        "sequence": theirs.sequence,
        "message_id": theirs.id,
    }
    for key, value in facts.items():
        if ours[key] != value:
            yield f"{key} is {ours[key]}, not {value}"
    message = ours["message"]
    if list(message) != ["type"] + [_key(field) for field in theirs.fields] or message["type"] != theirs.name:
        yield f"message {list(message)} of {message['type']}"
        return
    for field in theirs.fields:
        sentinel = sentinels.get((theirs.name, field.name))
        expected = _with_nulls(field, sentinel, theirs.entries)
        value = message[_key(field)]
        if not _equal(expected, value, field):
            yield f"{field.name} is {value}, not {expected}"


def _key(field):
    """The key of a field, beside the message's name."""
    return "mavtype" if field.name == "type" else field.name


def _with_nulls(field, sentinel, entries):
    """The values of a field, `None` where the XML says that they mean nothing."""
    if sentinel is None:
        return field.value
    scope, text = sentinel
    unknown = _number(text, entries)
    if isinstance(field.value, str):
        return None if scope == "whole" and unknown == 0 and not field.value else field.value
    if not isinstance(field.value, list):
        return None if _is(field.value, unknown, field) else field.value
    if scope == "whole":
        return None if _is(field.value[0], unknown, field) else field.value
    marked = (_is(value, unknown, field) and (scope == "each" or not index) for index, value in enumerate(field.value))
    return [None if is_unknown else value for is_unknown, value in zip(marked, field.value)]


def _number(text, entries):
    """The number that an `invalid` attribute names."""
    if text in LIMITS:
        return LIMITS[text]
    if text in entries:
        return entries[text]
    try:
        return int(text, 0)
    except ValueError:
        return float(text)


def _is(value, unknown, field):
    if math.isnan(unknown):
        return math.isnan(value)
    return value == (_in_width(unknown, field) if field.is_float else unknown)


def _equal(expected, value, field):
    """Whether mavgen's value is pymavlink's."""
    if isinstance(expected, str) and isinstance(value, list):
        # What is no text, or more than text, is written as bytes.
        return bytes(value).split(b"\0")[0].decode(errors="replace") == expected
    if isinstance(expected, list):
        pairs = zip(expected, value) if isinstance(value, list) else ()
        return isinstance(value, list) and len(expected) == len(value) and all(_equal(*pair, field) for pair in pairs)
    if expected is None or isinstance(expected, str):
        return type(value) is type(expected) and value == expected
    if field.is_float:
        return struct.pack("<d", _in_width(_float(value, field), field)) == struct.pack("<d", expected)
    if field.enum is not None:
        return _value_of(value, field) == expected
    return type(value) is int and value == expected


def _float(value, field):
    """A number, or a text for what JSON has no number for; that of a NaN may have its bits."""
    if isinstance(value, str) and value.startswith("NaN(0x"):
        bits, kinds = int(value[4:-1], 16), ("<I", "<f") if field.type == "float" else ("<Q", "<d")
        return struct.unpack(kinds[1], struct.pack(kinds[0], bits))[0]
    return float(value)


def _in_width(value, field):
    """The nearest number of the field's own type."""
    return struct.unpack("<f", struct.pack("<f", value))[0] if field.type == "float" else value


def _value_of(value, field):
    """The number behind a name, flags, or a number that has no name."""
    if isinstance(value, str):
        words = [field.enum.get(word, word) for word in value.split(" | ") if word]
        return sum(word if isinstance(word, int) else int(word, 0) for word in words)
    return None if value in field.enum.values() else value


def _sentinels(path):
    """`invalid` attributes by message and field, of a dialect and all that it includes: whom they speak for, and of what."""
    sentinels, pending, seen = {}, [Path(os.path.abspath(path))], set()
    while pending:
        file = pending.pop()
        if file in seen:
            continue
        seen.add(file)
        root = ElementTree.parse(file).getroot()
        pending += [Path(os.path.abspath(file.parent / include.text.strip())) for include in root.iterfind("include")]
        for message in root.iterfind("messages/message"):
            for field in message.iterfind("field[@invalid]"):
                text, is_text = field.get("invalid"), field.get("type").startswith("char[")
                sentinels[message.get("name"), field.get("name")] = _scope(text, is_text)
    return sentinels


def _scope(text, is_text):
    if not text.startswith("["):
        return "whole" if is_text else "each", text
    inside = text[1:-1]
    if inside.endswith(":"):
        return "whole", inside[:-1]
    return ("first", inside.rstrip(",")) if "," in inside else ("each", inside)


if __name__ == "__main__":
    sys.exit(main())
