#!/usr/bin/env python3
"""Write the enums of a dialect, as pymavlink resolves them.

usage: make_enums.py XML OUT [--check]

`--check` writes nothing; it makes the lines again and says where OUT differs.
Exit status: 0 fine, 1 OUT differs, 2 pymavlink refuses the XML.

The file is lines of ASCII. A line that begins with `#`, or is empty, says nothing.

    enum NAME KIND
        KIND is bitmask or plain. Enums are by name; their entries follow, by value.
    VALUE NAME
        An entry of the enum above; the value is decimal.
"""

import argparse
import sys
from itertools import zip_longest
from pathlib import Path

import pymavlink

from dialect import Refused
from model import model


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Write the enums of a dialect.")
    parser.add_argument("xml", type=Path, metavar="XML", help="the definition")
    parser.add_argument("out", type=Path, metavar="OUT", help="the file of enums")
    parser.add_argument("--check", action="store_true", help="compare OUT, do not write it")
    arguments = parser.parse_args()
    try:
        document, refusal = model(arguments.xml)
    except Refused as error:
        document, refusal = None, error
    if refusal:
        print(f"make_enums: {refusal}", file=sys.stderr)
        return 2
    text = "".join(f"{line}\n" for line in lines(arguments.xml.name, document["enums"]))
    if arguments.check:
        return _check(arguments.out, text)
    arguments.out.write_text(text, encoding="ascii", newline="\n")
    print(f"{len(document['enums'])} enums, {sum(len(enum['entries']) for enum in document['enums'])} entries")
    return 0


def lines(name, enums):
    """The lines of the file."""
    yield f"# Enums of {name} by tests/oracle/make_enums.py and pymavlink {pymavlink.__version__}."
    yield "# Do not edit; README.md explains the format."
    for enum in sorted(enums, key=lambda enum: enum["name"]):
        yield ""
        yield f"enum {enum['name']} {'bitmask' if enum['bitmask'] else 'plain'}"
        for entry in sorted(enum["entries"], key=lambda entry: entry["value"]):
            yield f"{entry['value']} {entry['name']}"


def _check(out, text):
    """Say where the file first differs from what it should be."""
    present = out.read_text(encoding="ascii", errors="replace") if out.exists() else ""
    for number, (found, made) in enumerate(zip_longest(present.split("\n"), text.split("\n")), start=1):
        if found != made:
            print(f"{out}:{number}: differs from what pymavlink makes", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
