#!/usr/bin/env python3
"""Whether the tests notice mistakes: a seeded sample of the mutants that cargo-mutants makes of the generator and the runtime.

    tests/mutants.py mavgen              a hundred of resolve, lower and emit
    tests/mutants.py mavlink-wire        a hundred of the runtime
    tests/mutants.py mavgen --again      the survivors once more, after a test was written for them

Each is tried in one warm copy of the tree, so that only what it changes is compiled again. The tests that decide soonest run
first, on the whole sample; the next ones on what is left: five seconds for most mutants, some minutes for a survivor.
Outcomes are kept in `target/mutants`: a run that was stopped goes on where it was, and the sample is the same as long as the
code is. Exit status: 0 nine in ten of those that compile are caught, 1 fewer are, 2 something is wrong before any change.

Needs `patch` and cargo-mutants, which is used only to list the mutants: `cargo install --locked cargo-mutants`.
"""

import argparse
import collections
import hashlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
WORK = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve() / "mutants"
BUILD_LIMIT = 900
MEMORY_LIMIT = 8 << 30
ENOUGH = 0.9
# Steps that try few cases of each property.
QUICK, QUICK_CASES = ["goldens", "units", "quick"], "16"

# Many seconds long: they run only for what the others let pass.
MAVGEN_SLOW = ["vendor::tests::part", "resolve::tests::hostile", "docs::tests::hostile", "output::tests", "uorb::tests", "select::tests"]
WIRE_SLOW = ["hostile::", "crowds_of_starts", "does_not_block", "full_buffer", "silent_client", "dropped_sender", "work::counted"]
OPTIONAL = [f"--test={name}" for name in ["arbitrary", "bitflags", "defmt", "serde"]]

PACKAGES = {
    "mavgen": {
        "files": [f"mavgen/src/{stage}{end}" for stage in ["resolve", "lower", "emit"] for end in [".rs", "/**"]],
        "steps": {
            "goldens": ["-p", "mavgen", "--all-features", "--test", "library", "--", "golden", "ui", "pages", "model", "malformed", "known"],
            "units": ["-p", "mavgen", "--all-features", "--lib", "--", *(f"--skip={name}" for name in MAVGEN_SLOW)],
            "limits": ["-p", "mavgen", "--all-features", "--test", "library", "--", "imports", "spellings", "limits", "mutations"],
            "slow units": ["-p", "mavgen", "--all-features", "--lib", "--", *MAVGEN_SLOW],
            "conformance": ["-p", "mavlink-conformance", "--test", "conformance"],
            "command line": ["-p", "mavgen-cli"],
            "accepted": ["-p", "mavlink-conformance", "--test", "accepted"],
        },
    },
    "mavlink-wire": {
        "files": ["mavlink-wire/src/**"],
        "steps": {
            "quick": ["-p", "mavlink-wire", "--all-features", "--lib", "--tests", "--", *(f"--skip={name}" for name in WIRE_SLOW)],
            "conformance": ["-p", "mavlink-conformance", "--features", "optional", "--test", "conformance", *OPTIONAL],
            "slow": ["-p", "mavlink-wire", "--all-features", "--lib", "--tests"],
            "small": ["-p", "mavlink-wire", "--no-default-features", "--tests"],
            "dialect": ["-p", "mavlink-autoquad", "--tests"],
            "services": ["-p", "mavlink-services", "--all-features", "--tests"],
            "documentation": ["-p", "mavlink-wire", "--all-features", "--doc"],
        },
    },
}  # fmt: skip


class Tree:
    """A copy of the repository that is changed by one mutant at a time."""

    def __init__(self, package):
        self.folder, self.target = WORK / package / "tree", WORK / package / "target"
        self.limit = None
        listed = subprocess.run(["git", "ls-files", "-coz", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True)
        wanted = {name for name in listed.stdout.decode().split("\0") if name and os.path.lexists(ROOT / name)}
        if self.folder.exists():
            for path in [path for path in self.folder.rglob("*") if path.is_symlink() or path.is_file()]:
                if str(path.relative_to(self.folder)) not in wanted:
                    path.unlink()
        for name in wanted:
            copy(ROOT / name, self.folder / name)

    def cargo(self, arguments, limit, extra={}):
        """The exit status, or none if there was no end."""
        environment = os.environ | {
            "RUST_BACKTRACE": "0", "CARGO_INCREMENTAL": "1", "CARGO_PROFILE_DEV_DEBUG": "0", "CARGO_TARGET_DIR": str(self.target),
            **extra,
        }  # fmt: skip
        started = subprocess.Popen(
            ["cargo", "test", "--quiet", *arguments], cwd=self.folder, env=environment, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limit_memory,
        )  # fmt: skip
        try:
            return started.wait(limit)
        except subprocess.TimeoutExpired:
            return None
        finally:
            # What it started, too: a mutant may leave a server behind.
            try:
                os.killpg(started.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            started.wait()

    def baseline(self, name, arguments):
        """Without a change the tests pass; how long they take says when a trial has no end."""
        command = f"cargo test {' '.join(arguments)}"
        if self.cargo(compile_only(arguments), BUILD_LIMIT) != 0:
            stop(f"the tests of `{name}` do not compile before any change: {command}")
        start = time.monotonic()
        if self.cargo(arguments, BUILD_LIMIT, cases(name)) != 0:
            stop(f"the tests of `{name}` fail before any change: {command}")
        self.limit = 60 + 5 * (time.monotonic() - start)

    def outcome(self, mutant, name, arguments):
        """What becomes of the tests of one step."""
        file = self.folder / mutant["file"]
        before = file.read_bytes()
        try:
            subprocess.run(["patch", "--quiet", "-p0"], cwd=self.folder, input=mutant["diff"].encode(), check=True)
            if self.cargo(compile_only(arguments), BUILD_LIMIT) != 0:
                return "unviable"
            status = self.cargo(arguments, self.limit, cases(name))
            return {0: "missed", None: "timeout"}.get(status, "caught")
        finally:
            file.write_bytes(before)


def stop(message):
    print(message, file=sys.stderr)
    sys.exit(2)


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))


