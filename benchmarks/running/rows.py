"""The list of repositories, and one row for each that was measured; rows are kept as JSON."""

from __future__ import annotations

import csv
import dataclasses
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Outcome = Literal["runs", "stops", "shell", "refused", "unbuilt", "late", "base missing", "unplanned"]
"""How far a repository came, from the best to the worst."""
OUTCOMES: dict[Outcome, str] = {
    "runs": "built, and its command ran for a minute or ended with 0",
    "stops": "built, and its command ended with an error",
    "shell": "built, and it has no command: a shell",
    "refused": "built, and its packages do not import or find their libraries",
    "unbuilt": "not built",
    "late": "not finished in time",
    "base missing": "its base image is out of reach, and nothing stands in for it",
    "unplanned": "no plan",
}
BUILT: frozenset[Outcome] = frozenset(("runs", "stops", "shell", "refused"))
Whose = Literal["", "ours or the code's", "stand-in", "needs", "unclear"]
WHOSE: dict[Whose, str] = {
    "": "nothing failed",
    "ours or the code's": "by the log it is ours, or the code's own",
    "stand-in": "only the stand-in lacks it or has it newer: the real base image would go on",
    "needs": "the program needs a device, data, arguments or a GPU, and said so",
    "unclear": "no known cause",
}


@dataclass(frozen=True, kw_only=True)
class Listed:
    """A line of a list."""

    repository: str
    """``OWNER/NAME``."""
    kind: str
    reserve: bool
    """It takes the place of one of its kind that cannot be fetched."""


@dataclass(frozen=True, kw_only=True)
class Row:
    """What was seen of one repository; ``None``: it did not come to that, or does not apply."""

    repository: str
    commit: str
    """Its first seven digits."""
    date: str
    """Of the measurement."""
    kind: str
    base: str = ""
    stand_in: str = ""
    """What really was below the base's name; ``""`` if it was the real image."""
    planned: bool = False
    built: bool | None = None
    repairs: int = 0
    """Of the build: how often what was certainly missing was added and it was built again."""
    imports: bool | None = None
    """What it declares can be imported, and its programs find their libraries."""
    command: str = ""
    """As a person types it; ``""`` for a shell."""
    started: bool | None = None
    alive: bool | None = None
    """After a minute, or it ended with 0, with all nodes of a launch."""
    drawn: bool | None = None
    """More than one colour was on the screen."""
    rung: int | None = None
    outcome: Outcome
    whose: Whose = ""
    cause: str = ""
    """Id of the known failure."""
    why: str = ""
    seconds: float = 0.0
    """Of the build."""


def listed(file: Path) -> tuple[Listed, ...]:
    """Read a list: CSV with a head, after comments; the kind of a reserve begins with ``reserve``."""
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    return tuple(
        Listed(
            repository=line["repository"],
            kind=line["kind"].removeprefix("reserve "),
            reserve=line["kind"].startswith("reserve "),
        )
        for line in csv.DictReader(lines)
    )


def tree(folder: Path, repository: str) -> Path:
    """Return where the tree of a repository is: ``OWNER__NAME``."""
    return folder / repository.replace("/", "__")


def chosen(lines: tuple[Listed, ...], trees: Path) -> Iterator[tuple[Listed, Path]]:
    """Yield what is to be measured and its tree, the next reserve of its kind for each that is not there."""
    reserves = [line for line in lines if line.reserve and tree(trees, line.repository).is_dir()]
    for line in lines:
        if line.reserve:
            continue
        found = line
        if not tree(trees, line.repository).is_dir():
            instead = next((each for each in reserves if each.kind == line.kind), None)
            if instead is None:
                continue
            reserves.remove(instead)
            found = instead
        yield found, tree(trees, found.repository)


def due(
    lines: Sequence[tuple[Listed, Path]], rows: Mapping[str, Row], only: Sequence[str] | None
) -> list[tuple[Listed, Path]]:
    """Return what is to be measured: ``only``, else what has no row, then what was late.

    The builder has kept the steps that came to their end before the time was over.
    """
    if only:
        return [line for line in lines if line[0].repository in only]
    late = {name for name, row in rows.items() if row.outcome == "late"}
    return sorted(
        (line for line in lines if line[0].repository not in rows or line[0].repository in late),
        key=lambda line: line[0].repository in late,
    )


def read(file: Path) -> dict[str, Row]:
    """Return the rows that were measured, by repository."""
    data = json.loads(file.read_text(encoding="utf-8")) if file.exists() else []
    return {row["repository"]: Row(**row) for row in data}


def write(file: Path, rows: dict[str, Row]) -> None:
    """Keep the rows."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(dump(rows), encoding="utf-8")


def dump(rows: dict[str, Row]) -> str:
    """Return the rows as JSON, one line each, without what says nothing."""
    told = (
        json.dumps({k: v for k, v in dataclasses.asdict(row).items() if v not in (None, "")}) for row in rows.values()
    )
    return "[\n" + ",\n".join(told) + "\n]\n"
