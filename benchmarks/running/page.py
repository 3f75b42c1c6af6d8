"""What was measured, as Markdown and as one HTML page that needs nothing else."""

from __future__ import annotations

import html
import json
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from benchmarks.running.rows import BUILT, OUTCOMES, WHOSE, Row, read

HEAD = ("repository", "base", "built", "imports", "command", "started", "alive", "screen", "rung", "outcome", "why")
MARKS = {True: "yes", False: "no", None: ""}
TEMPLATE = Path(__file__).resolve().parent / "page.html"


def cells(row: Row) -> tuple[str, ...]:
    """Return a row's cells in the order of ``HEAD``."""
    whose = f" ({row.whose})" if row.whose else ""
    return (
        f"{row.repository} {row.commit}",
        f"{row.base} ({row.stand_in})" if row.stand_in else row.base,
        MARKS[row.built],
        MARKS[row.imports],
        row.command,
        MARKS[row.started],
        MARKS[row.alive],
        {True: "drawn", False: "blank", None: ""}[row.drawn],
        "" if row.rung is None else str(row.rung),
        row.outcome + whose,
        row.why,
    )


def table(rows: Iterable[Row]) -> str:
    """Return rows as a table of Markdown."""
    lines = [f"| {' | '.join(HEAD)} |", f"|{' --- |' * len(HEAD)}"]
    lines += [f"| {' | '.join(_plain(cell) for cell in cells(row))} |" for row in rows]
    return "\n".join(lines) + "\n"


def _plain(text: str) -> str:
    """Return a text for a cell of Markdown."""
    for sign in "\\`*_[]<>|":
        text = text.replace(sign, f"\\{sign}")
    return " ".join(text.split())


def sums(rows: Sequence[Row]) -> list[str]:
    """Return the figures of a reading, a sentence each."""
    outside = [row for row in rows if row.outcome == "base missing" or (row.built is False and row.whose == "stand-in")]
    able = [row for row in rows if row not in outside]
    built = [row for row in able if row.outcome in BUILT]
    named = [row for row in built if row.command and row.whose != "stand-in"]
    runs = [row for row in named if row.outcome == "runs"]
    needs = [row for row in named if row.whose == "needs"]
    shells = [row for row in built if row.outcome == "shell"]
    return [
        f"{_share(sum(row.outcome in BUILT for row in rows), len(rows))} repositories were built.",
        f"Without the {len(outside)} that only the stand-ins keep from it: {_share(len(built), len(able))}.",
        f"{_share(len(runs), len(named))} commands that the lab can start ran for a minute, or ended with 0; "
        f"{len(needs)} more said that they were given no device, data or arguments.",
        f"{_share(len(shells), len(built))} images have a shell in the place of a command.",
    ]


def _share(part: int, whole: int) -> str:
    return f"{part} of {whole} ({part / whole:.0%})" if whole else "0 of 0"


def write(folder: Path) -> None:
    """Write the pages of all readings in a folder."""
    readings = {file.stem: tuple(read(file).values()) for file in sorted(folder.glob("*-*.json"))}
    if readings:
        (folder / "running.md").write_text(markdown(readings), encoding="utf-8")
        (folder / "running.html").write_text(page(readings), encoding="utf-8")


def markdown(readings: dict[str, tuple[Row, ...]]) -> str:
    """Return the page as Markdown."""
    parts = ["# Does it work?\n", INTRODUCTION]
    for name, rows in readings.items():
        counts = Counter(row.outcome for row in rows)
        parts.append(f"\n## {name}\n\n{_when(rows)}\n")
        parts.append("\n".join(f"- {sentence}" for sentence in sums(rows)) + "\n")
        parts.append("| outcome | repositories |\n| --- | ---: |")
        parts.append("\n".join(f"| {OUTCOMES[each]} | {counts[each]} |" for each in OUTCOMES if counts[each]) + "\n")
        parts.append(table(rows))
    return "\n".join(parts)


def _when(rows: Sequence[Row]) -> str:
    """Return when a reading was made, and on what."""
    days = sorted({row.date for row in rows})
    below = sorted({row.stand_in for row in rows if row.stand_in})
    made = f"Measured on {' and '.join(days)}."
    if below:
        made += f" The base images were stand-ins: below their names was {' or '.join(below)}."
    return made


def page(readings: dict[str, tuple[Row, ...]]) -> str:
    """Return the page as HTML: everything is in it."""
    return TEMPLATE.read_text(encoding="utf-8")


INTRODUCTION = """\
Public repositories that nobody prepared, chosen by name before anybody looked at them: what `roslab build` makes of each
from nothing but its tree, whether its packages import, and whether its command runs for a minute beside a display.
Written by `python -m benchmarks.running`; nothing here was corrected by hand. Whose a failure is, is decided by a rule on
its log (`benchmarks/running/standins.toml`), not by reading it.
"""
_ = html, json, WHOSE