def cases(step):
    return {"PROPTEST_CASES": QUICK_CASES} if step in QUICK else {}


def compile_only(arguments):
    return [*(arguments[: arguments.index("--")] if "--" in arguments else arguments), "--no-run"]


def copy(source, to):
    """Only what differs: cargo goes by the time of the file."""
    if source.is_symlink():
        if not to.is_symlink():
            to.parent.mkdir(parents=True, exist_ok=True)
            to.symlink_to(os.readlink(source))
    elif not to.exists() or to.read_bytes() != source.read_bytes():
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, to)


def sample(tree, files, count, seed):
    """Mutants in the order that the seed gives: a hash of what each changes, so that edits elsewhere leave the sample as it is."""
    options = [option for file in files for option in ["--file", file]]
    listed = subprocess.run(["cargo", "mutants", "--list", "--json", "--diff", *options], cwd=tree.folder, capture_output=True)
    if listed.returncode != 0:
        stop("cargo-mutants is not there, or does not list the mutants: cargo install --locked cargo-mutants")
    mutants, seen = json.loads(listed.stdout), collections.Counter()
    for mutant in mutants:
        change = "".join(line for line in mutant["diff"].splitlines(keepends=True) if not line.startswith("@@"))
        seen[change] += 1
        mutant["key"] = hashlib.sha256(f"{seed} {seen[change]} {change}".encode()).hexdigest()
    print(f"{len(mutants)} mutants, of which {min(count, len(mutants))} are tried with seed {seed}", flush=True)
    return sorted(mutants, key=lambda mutant: mutant["key"])[:count]


def report(package, outcomes):
    """What came out so far, with the survivors; whether that is enough."""
    outcomes = [one for one in outcomes if one["steps"]]
    counts = collections.Counter(one["outcome"] for one in outcomes)
    noticed, viable = counts["caught"] + counts["timeout"], len(outcomes) - counts["unviable"]
    for one in outcomes:
        if one["outcome"] == "missed":
            print(f"  missed: {one['name']}")
    share = noticed / viable if viable else 1
    print(
        f"{package}: {counts['caught']} caught, {counts['timeout']} without an end, {counts['missed']} missed,"
        f" {counts['unviable']} do not compile: {share:.1%} of {viable}"
    )
    return share >= ENOUGH


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package", choices=PACKAGES)
    parser.add_argument("--count", type=int, default=100, help="how many mutants (100)")
    parser.add_argument("--seed", type=int, default=1, help="which ones (1)")
    parser.add_argument("--again", action="store_true", help="try those that were missed once more")
    parser.add_argument("--list", action="store_true", help="only show what is known of the sample")
    options = parser.parse_args()

    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))
    files, steps = PACKAGES[options.package].values()
    tree = Tree(options.package)
    chosen = sample(tree, files, options.count, options.seed)
    kept = WORK / options.package / "outcomes"
    kept.mkdir(exist_ok=True)

    def known(mutant):
        file = kept / mutant["key"]
        one = json.loads(file.read_text()) if file.exists() else {"outcome": "missed", "steps": [], "seconds": 0}
        return one | {"name": mutant["name"]}

    if options.again and not options.list:
        for mutant in chosen:
            if known(mutant)["outcome"] == "missed":
                (kept / mutant["key"]).unlink(missing_ok=True)
    for step, arguments in steps.items():
        still = [mutant for mutant in chosen if known(mutant)["outcome"] == "missed" and step not in known(mutant)["steps"]]
        if options.list or not still:
            continue
        tree.baseline(step, arguments)
        for mutant in still:
            one, start = known(mutant), time.monotonic()
            outcome = tree.outcome(mutant, step, arguments)
            # What only the code of others does not compile with is noticed.
            one["outcome"] = "caught" if outcome == "unviable" and one["steps"] else outcome
            one["steps"].append(step)
            one["seconds"] += round(time.monotonic() - start)
            (kept / mutant["key"]).write_text(json.dumps(one))
            print(f"{step:12} {one['outcome']:8} {one['seconds']:4} s  {mutant['name']}", flush=True)
        report(options.package, [known(mutant) for mutant in chosen])
    sys.exit(0 if report(options.package, [known(mutant) for mutant in chosen]) else 1)


if __name__ == "__main__":
    main()
