#!/usr/bin/env python3
"""Two builds of `mavgen` on the same inputs: whatever differs in trees, standard output, standard error or exit status is shown.

A change that should change nothing is held by this against the build before it; a change that should change something shows
here what it changes, grouped, each kind once. Exit status: 0 all the same, 1 something differs, 2 the usage is wrong.

    tests/net/compare.py OLD NEW                            small
    tests/net/compare.py OLD NEW --random 500 --mutants 2000 --definitions ../upstream

Random dialects and mutants come from `tests/random`: a seed is the same everywhere, `--first` begins elsewhere, and
`--keep FOLDER` leaves the inputs of what differs there.
"""

import argparse
import concurrent.futures
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from frames import recording
from groups import Groups

ROOT = Path(__file__).resolve().parents[2]
TIMEOUT = 120
SELECTIONS = ["HEARTBEAT", "HEARTBEAT,COMMAND_ACK", "PARAM_*", "AQ_*", "*_STATUS,MISSION_ITEM_INT", "COMMAND_*,ESC_*"]
PAIRS = [
    ("ardupilotmega", "common"), ("common", "ardupilotmega"), ("uAvionix", "icarous"), ("cubepilot", "csAirLink"),
    ("autoquad_2018", "autoquad_2021"), ("autoquad_2018", "ardupilotmega"), ("minimal", "test"), ("test", "standard"),
]  # fmt: skip


class Probe:
    """A command line that both builds run, in a folder of their own with a copy of the inputs."""

    def __init__(self, name, folder, *arguments, stdin=None):
        self.name, self.folder, self.arguments, self.stdin = name, folder, [str(one) for one in arguments], stdin

    def run(self, binary):
        """Status, standard output, standard error, and the tree in `out` by path."""
        with tempfile.TemporaryDirectory() as scratch:
            inputs = Path(scratch) / "in"
            inputs.symlink_to(self.folder)
            command = ["mavgen", *self.arguments]
            options = dict(executable=binary, cwd=scratch, input=self.stdin, capture_output=True, timeout=TIMEOUT)
            try:
                done = subprocess.run(command, **options)
            except subprocess.TimeoutExpired:
                return {"status": "no end", "stdout": "", "stderr": "", "tree": {}}
            out = Path(scratch) / "out"
            files = sorted(path for path in out.rglob("*") if path.is_file())
            return {
                "status": str(done.returncode),
                "stdout": text(done.stdout),
                "stderr": timeless(text(done.stderr)),
                "tree": {str(path.relative_to(out)): text(path.read_bytes()) for path in files},
            }


def text(data):
    return data.decode("utf-8", "backslashreplace")


def timeless(said):
    """Standard error without how long it took."""
    words = said.split(" ")
    for at, word in enumerate(words):
        if word.startswith("ms") and at and words[at - 1].isdigit():
            words[at - 1] = "0"
    return " ".join(words)


def overlaid(names):
    return [word for name in names for word in ("--overlay", f"in/{name}")]


def of_dialect(name, folder, roots, overlays=(), old=None):
    """What is asked of one dialect, or of several together."""
    files = [*(f"in/{root}" for root in roots), *overlaid(overlays)]
    yield Probe(f"{name}: generate", folder, "generate", *files, "--out", "out")
    yield Probe(f"{name}: lint", folder, "lint", *files)
    yield Probe(f"{name}: dump", folder, "dump", *files)
    yield Probe(f"{name}: dump --json", folder, "dump", "--json", *files)
    if len(roots) == 1:
        stream = recording(old, folder, roots[0], overlays)
        for layout in ("text", "json", "csv") if stream else ():
            yield Probe(f"{name}: decode {layout}", folder, "decode", *files, "--input", "raw", "--format", layout, stdin=stream)


def states(name, folder, old, new, overlays=()):
    """What changed between two files."""
    for more in ([], ["--json"], ["--all"], ["--api"]):
        yield Probe(f"{name}: diff {' '.join(more)}", folder, "diff", f"in/{old}", f"in/{new}", *more, *overlaid(overlays))


def of_repository(old):
    """The definitions and inputs of tests that stand in the repository."""
    xml, tests = ROOT / "xml", ROOT / "tests"
    overlay = "overlay/autoquad.xml" if (xml / "overlay/autoquad.xml").exists() else "autoquad.overlay.xml"
    yield from of_dialect("autoquad", xml, ["autoquad.xml"], [overlay], old)
    for dialect in ("common", "standard", "minimal"):
        yield from of_dialect(dialect, xml, [f"{dialect}.xml"], (), old)
    farm = ROOT / "examples/own-dialect/xml"
    yield Probe("farm", farm, "generate", "in/farm.xml", *overlaid(["overlay/farm.xml"]), "--out", "out")
    yield from of_dialect("hostile", tests / "hostile", ["hostile.xml"], ["hostile.overlay.xml"], old)
    yield from of_dialect("names", tests / "hostile", ["names.xml"], (), old)
    yield from of_dialect("packed", tests / "packed", ["packed.xml"], ["packed.overlay.xml"], old)
    overlays = [f"{name}.overlay.xml" for name in ("heron", "base", "osprey")]
    yield from of_dialect("roots", tests / "roots", ["heron.xml", "osprey.xml"], overlays)
    for names in SELECTIONS:
        files = ["in/autoquad.xml", *overlaid([overlay]), "--messages", names]
        yield Probe(f"autoquad, {names}: generate", xml, "generate", *files, "--out", "out")
        yield Probe(f"autoquad, {names}: dump", xml, "dump", *files)
        yield Probe(f"autoquad, {names}: vendor", xml, "vendor", "in/autoquad.xml", "--messages", names, "--out", "out")
    yield from of_mistakes(ROOT / "mavgen/tests/ui", old)


