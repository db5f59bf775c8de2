#!/usr/bin/env python3
"""Write the golden vectors of a dialect: what pymavlink sends for known values, for every message.

usage: make_vectors.py XML OUT [--check]

`--check` writes nothing; it makes the vectors again and says where OUT differs.
Exit status: 0 fine, 1 OUT differs, 2 no vectors can be made (pymavlink refuses the
XML, or the independent reader and encoder disagree with it).

The file is lines of ASCII. A line that begins with `#`, or is empty, says nothing.

    message ID NAME crc_extra=N len_v2=N len_v1=N FIELD...
        FIELD is name:type or name:type[N], in XML order, `+` before it if it is an
        extension; the type is spelled as in the XML. Lengths are of the payload:
        len_v2 with extensions, len_v1 without.
    case NAME SEQUENCE SYSTEM COMPONENT LINK TIMESTAMP
        One set of values for the message above. The numbers are hexadecimal, two
        digits each, the timestamp twelve. LINK and TIMESTAMP are of the signed frame.
    values RUNS...
        One RUNS per field, in XML order. The unit is one element, as a big-endian
        bit pattern of two digits for each byte of the type: 1.0 in a float is
        3f800000, -2 in an int16_t is fffe. A char is its byte. Extensions have a
        value always, though v1 does not send them.
    v1 HEADER PAYLOAD CHECKSUM            absent if the id is over 255
    v2 HEADER PAYLOAD CHECKSUM
    signed HEADER PAYLOAD CHECKSUM SIGNATURE
        The frame of that case, all its bytes in their order on the wire, each part a
        RUNS whose unit is one byte. SIGNATURE is link id, timestamp and hash under
        the key 00 01 02 … 1f.

    RUNS is tokens with commas between them. A token is any number of units in a row,
    or `unit*count`: that unit, count times (decimal). `0102,00*5,03` is 01 02 00 00 00
    00 00 03.
"""

import argparse
import sys
from collections import Counter
from itertools import zip_longest
from pathlib import Path

import pymavlink

import independent
from cases import cases_of
from dialect import Encoder, Refused
from layout import VERSIONS, messages_of_dump
from model import model
from vector_text import message_lines

SHOWN = 100
"""Characters of a differing line that are worth reading."""


class Mismatch(Exception):
    """pymavlink and the independent encoder disagree."""


def main():
    """The command."""
    arguments = _arguments()
    try:
        lines = list(vector_lines(arguments.xml))
    except (Refused, Mismatch) as error:
        print(f"make_vectors: {error}", file=sys.stderr)
        return 2
    text = "\n".join(lines) + "\n"
    if arguments.check:
        return _check(arguments.out, text)
    arguments.out.write_text(text, encoding="ascii", newline="\n")
    print(_summary(lines, len(text)))
    return 0


def _arguments():
    parser = argparse.ArgumentParser(description="Write the golden vectors of a dialect.")
    parser.add_argument("xml", type=Path, metavar="XML", help="the definition")
    parser.add_argument("out", type=Path, metavar="OUT", help="the vector file")
    parser.add_argument("--check", action="store_true", help="compare OUT, do not write it")
    return parser.parse_args()


def vector_lines(xml):
    """The lines of the vector file of a dialect."""
    yield f"# Golden vectors of {xml.name} by tests/oracle/make_vectors.py and pymavlink {pymavlink.__version__}."
    yield "# Do not edit; README.md explains the format."
    oracle = Encoder(xml)
    for message in checked_messages(xml):
        yield from message_lines(message, list(checked_frames(oracle, message)))


def checked_messages(xml):
    """The messages by id, in which the independent reader and pymavlink agree in everything."""
    document, _ = model(xml)
    golden, other = messages_of_dump(document), independent.read_messages(xml)
    for id in sorted(golden.keys() | other.keys()):
        if golden.get(id) != other.get(id):
            raise Mismatch(f"pymavlink has {golden.get(id)}\nthe independent reader {other.get(id)}")
    return [golden[id] for id in sorted(golden)]


def checked_frames(oracle, message):
    """Each case of a message with pymavlink's frames, which must be those of the independent encoder."""
    for case in cases_of(message):
        golden = oracle.frames(message, case)
        other = independent.frames(message, case)
        if golden != other:
            version = next(v for v in VERSIONS if golden.get(v) != other.get(v))
            raise Mismatch(f"{message.name}, case {case.name}, {version}: the frames differ")
        yield case, golden


def _check(out, text):
    """Say where the file first differs from what it should be."""
    if not out.exists():
        print(f"{out} does not exist", file=sys.stderr)
        return 1
    present = out.read_bytes().decode("ascii", errors="replace").split("\n")
    for number, (found, made) in enumerate(zip_longest(present, text.split("\n")), start=1):
        if found != made:
            print(f"{out}:{number}: differs from what pymavlink makes", file=sys.stderr)
            print(f"  in the file: {_shown(found)}\n  made now:    {_shown(made)}", file=sys.stderr)
            return 1
    return 0


def _shown(line):
    return "(the end)" if line is None else line[:SHOWN] + "…" * (len(line) > SHOWN)


def _summary(lines, size):
    counts = Counter(line.split(" ", 1)[0] for line in lines)
    frames = sum(counts[version] for version in VERSIONS)
    return f"{counts['message']} messages, {counts['case']} cases, {frames} frames, {size} bytes"


if __name__ == "__main__":
    sys.exit(main())
