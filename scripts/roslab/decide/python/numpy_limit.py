"""The limit of NumPy: beside packages of pip that were compiled before NumPy 2, and beside the distribution's own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from roslab.config.model import Kind
from roslab.decide.decision import Choice
from roslab.decide.python.bounds import Constraints, decide_bounds, needing_numpy
from roslab.decide.python.torch_build import numpy_of
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because, warn
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.frameworks import imports
from roslab.knowledge.table import row, rows
from roslab.knowledge.tools import INSTALLERS
from roslab.values.dataclass import dataclass, replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

_OLDEST_PYTHON = Version("3.9")
"""The first Python that NumPy 2 has wheels for: https://numpy.org/doc/stable/release/2.0.0-notes.html."""
_LAST_NUMPY_1 = "1.26.4"
_UPPER = frozenset({"<", "<=", "==", "~="})
_OF_BUILDS = frozenset({*INSTALLERS, "cmake", "ninja"})


def numpy_limit(
    evidence: Evidence,
    kind: Kind,
    ubuntu: str | None,
    asked: Sequence[Requirement],
    *,
    limits: Sequence[Requirement],
    of_conda: Sequence[Requirement],
    python: str | None,
    system: bool,
) -> Choice[Constraints]:
    """Return the limit for what pip is ``asked`` for; ``system``: it goes beside the distribution's own packages."""
    if not system:
        limited = any(each.key == "numpy" for each in limits)
        found = numpy_of((*_no_old_numpy(of_conda), *asked, *limits))
        if found.answer or limited:
            return found
        from roslab.decide.python.numpy_of_builds import numpy_of_builds  # noqa: PLC0415 - not for ROS

        return numpy_of_builds(asked, python)
    own = row("system_numpys", ubuntu or "")
    if own is None:
        return Choice(answer=())
    removed = _removed(evidence, asked, Version(own["numpy"]))
    if removed.answer or kind not in {"ros1", "ros2"}:
        return removed
    limit = _beside_apt(evidence, ubuntu, asked)
    return replace(limit, warnings=(*removed.warnings, *limit.warnings))


def _removed(evidence: Evidence, asked: Sequence[Requirement], own: Version) -> Choice[Constraints]:
    """Return the limit that the code needs where pip may bring a newer NumPy than the distribution's own.

    It may where one is asked for, or anything else: what that needs is not known here.
    """
    numpy = [each for each in asked if each.key == "numpy"]
    if not _brings(asked):
        numpy = [each for each in numpy if each.at_least and Version(each.at_least) > own]
    elif not numpy:
        numpy = [stated("numpy")]
    uses = (each for each in evidence.bounds if each.bound.key == "numpy")
    others = (each for each in asked if each.key != "numpy")
    return decide_bounds(
        (each for each in uses if each.bound.below and Version(each.bound.below) > own), (*numpy, *others)
    )


def _brings(asked: Sequence[Requirement]) -> bool:
    """Tell whether pip is asked for something that may ask for NumPy."""
    return bool({each.key for each in asked if each.name} - {*_OF_BUILDS, "numpy"})


def _beside_apt(evidence: Evidence, ubuntu: str | None, asked: Sequence[Requirement]) -> Choice[Constraints]:
    """Return the limit where a module of apt was built with NumPy 1, which no NumPy 2 loads, or breaks even earlier.

    None where pip would find no answer: a release that needs a newer NumPy is asked for. Where the author's own limit
    is as low, only one call of pip knows it: the constraint holds for the later ones.
    https://numpy.org/devdocs/dev/depending_on_numpy.html#numpy-2-0-specific-advice, read 2026-11-26.
    """
    names = {each.key for each in asked if each.name}
    numpy = [each for each in asked if each.key == "numpy"]
    found = limit_of(evidence, ubuntu or "", names) if names - _OF_BUILDS else None
    if found is None or not all(_bears(each, found) for each in numpy):
        return Choice(answer=())
    used = found.used
    if newer := needing_numpy(asked, found.below):
        told = f"{newer.written} needs NumPy {found.below}, beside which the distribution's {used.name} fails to load"
        return Choice(answer=(), warnings=(warn(told, newer if newer.file else used),))
    limit = stated(f"numpy<{found.below}")
    why = f"{used.name} of the distribution {found.why}"
    return Choice(answer=(limit,), reasons=(because("dependencies", limit.written, why, used, weight=Weight.BOUND),))


@dataclass(frozen=True, kw_only=True, slots=True)
class Limit:
    """The first NumPy that a module of apt does not bear, the last one that it does, and where it is imported."""

    below: str
    last: str
    why: str
    used: Dependency


def _bears(numpy: Requirement, limit: Limit) -> bool:
    """Tell whether pip can hold this NumPy below the limit: it is left open, or its own highest release is below."""
    if not numpy.limited:
        return numpy.specifier.contains(limit.last)
    highest = [each.version.removesuffix(".*") for each in numpy.specifier if each.operator in _UPPER]
    return any(Version(each) <= Version(limit.below) and not numpy.specifier.contains(limit.below) for each in highest)


def limit_of(evidence: Evidence, ubuntu: str, by_pip: set[str]) -> Limit | None:
    """Return the lowest limit of the modules of apt that the code imports."""
    used = list(_built_with_numpy(evidence, by_pip))
    broken = {each["module"]: each for each in rows("broken_by_numpy") if each["ubuntu"] == ubuntu}
    for each in used:
        if each.name in broken:
            below, last = broken[each.name]["below"], broken[each.name]["last"]
            why = f"is older than NumPy {below}, and stops beside one that pip brings: names that it uses were removed"
            return Limit(below=below, last=last, why=why, used=each)
    if not used or Version(python_of_ubuntu().get(ubuntu, "0")) < _OLDEST_PYTHON:
        return None
    why = "was built with NumPy 1, which what pip brings must not replace by NumPy 2"
    return Limit(below="2", last=_LAST_NUMPY_1, why=why, used=used[0])


def _built_with_numpy(evidence: Evidence, by_pip: set[str]) -> Iterator[Dependency]:
    """Yield where the code imports a module that was built with NumPy and comes from apt."""
    known = {each["module"] for each in rows("built_with_numpy")}
    for used in evidence.code:
        if used.namespace == "import" and used.name in known and not places.vendored(used.file):
            package = imports().get(used.name, (None, None))[0]
            if package is None or canonicalize_name(package) not in by_pip:
                yield used


def _no_old_numpy(of_conda: Sequence[Requirement]) -> Iterator[Requirement]:
    """Yield conda's packages; NumPy 1 is no limit for pip, which replaces it where a package asks for NumPy 2."""
    return (each for each in of_conda if each.key != "numpy" or each.specifier.contains("2.0.0"))
