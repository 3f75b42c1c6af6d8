"""The pages of what was measured: Markdown, and one of HTML that needs nothing else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from benchmarks.running.browser import page
from benchmarks.running.figures import ALL, INTRODUCTION, over_time, sums, title, when
from benchmarks.running.rows import OUTCOMES, Row, read

HEAD = ("repository", "base", "built", "imports", "command", "started", "alive", "screen", "rung", "outcome", "why")
MARKS = {True: "yes", False: "no", None: ""}


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


def markdown(readings: dict[str, tuple[Row, ...]]) -> str:
    """Return the page as Markdown."""
    parts = ["# Does it work?\n", INTRODUCTION, "## All lists\n", ALL, over_time(readings)]
    for name, rows in readings.items():
        parts.append(f"## {title(name)}\n\n{when(rows)}\n")
        parts.append("\n".join(f"- {sentence}" for sentence in sums(rows)) + "\n")
        parts.append(_outcomes(rows))
        parts.append(table(rows))
    return "\n".join(parts)


def _outcomes(rows: Sequence[Row]) -> str:
    counts = Counter(row.outcome for row in rows)
    lines = [f"| {OUTCOMES[each]} | {each} | {counts[each]} |" for each in OUTCOMES if counts[each]]
    return "\n".join(("| came so far | outcome | repositories |", "| --- | --- | ---: |", *lines)) + "\n"


def write(folder: Path) -> None:
    """Write the pages of all readings in a folder."""
    readings = {file.stem: tuple(read(file).values()) for file in sorted(folder.glob("*-*.json"))}
    if readings:
        (folder / "running.md").write_text(markdown(readings), encoding="utf-8")
        (folder / "running.html").write_text(page(readings), encoding="utf-8")
