"""How long each test of the lab took on this machine: what takes longest begins first, so that all end together."""

from __future__ import annotations

import csv
import json
import math
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

from .home import home


def known() -> dict[str, float]:
    """Return the seconds that each test took when it last passed, by its node id; empty where none was run yet."""
    try:
        found = json.loads(_file().read_text())
    except (OSError, ValueError):
        return {}
    return {str(test): float(seconds) for test, seconds in found.items()}


def of_files(tests: Iterable[str], measured: Mapping[str, float]) -> dict[str, float]:
    """Return the seconds of each file: those of its tests on this machine, the table's where one was not timed.

    A file that is not in the table either is infinitely long: it begins first.
    """
    usual = _usual()
    by_file: dict[str, list[str]] = defaultdict(list)
    for test in tests:
        by_file[test.partition("::")[0]].append(test)
    return {
        file: sum(measured[test] for test in each)
        if all(test in measured for test in each)
        else usual.get(file, math.inf)
        for file, each in by_file.items()
    }


def _usual() -> dict[str, float]:
    """Return the seconds of each file in a whole run on two cores, as the table has them with their day."""
    with Path(__file__).with_suffix(".csv").open(newline="") as table:
        rows = csv.DictReader(line for line in table if not line.startswith("#"))
        return {row["file"]: float(row["seconds"]) for row in rows}


def keep(seconds: Mapping[str, float]) -> None:
    """Keep these beside what is known of other tests, where there is a lab.

    The file is replaced at once: another run may read it.
    """
    if not seconds or not home().is_dir():
        return
    part = _file().with_suffix(".part")
    part.write_text(json.dumps({**known(), **seconds}, indent=1, sort_keys=True))
    part.rename(_file())


def _file() -> Path:
    return home() / "durations.json"