def of_mistakes(ui, old):
    """The inputs of the golden diagnostics."""
    for path in sorted(ui.glob("*.xml")):
        yield Probe(f"ui/{path.name}: lint", ui, "lint", f"in/{path.name}")
        yield Probe(f"ui/{path.name}: generate", ui, "generate", f"in/{path.name}", "--out", "out")
    for main in sorted(ui.glob("*/main.xml")):
        roots = ["main.xml", *sorted(path.name for path in main.parent.glob("*.root.xml"))]
        overlays = sorted(path.name for path in main.parent.glob("*.overlay.xml"))
        yield from of_dialect(f"ui/{main.parent.name}", main.parent, roots, overlays, old)


def of_definitions(folder, old):
    """A folder of dialects, as upstream's."""
    names = sorted(path.stem for path in folder.glob("*.xml"))
    for name in names:
        yield from of_dialect(name, folder, [f"{name}.xml"], (), old)
    for one, other in PAIRS:
        if one in names and other in names:
            yield from of_dialect(f"{one} and {other}", folder, [f"{one}.xml", f"{other}.xml"])
            yield from states(f"{one} to {other}", folder, f"{one}.xml", f"{other}.xml")


def made(kind, first, count, scratch):
    """Has `tests/random` write cases; gives the folder of each, its roots and its overlays."""
    if not count:
        return
    target = os.environ.get("CARGO_TARGET_DIR", ROOT / "target")
    command = ["cargo", "run", "--quiet", "--package", "random-dialects", "--target-dir", str(target), "--"]
    subprocess.run([*command, kind, str(first), str(count), str(scratch / kind)], cwd=ROOT, check=True)
    for folder in sorted((scratch / kind).iterdir(), key=lambda folder: int(folder.name)):
        names = sorted(path.name for path in folder.iterdir())
        overlays = [name for name in names if name.endswith(".overlay.xml")]
        roots = [name for name in names if name.endswith(".xml") and name.startswith("main") and name not in overlays]
        yield folder, roots, overlays


def of_random(options, scratch):
    """Dialects and overlays of seeds; each is also compared with the one after it."""
    for folder, roots, overlays in made("dialects", options.first, options.random, scratch):
        name = f"random {folder.name}"
        yield from of_dialect(name, folder, roots, overlays, options.old)
        if len(roots) > 1:
            yield from states(name, folder, roots[0], roots[1])
        yield Probe(f"{name}: --messages", folder, "generate", f"in/{roots[0]}", "--messages", "*A*", "--out", "out")
    for folder, roots, overlays in made("mutants", options.first, options.mutants, scratch):
        files = [*(f"in/{root}" for root in roots), *overlaid(overlays)]
        yield Probe(f"mutant {folder.name}: generate", folder, "generate", *files, "--out", "out")


def differences(probe, old, new):
    """Runs a probe with both; gives what differs, as kind, place, old text and new text."""
    before, after = probe.run(old), probe.run(new)
    found = [(what, "", before[what], after[what]) for what in ("status", "stdout", "stderr") if before[what] != after[what]]
    for path in sorted(before["tree"].keys() | after["tree"].keys()):
        pair = before["tree"].get(path), after["tree"].get(path)
        if None in pair:
            found.append(("only in the old tree" if pair[1] is None else "only in the new tree", path, "", ""))
        elif pair[0] != pair[1]:
            found.append(("tree", path, *pair))
    return probe, found


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=lambda path: str(Path(path).resolve(strict=True)))
    parser.add_argument("new", type=lambda path: str(Path(path).resolve(strict=True)))
    parser.add_argument("--definitions", type=Path, help="a folder of more dialects, and pairs of them")
    parser.add_argument("--random", type=int, default=20, help="random dialects with overlays (20)")
    parser.add_argument("--mutants", type=int, default=60, help="random dialects with two to four mistakes (60)")
    parser.add_argument("--first", type=int, default=1, help="the first seed (1)")
    parser.add_argument("--only", default="", help="only the probes whose name contains this")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--show", type=int, default=30, help="so many kinds are shown (30)")
    parser.add_argument("--keep", type=Path, help="a folder for the inputs of what differs")
    return parser.parse_args()


def main():
    options = arguments()
    scratch = Path(tempfile.mkdtemp())
    try:
        probes = [*of_repository(options.old), *of_random(options, scratch)]
        if options.definitions:
            probes += of_definitions(options.definitions.resolve(), options.old)
        probes = [probe for probe in probes if options.only in probe.name]
        groups = Groups()
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for probe, found in pool.map(lambda probe: differences(probe, options.old, options.new), probes):
                for difference in found:
                    groups.add(probe.name, *difference)
                if found and options.keep:
                    shutil.copytree(probe.folder, options.keep / probe.folder.name, dirs_exist_ok=True)
        groups.show(options.show)
        print(f"{len(probes)} probes, {len(groups.probes)} differ, in {len(groups.kinds)} kinds")
        return 1 if groups.kinds else 0
    finally:
        shutil.rmtree(scratch)


if __name__ == "__main__":
    sys.exit(main())
