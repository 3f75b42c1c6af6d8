"""Lines that a conda environment has for pip and that pip cannot install: they would stop all the others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.refused import refused, right, unfit
from roslab.decide.python.too_new import in_python, told
from roslab.values.requirement import Requirement


def conda_refused(listed: Iterable[Requirement], python: str | None) -> tuple[Requirement, ...]:
    """Return those of the lines ``listed`` for pip: of the index they are something else, or not there at all.

    Also what the image's ``python`` has itself.
    """
    named = (each for each in listed if each.name and not each.role)
    return tuple(each for each in named if in_python(each, python) or refused(each))


def instead_of(taken_out: Iterable[Requirement], python: str | None) -> tuple[Requirement, ...]:
    """Return what pip tries in their place, once the environment is there."""
    return tuple(right(each for each in taken_out if not in_python(each, python)))


def told_of(taken_out: Iterable[Requirement], python: str | None) -> Iterator[Warning_]:
    """Yield a warning for each."""
    for each in taken_out:
        yield told(each, python) if in_python(each, python) else unfit(each)
