#!/usr/bin/env python3
"""Write pymavlink's resolved model of a dialect as JSON, in the schema of `mavgen dump --json`.

usage: model.py XML [--out FILE]

Where pymavlink and the schema have different words for one thing:

- `type` is the base type as the XML spells it, without the array length. pymavlink turns
  `uint8_t_mavlink_version` into `uint8_t` and remembers that the field is constant; here
  it is `uint8_t_mavlink_version` again.
- `array` is null for a scalar; `units` are without pymavlink's brackets; absent `enum`
  and `units` are null.
- `defined_in` and `files` are file names without folders; a merged enum is defined in
  the first file that names it, in the order of `files`.
- `auto` is true for a value that the XML leaves out, also if merging moved it.
- the entry *_ENUM_END, which pymavlink adds, is left out.
- `version` is that of the top file; without one it is 2, pymavlink's default.

If validation refuses the definition, the model is made without it; stderr says so.
Exit status: 0 fine, 2 pymavlink cannot resolve the definition.
"""

import argparse
import json
import os
import sys
from pathlib import Path

from dialect import Refused, resolve_leniently


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Write pymavlink's model of a dialect as JSON.")
    parser.add_argument("xml", type=Path, metavar="XML", help="the definition")
    parser.add_argument("--out", type=Path, metavar="FILE", help="where to write; without it, to stdout")
    arguments = parser.parse_args()
    try:
        document, refusal = model(arguments.xml)
    except Refused as error:
        print(f"model: {error}", file=sys.stderr)
        return 2
    if refusal:
        print(f"model: made without validation, which refuses the definition: {refusal}", file=sys.stderr)
    text = json.dumps(document, indent=1) + "\n"
    if arguments.out:
        arguments.out.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)
    return 0


def model(xml):
    """The document, and why validation refuses the definition, or `None`."""
    files, refusal = resolve_leniently(xml)
    messages = [_message(message, file) for file in files for message in file.message]
    document = {
        "dialect": files[0].basename,
        "version": files[0].version,
        "files": [os.path.basename(file.filename) for file in files],
        "enums": [_enum(enum, file) for file in files for enum in file.enum],
        "messages": sorted(messages, key=lambda message: message["id"]),
    }
    return document, refusal


def _enum(enum, file):
    entries = [entry for entry in enum.entry if not entry.end_marker]
    return {
        "name": enum.name,
        "bitmask": enum.bitmask,
        "defined_in": os.path.basename(file.filename),
        "entries": [{"name": entry.name, "value": entry.value, "auto": entry.autovalue} for entry in entries],
    }


def _message(message, file):
    base_fields = message.base_fields()
    return {
        "id": message.id,
        "name": message.name,
        "crc_extra": message.crc_extra,
        "len_v1": message.wire_min_length,
        "len_v2": message.wire_length,
        "defined_in": os.path.basename(file.filename),
        "fields": [_field(field, index >= base_fields) for index, field in enumerate(message.fields)],
    }


def _field(field, extension):
    return {
        "name": field.name,
        "type": "uint8_t_mavlink_version" if field.omit_arg else field.type,
        "array": field.array_length or None,
        "offset": field.wire_offset,
        "extension": extension,
        "enum": field.enum or None,
        "units": field.units.removeprefix("[").removesuffix("]") or None,
    }


if __name__ == "__main__":
    sys.exit(main())
