"""Bounds that old releases need and do not declare: torchvision 0.4 allows a Pillow that it cannot be loaded with.

They hold for pip, in whatever it installs later, and for conda, whose packages say no more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Choice, Reason
from roslab.decide.python.bounds import Constraints, excluded, needing_numpy
from roslab.decide.python.pins import of_conda
from roslab.decide.python.weights import PackageWeight
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import conda_names, newest_framework, next_after
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.undeclared_limits import UndeclaredLimit, undeclared_limits
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version, minor_of


@dataclass(frozen=True, kw_only=True, slots=True)
class Undeclared:
    """The same bounds twice."""

    pip: Constraints = ()
    conda: tuple[str, ...] = ()
    """In conda's words."""


def decide_undeclared(
    asked: Iterable[Requirement],
    environment: CondaEnvironment | None = None,
    *,
    day: str | None = None,
    python: str | None = None,
) -> Choice[Undeclared]:
    """Return a bound for each package that an old release in ``asked`` needs so, unless the author limits that.

    What a table limits for another reason (``numpy<2`` for the code) may still be too new for it.
    ``environment``: the one that conda makes; what it names with a version of its own is left to its author. What no
    version is said of is the newest of the ``day``. NumPy is limited for a ``python`` that has releases on both sides
    of the bound, and for nothing that needs a newer one.
    """
    packages = of_conda(environment) if environment else []
    asked = (*asked, *packages)
    limited = {each.key for each in asked if each.limited and each.origin != "table"} | _stated(environment)
    found: dict[str, tuple[UndeclaredLimit, Reason]] = {}
    seen: set[UndeclaredLimit] = set()
    for each in asked:
        for known in undeclared_limits().get(each.key, ()) if not each.url else ():
            bound = known.limit
            if known in seen or not older(each, known, day):
                continue
            seen.add(known)
            if bound.key in limited or excluded(bound, asked) or _has(bound, asked):
                continue
            if bound.key == "numpy" and (not _has_both(python, bound.below) or needing_numpy(asked, bound.below)):
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


def undeclared_in(
    evidence: Evidence, asked: Iterable[Requirement], conda: str | None, python: str | None
) -> Choice[Undeclared]:
    """Return the bounds in an image with this ``python``, which makes the environment of the file ``conda``, if any."""
    environment = next((each for each in evidence.conda if each.file == conda), None)
    asked = (*asked, *_by_hand(evidence, python))
    return decide_undeclared(asked, environment, day=evidence.pip_day, python=python)


def _by_hand(evidence: Evidence, python: str | None) -> Iterator[Requirement]:
    """Yield what the code always imports and no index has: its reader adds it to the image, which must suit it.

    Not what no longer runs with the image's Python.
    """
    for used in evidence.code:
        name = canonicalize_name(used.name)
        if name not in undeclared_limits() or name not in not_on_index():
            continue
        always = used.namespace == "import" and used.strength == "used" and not places.aside(used.file)
        if always and _runs(name, python):
            yield stated(used.name, "import", used.file, used.line)


def _runs(name: str, python: str | None) -> bool:
    from roslab.knowledge.ended_packages import ended_packages  # noqa: PLC0415 - few trees import such a module

    last = ended_packages().get(name)
    return last is None or python is None or Version(minor_of(python) or python) <= Version(last)


def _stated(environment: CondaEnvironment | None) -> set[str]:
    """Return the packages that an environment names with a version, under their names on pip's index."""
    packages = environment.packages if environment else ()
    return {conda_names().get(each.name) or each.name for each in packages if each.version}


def _has(bound: Requirement, asked: Iterable[Requirement]) -> bool:
    """Tell whether a limit of a table leaves nothing newer than a bound already, or the bound is no upper one."""
    last = bound.below
    limits = (each for each in asked if each.key == bound.key and each.limited)
    return any(last is None or each.release or Version(each.below or last) <= Version(last) for each in limits)


def _has_both(python: str | None, below: str | None) -> bool:
    """Tell whether NumPy has wheels for a Python on both sides of a bound: else it stops pip, or says nothing."""
    if python is None or below is None:
        return True
    minor = minor_of(python) or python
    older, newest = newest_framework("numpy", python=minor, below=below), newest_framework("numpy", python=minor)
    if older is None or newest is None or not older.runs_with(minor):
        return False
    after = next_after(newest)
    return after is None or Version(after.first) > Version(below)


def older(asked: Requirement, known: UndeclaredLimit, day: str | None = None) -> bool:
    """Tell whether every release that a requirement allows is older than the first one that needs no such limit.

    What it leaves free is the newest release of the ``day``, if pip's packages are of one.
    """
    if known.below is None:
        return True
    if day and day < known.released and not asked.limited:
        return True
    if asked.release:
        return Version(asked.release) < known.below
    if asked.below is None or Version(asked.below) > known.below:
        return False
    return not asked.specifier.contains(str(known.below), prereleases=True)
