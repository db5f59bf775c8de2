#!/usr/bin/env python3
"""Compare two models in the schema of `mavgen dump --json`: pymavlink's, which is right, and mavgen's.

usage: compare_models.py PYMAVLINK.json MAVGEN.json

Lists what differs, at most 50 lines. Keys that mavgen has beyond pymavlink's are not
looked at. Exit status: 0 no difference, 1 there are some, 2 the input is wrong.
"""

import argparse
import json
import sys
from collections import Counter
from pathlib import Path

LISTED = 50
"""Differences that are printed; more of them tell nothing new."""

DIALECT_KEYS = ("dialect", "version", "files")
ENUM_KEYS = ("bitmask", "defined_in")
ENTRY_KEYS = ("value", "auto")
MESSAGE_KEYS = ("id", "crc_extra", "len_v1", "len_v2", "defined_in")
FIELD_KEYS = ("type", "array", "offset", "extension", "enum", "units")


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Compare pymavlink's model of a dialect with mavgen's.")
    parser.add_argument("pymavlink", type=Path, metavar="PYMAVLINK.json")
    parser.add_argument("mavgen", type=Path, metavar="MAVGEN.json")
    arguments = parser.parse_args()
    try:
        expected, actual = (json.loads(path.read_text("utf-8")) for path in (arguments.pymavlink, arguments.mavgen))
    except (OSError, ValueError) as error:
        print(f"compare_models: {error}", file=sys.stderr)
        return 2
    found = differences(expected, actual)
    print_differences(found)
    return 1 if found else 0


def print_differences(found, indent=""):
    """One line each, and how many were left out."""
    for line in found[:LISTED]:
        print(f"{indent}{line}")
    if len(found) > LISTED:
        print(f"{indent}… and {len(found) - LISTED} more")


def differences(expected, actual):
    """Every difference between two documents, one line of text each."""
    found = list(_keys("", DIALECT_KEYS, expected, actual))
    found += _records("enum", expected, actual, "enums", _enum)
    found += _records("message", expected, actual, "messages", _message)
    return found


def _enum(where, expected, actual):
    yield from _keys(where, ENUM_KEYS, expected, actual)
    yield from _records(f"{where} entry", expected, actual, "entries", _plain(ENTRY_KEYS))


def _message(where, expected, actual):
    yield from _keys(where, MESSAGE_KEYS, expected, actual)
    yield from _records(f"{where} field", expected, actual, "fields", _plain(FIELD_KEYS))


def _plain(keys):
    """The comparison of records that hold no other records."""
    return lambda where, expected, actual: _keys(where, keys, expected, actual)


def _keys(where, keys, expected, actual):
    """Values under each key; `true` and `1` differ, as they do in JSON."""
    for key in keys:
        if key not in actual:
            yield f"{where} has no {key}".strip()
            continue
        ours, theirs = json.dumps(expected[key]), json.dumps(actual[key])
        if ours != theirs:
            yield f"{where} {key}: pymavlink {ours}, mavgen {theirs}".strip()


def _records(where, expected, actual, key, compare):
    """Two lists of named records: which are missing, extra or there twice, what differs in each, and the order."""
    known = {record["name"]: record for record in expected[key]}
    names = [record.get("name") for record in actual.get(key, [])]
    for name, times in Counter(names).items():
        if name not in known:
            yield f"{where} {name}: only mavgen has it"
        if times > 1:
            yield f"{where} {name}: mavgen has it {times} times"
    given = {record.get("name"): record for record in actual.get(key, [])}
    for name, record in known.items():
        if name not in given:
            yield f"{where} {name}: only pymavlink has it"
            continue
        yield from compare(f"{where} {name}", record, given[name])
    yield from _order(where, [name for name in known if name in given], [name for name in given if name in known])


def _order(where, expected, actual):
    for ours, theirs in zip(expected, actual, strict=True):
        if ours != theirs:
            yield f"{where} order: where pymavlink has {ours}, mavgen has {theirs}"
            return


if __name__ == "__main__":
    sys.exit(main())
