"""Bounds that the code gives a package, where what is known for sure leaves none of their releases."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Choice, Reason
from roslab.decide.python.bounds import Constraints, excluded
from roslab.decide.reasons import warn
from roslab.knowledge.frameworks import last_below, newest_framework
from roslab.values.requirement import Requirement


def agreeing(bounds: Choice[Constraints], surer: Iterable[Requirement], python: str | None) -> Choice[Constraints]:
    """Return the bounds without those that one of the ``surer`` limits excludes, or that no wheel for a Python fulfils.

    pip finds no release for two that exclude each other, and the build would stop. What is left out is told.
    """
    surer = tuple(surer)
    kept: list[tuple[Requirement, Reason]] = []
    told = list(bounds.warnings)
    for bound, reason in zip(bounds.answer, bounds.reasons, strict=True):
        other = next((each for each in surer if excluded(bound, (each,))), None)
        if other is None and _has_wheel(bound, python):
            kept.append((bound, reason))
            continue
        why = f"{other.written} is installed" if other else f"it has no wheel for Python {python}"
        message = f"{bound.written} is not kept to, for {why}: {reason.reason}, and may stop there"
        told.append(warn(message, reason if reason.file else None))
    answer, reasons = tuple(bound for bound, _ in kept), tuple(reason for _, reason in kept)
    return Choice(answer=answer, reasons=reasons, warnings=tuple(told))


def _has_wheel(bound: Requirement, python: str | None) -> bool:
    """Tell whether the table has a release within a bound for a Python, or knows nothing of the package."""
    below = bound.below
    if python is None or below is None or last_below(bound.key, below) is None:
        return True
    row = newest_framework(bound.key, python=python, below=below)
    return row is None or row.runs_with(python)
