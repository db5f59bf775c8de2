#!/usr/bin/env python3
"""Write what `COMMAND_LONG` and `COMMAND_INT` carry for every command, as pymavlink packs them.

usage: make_commands.py XML OVERLAY OUT [--check]

OUT is Rust: each line names a command and its fields as mavgen has to name them, worked out here from the labels alone, and
the payloads. `--check` writes nothing; it says whether OUT differs.
Exit status: 0 fine, 1 OUT differs, 2 pymavlink refuses the XML.
"""

import argparse
import hashlib
import re
import struct
import sys
import tempfile
from decimal import Decimal
from pathlib import Path

import lxml.etree
import pymavlink

from dialect import Refused, load_module, resolve

FRAMES = {0: 7, 3: 7, 6: 7, 10: 7, 1: 4, 7: 4, 20: 4}
"""Frames, and the decimals of coordinates in each: 1e-7 degrees, or 1e-4 metres."""

KEYWORDS = {"continue", "type", "mod", "ref", "move", "in"}


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Write the payloads of every command.")
    parser.add_argument("xml", type=Path, metavar="XML", help="the definition")
    parser.add_argument("overlay", type=Path, metavar="OVERLAY", help="the overlay that labels more params")
    parser.add_argument("out", type=Path, metavar="OUT", help="the file of commands")
    parser.add_argument("--check", action="store_true", help="compare OUT, do not write it")
    arguments = parser.parse_args()
    try:
        text = "".join(f"{line}\n" for line in lines(arguments.xml, arguments.overlay))
    except Refused as error:
        print(f"make_commands: {error}", file=sys.stderr)
        return 2
    if arguments.check:
        same = arguments.out.read_text(encoding="ascii") == text
        print(f"{arguments.out}: {'as it is made' if same else 'differs: make it anew'}")
        return 0 if same else 1
    arguments.out.write_text(text, encoding="ascii", newline="\n")
    return 0


def lines(xml, overlay):
    """The lines of the file."""
    yield f"// By tests/oracle/make_commands.py and pymavlink {pymavlink.__version__}; do not edit."
    yield "//"
    yield "// Command, fields; payload of COMMAND_LONG; frame and payload of COMMAND_INT, both without trailing zeros."
    yield "commands! {"
    labels = overlaid(overlay)
    entries = {
        entry.value: entry
        for file in resolve(xml)
        for enum in file.enum
        if enum.name == "MAV_CMD"
        for entry in enum.entry
        if not entry.end_marker
    }
    with tempfile.TemporaryDirectory() as folder:
        module = load_module(xml, "2.0", folder)
    for _, entry in sorted(entries.items()):
        for case in range(3):
            yield "    " + line(entry, case, labels.get(entry.name, {}), module)
    yield "}"


def overlaid(path):
    """What the overlay says of commands: label, enum and unit by index, and under 0 whether there is a place."""
    said = {}
    for command in lxml.etree.parse(path).getroot().findall("command"):
        params = {int(param.get("index")): param.attrib for param in command.findall("param")}
        said[command.get("name")] = params | {0: command.get("hasLocation") == "true"}
    return said


def line(entry, case, said, module):
    """One command with values."""
    is_place = said.get(0) or entry.has_location
    frame = list(FRAMES)[number(entry.name, case, "frame") % len(FRAMES)]
    fields, floats, whole = [], {}, {5: 0, 6: 0}
    for param in sorted(entry.param, key=lambda param: int(param.index)):
        index = int(param.index)
        extra = said.get(index, {})
        label, enum, unit = (extra.get(key) or getattr(param, key, "") for key in ("label", "enum", "units"))
        if not label or param.reserved:
            floats[index] = float(param.default or 0)
            whole[index] = 2**31 - 1 if floats[index] != floats[index] else int(floats[index])
            continue
        some = number(entry.name, case, index)
        if enum:
            value = some % 128
            text = f"Enum::from_repr({value})"
            floats[index], whole[index] = float(value), value
        elif case == 2 and some % 3 == 0:
            text = "f64::NAN" if index in (5, 6) else "f32::NAN"
            floats[index], whole[index] = float("nan"), 2**31 - 1
        elif index in (5, 6) and is_place and unit != "degE7":
            whole[index] = some % (2 * 1_800_000_000) - 1_800_000_000
            value = Decimal(whole[index]).scaleb(-FRAMES[frame])
            text, floats[index] = literal(value), float(value)
        elif index in (5, 6):
            whole[index] = some % 2_000_000 - 1_000_000
            text, floats[index] = literal(Decimal(whole[index])), float(whole[index])
        else:
            value = Decimal(some % 8000 - 4000) / 8
            text, floats[index] = literal(value), float(value)
        fields.append(f"{field(label)}: {text}")
    floats = [floats.get(index, 0.0) for index in range(1, 8)]
    both = {"target_system": 7, "target_component": 8, "command": entry.value}
    both |= {f"param{index}": floats[index - 1] for index in range(1, 5)}
    long = payload(module, 76, both | {f"param{index}": floats[index - 1] for index in range(5, 8)} | {"confirmation": 0})
    integers = {"frame": frame, "current": 0, "autocontinue": 0, "x": whole[5], "y": whole[6], "z": floats[6]}
    short = payload(module, 75, both | integers)
    name = "".join(word.capitalize() for word in entry.name.removeprefix("MAV_CMD_").split("_"))
    fields = ", ".join(fields)
    return f'{name} {{ {fields} }} "{long}" {frame} "{short}"'.replace("{  }", "{}")


def payload(module, message_id, values):
    """The payload of a message, in hexadecimal."""
    frame = module.mavlink_map[message_id](**values).pack(module.MAVLink(None, 255, 190))
    return bytes(frame[10:-2]).hex()


def literal(value):
    """A Rust float."""
    text = f"{value:f}"
    return text if "." in text else f"{text}.0"


def field(label):
    """The name of a field: words in lower case, joined by underscores."""
    words = re.sub(r"[^0-9A-Za-z]+", "_", label)
    words = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", words).strip("_").lower()
    words = f"_{words}" if words[0].isdigit() else words
    return f"r#{words}" if words in KEYWORDS else words


def number(*of):
    """A number that is random, and always the same."""
    return struct.unpack("<Q", hashlib.sha256(" ".join(map(str, of)).encode()).digest()[:8])[0]


if __name__ == "__main__":
    sys.exit(main())
