"""What a reading amounts to, in sentences that both pages carry."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from benchmarks.running.rows import BUILT, Row

READINGS = ("first", "second", "third", "fourth", "fifth", "sixth")
"""In their order; one with another name comes after them."""

INTRODUCTION = """\
Public repositories that nobody prepared, chosen by name before anybody looked at them: what `roslab build`
makes of each from nothing but its tree, whether what it declares imports and finds its libraries, and whether
its command runs for a minute beside a display. Written by `python -m benchmarks.running`; no row was corrected
by hand.

Whose a failure is, is decided by a rule on its log (`benchmarks/running/standins.toml`), not by reading it: the
stand-in's are packages that only it lacks, clones where no code host is in reach, and libraries that changed
between the release that the plan names and the Debian below that name. What no rule knows counts as ours.
"""
"""Two paragraphs of Markdown."""

ALL = """\
Of each list the newest reading of each repository. What was not finished in time, and what only the stand-ins
prevent, is in no share; `at first` is the list's first reading, `ran` is of the images with a command.
"""


def sums(rows: Sequence[Row]) -> list[str]:
    """Return the figures of a reading, a sentence each."""
    late, outside, able = _parted(rows)
    built = [row for row in able if row.outcome in BUILT]
    commands = [row for row in built if row.command]
    stopped = [row for row in commands if row.whose == "stand-in"]
    runs = [row for row in commands if row.outcome == "runs"]
    needs = [row for row in commands if row.whose == "needs"]
    shells = [row for row in built if row.outcome == "shell"]
    came = f"Built: {_share(len(built), len(rows))}; without {len(outside)} that only the stand-ins prevent, and "
    came += f"{len(late)} that were not finished in time, {_share(len(built), len(able))}."
    if repaired := sum(row.repairs > 0 for row in built):
        came += f" Of these {repaired} were built after a repair."
    ran = f"Of the images with a command, {_share(len(runs), len(commands))} ran for a minute or ended with 0; without "
    ran += f"{len(stopped)} that only the stand-ins stop, {_share(len(runs), len(commands) - len(stopped))}. "
    ran += f"{len(needs)} of the others said that a device, data or arguments were missing."
    alone = f"A shell in the place of a command, as a library has: {_share(len(shells), len(built))} of the images."
    return [came, ran, alone]


def _parted(rows: Sequence[Row]) -> tuple[list[Row], list[Row], list[Row]]:
    """Return those that were not finished in time, those that only the stand-ins prevent, and the rest."""
    late = [row for row in rows if row.outcome == "late"]
    outside = [row for row in rows if row.outcome == "base missing" or (row.built is False and row.whose == "stand-in")]
    return late, outside, [row for row in rows if row not in outside and row not in late]


def over_time(readings: Mapping[str, Sequence[Row]]) -> str:
    """Return a table of Markdown: of each list the newest reading of each repository, and all lists up to it.

    ``readings`` by ``LIST-READING``. A repository that was not finished in time, or that only the stand-ins prevent, is
    in no share; what no rule knows is ours or the code's.
    """
    head = "| list | begun | measured | stand-ins' | late | built of the rest | at first | with all before | ran |"
    return "\n".join((head, f"|{' --- |' * 2}{' ---: |' * 7}", *_lines(readings))) + "\n"


def _lines(readings: Mapping[str, Sequence[Row]]) -> Iterator[str]:
    first: dict[str, dict[str, Row]] = {}
    newest: dict[str, dict[str, Row]] = {}
    for name in sorted(readings, key=_order):
        of = name.rpartition("-")[0]
        for row in readings[name]:
            first.setdefault(of, {}).setdefault(row.repository, row)
            newest.setdefault(of, {})[row.repository] = row
    begun = {of: min(row.date for row in rows.values()) for of, rows in first.items()}
    before: list[Row] = []
    for of in sorted(newest, key=lambda name: (begun[name], _number(name))):
        rows = list(newest[of].values())
        before += rows
        late, outside, able = _parted(rows)
        at_first = _built(_parted(list(first[of].values()))[2])
        cells = (of, begun[of], len(rows), len(outside), len(late), _built(able), at_first, _built(_parted(before)[2]))
        yield f"| {' | '.join(map(str, cells))} | {_ran(able)} |"
    late, outside, able = _parted(before)
    yield f"| all | | {len(before)} | {len(outside)} | {len(late)} | {_built(able)} | | | {_ran(able)} |"


def _built(able: Sequence[Row]) -> str:
    return _share(sum(row.outcome in BUILT for row in able), len(able))


def _ran(able: Sequence[Row]) -> str:
    """Return how many images with a command ran it, without those that only the stand-ins stop."""
    commands = [row for row in able if row.outcome in BUILT and row.command and row.whose != "stand-in"]
    return _share(sum(row.outcome == "runs" for row in commands), len(commands))


def _order(name: str) -> tuple[int, str]:
    reading = name.rpartition("-")[2]
    return (READINGS.index(reading) if reading in READINGS else len(READINGS), name)


def _number(name: str) -> int:
    number = name.rpartition("-")[2]
    return int(number) if number.isdigit() else 0


def title(name: str) -> str:
    """Return the heading of a reading, ``LIST-READING``."""
    of, _, reading = name.rpartition("-")
    return f"{of}.csv, {reading} reading"


def when(rows: Sequence[Row]) -> str:
    """Return when a reading was made, and on what."""
    days = sorted({row.date for row in rows})
    below = sorted({row.stand_in for row in rows if row.stand_in})
    made = f"Measured on {' and '.join(days)}, {len(rows)} repositories."
    if below:
        made += f" The base images were stand-ins: below their names was {' or '.join(below)}, not Ubuntu."
    return made


def _share(part: int, whole: int) -> str:
    return f"{part} of {whole} ({part / whole:.0%})" if whole else "0 of 0"
