"""Differences, grouped by kind: two that differ only in names and numbers are of one kind."""

import difflib
import re

NAME = re.compile(r'"[^"]*"|`[^`]*`|\b\w*[A-Z_]\w*\b|\b(?:0x)?\d[\w.]*')
"""What is taken for a name or a number: the words of Rust and of diagnostics stay."""

LINES_OF_KIND, LINES_SHOWN, COLUMNS = 4, 24, 180


class Groups:
    """Kinds of differences, each with its first example and the places of some others."""

    def __init__(self):
        self.kinds, self.probes = {}, set()

    def add(self, probe, what, path, old, new):
        """Takes a difference; every hunk of it counts."""
        self.probes.add(probe)
        if what.startswith("only"):
            self.note((what, path.split("/")[0]), probe, path, [])
            return
        old, new = old.splitlines(), new.splitlines()
        for group in difflib.SequenceMatcher(None, old, new, autojunk=False).get_grouped_opcodes(2):
            hunk = list(lines(group, old, new))
            changed = [line for line in hunk if line[0] in "-+"]
            shape = tuple(sorted({line[0] + NAME.sub("_", line[1:]).strip() for line in changed})[:LINES_OF_KIND])
            self.note((what, shape), probe, path, hunk)

    def note(self, kind, probe, path, hunk):
        count, example, places = self.kinds.get(kind, (0, None, []))
        place = f"{probe} {path}".strip()
        if example is None or len(hunk) < len(example):
            example, places = hunk, [place, *places]
        else:
            places.append(place)
        self.kinds[kind] = (count + 1, example, places[:4])

    def show(self, most):
        """Prints the kinds, the most frequent first."""
        ordered = sorted(self.kinds.items(), key=lambda item: -item[1][0])
        for (what, _), (count, example, places) in ordered[:most]:
            print(f"== {what}, {count} times: {'; '.join(places)}")
            for line in example[:LINES_SHOWN]:
                print(f"   {line[:COLUMNS]}")
            print()
        if len(ordered) > most:
            print(f"... and {len(ordered) - most} kinds more")


def lines(group, old, new):
    """The lines of a hunk, as in a unified diff."""
    for tag, old_from, old_to, new_from, new_to in group:
        if tag == "equal":
            yield from (f" {line}" for line in old[old_from:old_to])
            continue
        yield from (f"-{line}" for line in old[old_from:old_to])
        yield from (f"+{line}" for line in new[new_from:new_to])
