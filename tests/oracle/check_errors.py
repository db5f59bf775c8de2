#!/usr/bin/env python3
"""Check that docs/errors.md says rightly what pymavlink does with the files that mavgen refuses.

usage: check_errors.py [--pages DIR] [--table FILE]

Each page of a diagnostic has a wrong example. pymavlink reads it, with its validation
and without, and generates Python from it. What becomes of that must be what the table
says in the column "pymavlink":

- `takes it`: with validation, too.
- `refuses it`: its validation does; without, it generates code.
- `cannot read it`: neither way.
- `never reads it`: it is about an overlay, or about several dialects in one tree.

Exit status: 0 all is as the table says, 1 something is not, 2 the usage is wrong.
"""

import argparse
import re
import sys
import tempfile
from pathlib import Path

from dialect import Refused, run_mavgen

ROOT = Path(__file__).resolve().parents[2]
ROW = re.compile(r"\| (M\d{3}) \| ([^|]+) \| ([^|]+) \| ([^|]+) \|")
BLOCK = re.compile(r"```([^\n]*)\n(.*?)```", re.DOTALL)
NAMED = re.compile(r"<!-- (\S+) -->\n(.*)", re.DOTALL)
NEVER = "never reads it"


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Check what docs/errors.md says of pymavlink.")
    parser.add_argument("--pages", type=Path, default=ROOT / "mavgen/src/diag/pages", metavar="DIR")
    parser.add_argument("--table", type=Path, default=ROOT / "docs/errors.md", metavar="FILE")
    arguments = parser.parse_args()
    rows = ROW.findall(arguments.table.read_text("utf-8"))
    if not rows:
        print(f"check_errors: {arguments.table} has no rows", file=sys.stderr)
        return 2
    wrong = 0
    for code, _, said, _ in rows:
        found = NEVER if said == NEVER and code >= "M700" else verdict(code, arguments.pages / f"{code}.md")
        if found != said:
            print(f"{code}: the table says that pymavlink {said}, and it {found}")
            wrong += 1
    print(f"{len(rows)} errors, {wrong} of them not as the table says")
    return 1 if wrong else 0


def verdict(code, page):
    """What pymavlink does with the wrong example of a page."""
    text = page.read_text("utf-8").split("\n\nWrong:\n\n")[1].split("\n\nRight:\n\n")[0]
    files, top = {}, "acme.xml"
    for kind, block in BLOCK.findall(text):
        if kind == "console":
            top = block.split()[-1]
        else:
            files.update(_files(code, kind, block))
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            (Path(folder) / name).write_bytes(content)
        if generates(Path(folder) / top, validate=True):
            return "takes it"
        return "refuses it" if generates(Path(folder) / top, validate=False) else "cannot read it"


def generates(xml, validate):
    """Whether pymavlink makes Python of a definition."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            run_mavgen(xml, Path(folder) / "dialect.py", "2.0", validate)
        except Refused:
            return False
    return True


def _files(code, kind, block):
    """The files of a block, as mavgen/tests/pages.rs makes them."""
    if kind == "text" and code == "M202":
        names = block.strip().split(" → ")
        for name, following in zip(names, [*names[1:], None], strict=True):
            last = "<message id='1' name='A'><description/><field type='uint8_t' name='f'/></message>"
            yield name, _wrapped(f"<include>{following}</include>" if following else last).encode()
    elif kind == "text":
        yield "acme.xml", _wrapped(_generated(code)).encode()
    else:
        named = NAMED.fullmatch(block)
        name, content = named.groups() if named else ("acme.xml", block)
        yield name, _wrapped(content).encode("latin-1" if kind == "xml latin-1" else "utf-8")


def _generated(code):
    """What the examples that cannot be printed stand for."""
    if code == "M007":
        attributes = "".join(f" a{index}=''" for index in range(65))
        return f"<message id='1' name='A'{attributes}><description/><field type='uint8_t' name='f'/></message>"
    fields = "".join(f"<field type='uint8_t' name='f{index}'>.</field>" for index in range(65))
    return f"<message id='1' name='PUMP_STATUS'><description/>{fields}</message>"


def _wrapped(text):
    """A part of a file in the elements where it belongs.

    The examples leave out descriptions and `<messages>`, which the schema wants: they have
    nothing to do with the subject of their page.
    """
    text = re.sub(r"(<message [^>/]*>)(?!\s*<(description|deprecated|wip|superseded))", r"\1<description/>", text)
    if re.match(r"<(mavlink|mavlnk|\?xml|!DOCTYPE)", text):
        return text
    if text.startswith("<message "):
        return f"<mavlink><messages>{text}</messages></mavlink>"
    if text.startswith("<enum "):
        return f"<mavlink><enums>{text}</enums><messages/></mavlink>"
    return f"<mavlink>{text}{'' if '<messages' in text else '<messages/>'}</mavlink>"


if __name__ == "__main__":
    sys.exit(main())
