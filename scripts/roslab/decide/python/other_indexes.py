"""Frameworks that only their maker's index has: what pip is asked for, and where it finds them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import released_together
from roslab.knowledge.other_indexes import OtherIndex, Release, other_indexes
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_PYTHON = frozenset({"python", "cuda"})
_TOPIC = "of_other_index"


def with_other_indexes(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence with a framework's index, and with what pip is asked for where nothing declares it.

    Its modules are then no imports for which a package is guessed. Nothing for ROS, whose Python is the system's.
    """
    declared = [*_declared(evidence)]
    keys = {each.key for each in declared}
    places_of = {row.pip: _place(row, evidence, declared) for row in other_indexes()} if kind in _PYTHON else {}
    row = next((row for row in other_indexes() if places_of.get(row.pip)), None)
    place = places_of[row.pip] if row else None
    if row is None or place is None:
        return evidence
    file, line = place
    index = f"--extra-index-url {row.index}"
    found = [stated(index, "prose", file, line, role="option")]
    if row.pip not in keys and not keys & {*_products(row)}:
        pinned = {each.key for each in declared if each.release or each.url}
        found += _asked(_release(row, evidence), pinned, file, line)
    ours = {*row.modules, *row.also}
    code = tuple(each for each in evidence.code if each.namespace != "import" or each.name not in ours)
    written = {each.written for each in evidence.prose_pip}
    new = tuple(each for each in found if each.written not in written)
    return replace(evidence, code=code, prose_pip=(*evidence.prose_pip, *new))


def consents(guessed: Iterable[Requirement], evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for a framework that asks for consent to its licence when it starts, which the user gives."""
    asked = {each.key: each for each in (*_declared(evidence), *guessed)}
    for row in other_indexes():
        for name in dict.fromkeys((row.pip, *_products(row))):
            if name in asked:
                message = (
                    f"{name} waits at its start for consent to its maker's licence ({row.source}): "
                    f"if you accept it, run the image with `-e {row.consent}=YES`"
                )
                yield warn(message, asked[name])
                return


def _products(row: OtherIndex) -> Iterator[str]:
    return (release.beside[0] for release in row.releases)


def _declared(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what manifests and pages ask for."""
    yield from evidence.prose_pip
    for file in evidence.requirements:
        yield from () if places.vendored(file.file) else file.requirements
    for project in evidence.python:
        yield from (
            ()
            if places.vendored(project.file)
            else [each for each in project.requirements if each.role in {"", "source"}]
        )
    for environment in evidence.conda:
        yield from environment.requirements


def _place(row: OtherIndex, evidence: Evidence, declared: Iterable[Requirement]) -> tuple[str, int] | None:
    """Return where the tree asks for a framework, or imports it."""
    for each in declared:
        if each.key == row.pip and not each.url:
            return each.file, each.line
    for said in evidence.mentions:
        if said.topic == _TOPIC and said.value == row.pip:
            return said.file, said.line
    return next(((use.file, use.line) for use in evidence.code if _uses(use, row)), None)


def _uses(use: Dependency, row: OtherIndex) -> bool:
    counts = use.strength == "used" and not places.aside(use.file)
    return use.namespace == "import" and use.name in row.modules and counts


def _release(row: OtherIndex, evidence: Evidence) -> Release:
    """Return the release that pages and manifests name, by its own number or by that of what it is for.

    Else the newest of the day of the work, and of one before all of them the oldest.
    """
    said = [each.value for each in evidence.mentions if each.topic == _TOPIC and " " in each.value]
    by_name = [each for each in row.releases if any(_names(value, row, each) for value in said)]
    day = evidence.pip_day
    then = [each for each in by_name or row.releases if day is None or each.since <= day]
    return then[-1] if then else (by_name or row.releases)[0]


def _names(said: str, row: OtherIndex, release: Release) -> bool:
    name, _, number = said.partition(" ")
    if (name, number) == release.beside:
        return True
    return name == row.pip and f"{release.release}.".startswith(f"{number}.")


def _asked(release: Release, pinned: set[str], file: str, line: int) -> Iterator[Requirement]:
    """Yield what pip is asked for; a framework that the author pins, and what goes with it, stays his."""
    together = {name: {framework, *names} for framework, names in released_together().items() for name in names}
    for text in release.asks:
        asked = stated(text, "prose", file, line)
        if pinned & {asked.key, *together.get(asked.key, ())}:
            continue
        yield replace(asked, editable=True) if asked.vcs else asked
