#!/usr/bin/env python3
"""Compare mavgen with pymavlink on every definition in a folder.

usage: compare_dialects.py --mavgen COMMAND --definitions DIR [--expect N] [--bytes DIALECT...]

For each XML file of a folder, the model that pymavlink resolves and the one that
`COMMAND dump --json FILE` prints must be equal (compare_models.py). For each DIALECT of
`--bytes` (`all` for every one), frames are also put together from mavgen's offsets,
lengths and crc_extra, and must be, byte for byte, what pymavlink packs for the same
values. Exit status: 0 all equal, 1 something differs or fewer than N files were there,
2 the usage is wrong.
"""

import argparse
import json
import shlex
import subprocess
import sys
from pathlib import Path

import independent
from cases import cases_of
from compare_models import differences, print_differences
from dialect import Encoder, Refused
from layout import messages_of_dump
from model import model

COMPLAINT_LINES = 5
"""Lines of a failing command's complaint that are repeated."""


def main():
    """The command."""
    arguments = _arguments()
    files = sorted(arguments.definitions.glob("*.xml"))
    unknown = set(arguments.bytes) - {file.stem for file in files} - {"all"}
    if unknown:
        print(f"compare_dialects: no such dialect: {', '.join(sorted(unknown))}", file=sys.stderr)
        return 2
    differing = [file for file in files if not _compare(file, arguments)]
    print(f"{len(files)} dialects, {len(differing)} of them differ")
    if len(files) < arguments.expect:
        print(f"compare_dialects: {arguments.expect} files were expected", file=sys.stderr)
    return 1 if differing or len(files) < arguments.expect else 0


def _arguments():
    parser = argparse.ArgumentParser(description="Compare mavgen with pymavlink on every definition in a folder.")
    parser.add_argument("--mavgen", required=True, type=shlex.split, metavar="COMMAND")
    parser.add_argument("--definitions", required=True, type=Path, metavar="DIR")
    parser.add_argument("--expect", type=int, default=1, metavar="N", help="at least so many files (default: 1)")
    parser.add_argument("--bytes", nargs="+", default=[], metavar="DIALECT", help="compare frames as well")
    return parser.parse_args()


def _compare(file, arguments):
    """Compare one file and print its line; whether all is equal."""
    try:
        expected, refusal = model(file)
        actual = _dump(arguments.mavgen, file)
        found = differences(expected, actual)
        frames = None
        if not {file.stem, "all"}.isdisjoint(arguments.bytes):
            frames, wrong = _compare_frames(file, actual)
            found += wrong
    except (Refused, CommandFailed) as error:
        print(f"{file.stem}: {error}")
        return False
    print(_line(file, expected, frames, refusal, found))
    print_differences(found, indent="    ")
    return not found


def _line(file, expected, frames, refusal, found):
    line = f"{file.stem}: {len(expected['messages'])} messages, {len(expected['enums'])} enums"
    line += "" if frames is None else f", {frames} frames"
    line += f", {len(found)} differences"
    return line + (" (pymavlink without validation)" if refusal else "")


class CommandFailed(Exception):
    """mavgen did not print a model."""


def _dump(mavgen, file):
    """The model that mavgen prints."""
    try:
        ended = subprocess.run([*mavgen, "dump", "--json", file], capture_output=True, text=True, check=False)
    except OSError as error:
        raise CommandFailed(f"{mavgen[0]} does not run: {error}") from error
    if ended.returncode != 0:
        complaint = "\n    ".join(ended.stderr.splitlines()[:COMPLAINT_LINES])
        raise CommandFailed(f"mavgen ended with {ended.returncode}\n    {complaint}")
    try:
        return json.loads(ended.stdout)
    except ValueError as error:
        raise CommandFailed(f"mavgen printed no JSON: {error}") from error


def _compare_frames(file, dump):
    """How many frames were compared, and which messages come out otherwise by mavgen's layout."""
    oracle, layouts = Encoder(file), messages_of_dump(dump)
    compared, wrong = 0, []
    for id, message in independent.read_messages(file).items():
        for case in cases_of(message):
            golden = oracle.frames(message, case)
            compared += len(golden)
            if golden != _frames_by_mavgen(layouts.get(id), case):
                wrong.append(f"frames of {message.name}, case {case.name}: mavgen's layout gives other bytes")
                break
    return compared, wrong


def _frames_by_mavgen(layout, case):
    """The frames by mavgen's layout; none if it lacks the message, or if the values do not fit its fields."""
    try:
        return independent.frames(layout, case) if layout else {}
    except (KeyError, ValueError, OverflowError):
        return {}


if __name__ == "__main__":
    sys.exit(main())
