"""Builds the same repository the paper's way, docker-ros's way and ours, again after each kind of change.

``python -m benchmarks.rebuild`` takes an hour on two cores. Every build is pushed to a registry of its own, from a
BuildKit whose store is its own; the lab must be up (``python3 tests/lab up``). What was measured is merged into
benchmarks/results/rebuild.json, so that a part of it can be measured again.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import os
import sys
import tempfile
from pathlib import Path

from benchmarks.rebuild.builds import Figures
from benchmarks.rebuild.page import Results, picture, table
from benchmarks.rebuild.repositories import REPOSITORIES, Change
from benchmarks.rebuild.ways import CASES, WAYS, measure

RESULTS = Path(__file__).resolve().parent.parent / "results" / "rebuild.json"


def read() -> Results:
    """Return the figures of the last run."""
    data = json.loads(RESULTS.read_text()) if RESULTS.exists() else {}
    return {
        name: {case: {way: Figures(**found) for way, found in ways.items()} for case, ways in cases.items()}
        for name, cases in data.items()
    }


def dump(results: Results) -> str:
    """Return the figures as JSON: by repository, case and way."""
    return json.dumps(results, default=dataclasses.asdict, indent=2) + "\n"


def write(results: Results) -> None:
    """Keep the figures and, for each repository, their picture."""
    RESULTS.parent.mkdir(exist_ok=True)
    RESULTS.write_text(dump(results))
    for name, cases in results.items():
        (RESULTS.parent / f"rebuild-{name}.svg").write_text(picture(cases, f"{name}: seconds until it is pushed"))


def main() -> int:
    """Measure what was asked for, keep it, print all that is known."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = [repository.name for repository in REPOSITORIES]
    parser.add_argument("--repository", choices=names, action="append", help="default: both")
    parser.add_argument("--way", choices=WAYS, action="append", help="default: all")
    parser.add_argument("--case", choices=CASES, action="append", help="default: all; cold is always built")
    parser.add_argument(
        "--rounds", type=int, default=1, help="measure each edit as often, the median counts (default: 1)"
    )
    parser.add_argument("--format", choices=("table", "json"), default="table")
    parser.add_argument("--show", action="store_true", help="build nothing, print the last figures")
    options = parser.parse_args()
    cases = tuple(case for case in CASES if case in {"cold", *(options.case or CASES)})

    results = read()
    print(f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores", file=sys.stderr)
    for repository in REPOSITORIES if not options.show else ():
        if options.repository and repository.name not in options.repository:
            continue
        for way in options.way or WAYS:
            with tempfile.TemporaryDirectory(prefix="roslab-rebuild-") as folder:
                root, place = Path(folder, repository.name), Path(folder, "output")
                place.mkdir()
                repository.make(root)
                for case, found in measure(way, Change(repository, root), place, cases, options.rounds):
                    results.setdefault(repository.name, {}).setdefault(case, {})[way] = found
                    write(results)
    print(dump(results) if options.format == "json" else table(results), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
