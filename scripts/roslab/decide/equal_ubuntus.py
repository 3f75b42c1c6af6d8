"""Which of several Ubuntus is taken for which there is equal evidence."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Reason
from roslab.decide.reasons import strongest
from roslab.decide.system.cmake_version import has_it
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import python_of_ubuntu, ubuntu_released
from roslab.knowledge.os_releases import ends, has_ended

_NEAR = 3
"""Most lines from one value of a matrix to the next: each may have a compiler and an option of its own."""


def best_of_equals(
    reasons: list[Reason], evidence: Evidence, demand: Dependency | None, *, ci: int, below: int
) -> Reason:
    """Return the strongest reason; of equal ones the first whose Ubuntu has the CMake and the Python of the pages.

    ``demand``: the CMake that is needed; ``ci``: the weight of what CI names, of which in one matrix the newest that
    has not ended comes first; ``below``: those of this weight are in their order.
    """
    best = strongest(reasons)
    pythons = {m.value for m in evidence.mentions if m.topic == "python" and m.source == "readme"}

    def fitting(reason: Reason) -> int:
        return has_it(reason.answer, demand) + (python_of_ubuntu().get(reason.answer) in pythons)

    equal = [each for each in reasons if each.weight == best.weight < below]
    first = _newest(best, equal, evidence.day) if best.weight == ci else best
    return max((first, best, *equal), key=fitting)


def _newest(best: Reason, equal: Iterable[Reason], day: str | None) -> Reason:
    """Return the newest of the matrix in which a reason stands that has not ended, that reason where all have.

    ``day``: that of the image, where it is not of today.
    """
    beside = sorted((each for each in equal if each.file == best.file and each.line), key=lambda each: each.line or 0)
    together: list[Reason] = []
    for each in beside:
        if together and (each.line or 0) - (together[-1].line or 0) > _NEAR:
            if best in together:
                break
            together = []
        together.append(each)
    going = [each for each in together if not _ended(each.answer, day)] if best in together else []
    return max(going, key=lambda each: ubuntu_released()[each.answer], default=best)


def _ended(codename: str, day: str | None) -> bool:
    return has_ended(codename) if day is None else ends().get(codename, day) < day
