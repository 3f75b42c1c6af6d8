"""The Ubuntu of a library's release that a page lists among what it requires."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.system.cmake_version import has_it
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import fits, version_of
from roslab.knowledge.distros import ubuntus


def of_listed_releases(
    evidence: Evidence,
    usual: str,
    order: Iterable[str],
    *,
    lacking: Collection[str],
    demand: Dependency | None,
    weight: int,
) -> list[Reason]:
    """Return the reason for the first Ubuntu in an order with the releases that a page lists, if the usual lacks one.

    ``lacking``: Ubuntus on which the code does not compile; ``demand``: the CMake that it asks for. A release that no
    Ubuntu has, its author built from source.
    """
    known = [limit for limit in evidence.listed_releases if any(_fits(limit, name) for name in ubuntus().values())]
    missing = next((limit for limit in known if not _fits(limit, usual)), None)
    if missing is None:
        return []
    fitting = (name for name in order if name not in lacking and has_it(name, demand))
    found = next((name for name in fitting if all(_fits(limit, name) for limit in known)), None)
    why = f"the page lists {missing.what}, and {usual} has another release"
    return [because("ubuntu", found, why, missing, weight=weight)] if found else []


def _fits(limit: CodeLimit, ubuntu: str) -> bool:
    known = version_of(limit.library, ubuntu) is not None
    return known and fits(limit.library, ubuntu, at_least=limit.at_least, below=limit.below)
