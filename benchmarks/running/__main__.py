"""Does it work? Plans, builds, proves and runs every repository of a list, and says why not.

``python -m benchmarks.running LIST --trees FOLDER`` takes a list of this folder and a folder with a clone of each
repository of it, named OWNER__NAME. The lab must be up (``python3 tests/lab up``). A row is written as soon as it is
measured, into OUTPUT/LIST-READING.json, and one that is there is kept, so that it can be interrupted. Afterwards the
pages of all readings in OUTPUT are written anew: ``running.md`` and ``running.html``.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from benchmarks.running import page
from benchmarks.running.measure import Way, measure
from benchmarks.running.rows import chosen, due, dump, listed, read, write
from lab import laboratory
from lab.command import LabError
from roslab.engine.docker import output, say

HERE = Path(__file__).resolve().parent
RESULTS = HERE.parent / "results" / "running"


def make_base(name: str) -> bool:
    """Make the stand-in of an image that the engine lacks; tell whether it is there now."""

    def there() -> bool:
        return output(["docker", "image", "inspect", name]).returncode == 0

    if there():
        return True
    try:
        laboratory.up(bases=(name,))
    except LabError as error:
        say(f"no stand-in for {name}: {error}")
    return there()


def main() -> int:
    """Measure what was asked for and has no row yet; print the rows of the list."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.running", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("list", type=Path, metavar="LIST", help="CSV: kind,repository,…")
    parser.add_argument("--trees", type=Path, metavar="FOLDER", help="clones; without it nothing is measured")
    parser.add_argument("--only", action="append", metavar="OWNER/NAME", help="measure these alone, again if need be")
    parser.add_argument("--reading", default="first", metavar="NAME", help="default: first")
    parser.add_argument("--limit", type=int, default=900, metavar="SECONDS", help="for one repository; default: 900")
    parser.add_argument("--logs", type=Path, metavar="FOLDER", help="keep logs and screenshots")
    parser.add_argument("--most", type=int, metavar="NUMBER", help="measure so many and end")
    parser.add_argument("--format", choices=("table", "json"), default="table")
    parser.add_argument("--output", type=Path, default=RESULTS, metavar="FOLDER")
    options = parser.parse_args()

    file = options.output / f"{options.list.stem}-{options.reading}.json"
    rows = read(file)
    if options.trees:
        os.environ.update(laboratory.current().environment)
        way = Way(limit=options.limit, logs=options.logs, make_base=make_base)
        lines = list(chosen(listed(options.list), options.trees))
        for line, tree in due(lines, rows, options.only)[: options.most]:
            say(f"{line.repository}: {len(rows)} of {len(lines)} were measured")
            row = measure(line, tree, way)
            say(f"{line.repository}: {row.outcome} {row.why}")
            rows[line.repository] = row
            write(file, rows)
    page.write(options.output)
    print(dump(rows) if options.format == "json" else page.table(rows.values()), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
