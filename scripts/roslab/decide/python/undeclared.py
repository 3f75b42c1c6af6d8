"""Bounds that old releases need and do not declare: torchvision 0.4 allows a Pillow that it cannot be loaded with.

They hold for pip, in whatever it installs later, and for conda, whose packages say no more.
"""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Choice, Reason
from roslab.decide.python.bounds import Constraints, excluded
from roslab.decide.python.pins import of_conda
from roslab.decide.python.weights import PackageWeight
from roslab.decide.reasons import because
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.knowledge.frameworks import conda_names
from roslab.knowledge.undeclared_limits import UndeclaredLimit, undeclared_limits
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement
from roslab.values.version import Version


@dataclass(frozen=True, kw_only=True, slots=True)
class Undeclared:
    """The same bounds twice."""

    pip: Constraints = ()
    conda: tuple[str, ...] = ()
    """In conda's words."""


def decide_undeclared(asked: Iterable[Requirement], environment: CondaEnvironment | None = None) -> Choice[Undeclared]:
    """Return a bound for each package that an old release in ``asked`` needs so, unless the author limits that.

    ``environment``: the one that conda makes; what it names with a version of its own is left to its author.
    """
    packages = of_conda(environment) if environment else []
    asked = (*asked, *packages)
    limited = {each.key for each in asked if each.limited} | _stated(environment)
    found: dict[str, tuple[UndeclaredLimit, Reason]] = {}
    for each in asked:
        for known in undeclared_limits().get(each.key, ()) if not each.url else ():
            bound = known.limit
            if not older(each, known) or bound.key in limited or excluded(bound, asked):
                continue
            why = f"{each.written} needs it, and does not say so"
            before = found.get(bound.key)
            if before is None or Version(bound.below or "0") < Version(before[0].limit.below or "0"):
                found[bound.key] = known, because("dependencies", bound.written, why, each, weight=PackageWeight.BOUND)
    return Choice(
        answer=Undeclared(
            pip=tuple(known.limit for known, _ in found.values()),
            conda=tuple(known.conda for known, _ in found.values()) if environment else (),
        ),
        reasons=tuple(why for _, why in found.values()),
    )


def _stated(environment: CondaEnvironment | None) -> set[str]:
    """Return the packages that an environment names with a version, under their names on pip's index."""
    packages = environment.packages if environment else ()
    return {conda_names().get(each.name) or each.name for each in packages if each.version}


def older(asked: Requirement, known: UndeclaredLimit) -> bool:
    """Tell whether every release that a requirement allows is older than the first one that needs no such limit."""
    if asked.release:
        return Version(asked.release) < known.below
    if asked.below is None or Version(asked.below) > known.below:
        return False
    return not asked.specifier.contains(str(known.below), prereleases=True)
