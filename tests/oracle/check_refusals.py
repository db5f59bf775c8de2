#!/usr/bin/env python3
"""Check that `mavgen lint` says of each file that it takes whether pymavlink refuses it.

usage: check_refusals.py --mavgen COMMAND XML...

pymavlink reads each file with its validation. One that it refuses has an error for mavgen,
too, or a warning that names pymavlink; one that it takes has none that it refuses (M111).
Exit status: 0 all is so, 1 something is not, 2 the usage is wrong.
"""

import argparse
import shlex
import subprocess
import sys
from pathlib import Path

from check_errors import generates


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Check what `mavgen lint` says of pymavlink.")
    parser.add_argument("--mavgen", required=True, type=shlex.split, metavar="COMMAND")
    parser.add_argument("xml", nargs="+", type=Path, metavar="XML")
    arguments = parser.parse_args()
    wrong = [complaint for xml in arguments.xml if (complaint := _judge(arguments.mavgen, xml))]
    print(f"{len(arguments.xml)} files, lint is wrong about {len(wrong)} of them", *wrong, sep="\n    ")
    return 1 if wrong else 0


def _judge(mavgen, xml):
    """What is wrong with what mavgen says of a file, or nothing."""
    said = subprocess.run([*mavgen, "lint", xml], capture_output=True, text=True, check=False).stderr
    if generates(xml, validate=True):
        return f"{xml}: pymavlink takes it, and lint says otherwise" if "[M111]" in said else None
    silent = "error[" not in said and "pymavlink" not in said
    return f"{xml}: pymavlink refuses it, and lint does not say so" if silent else None


if __name__ == "__main__":
    sys.exit(main())
