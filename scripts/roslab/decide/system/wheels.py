"""System packages that wheels need and do not carry, and the system's own packages of what ROS code imports."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.image_python import Python
from roslab.decide.python.only_python3 import only_python3
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.python.of_python3 import package_of
from roslab.knowledge.compiled import sources_need
from roslab.knowledge.distros import ubuntus_with_python2
from roslab.knowledge.frameworks import framework, imports, older_wheels, wheels
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.python2_packages import system_package
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.version import Version, version_of

_TK = "python3-tk"
"""Of the distribution's Python only; conda's brings Tk itself. https://github.com/conda-forge/python-feedstock"""


def apt_for_wheels(
    python: Python, installed: tuple[Requirement, ...], ubuntu: str | None, evidence: Evidence
) -> tuple[tuple[str, Dependency | Requirement], ...]:
    """Return ``(apt name, the requirement or import that needs it)``; ``ubuntu`` is ``None`` on Debian bookworm."""
    found: dict[str, Dependency | Requirement] = {}
    of_python2 = python.manager == "system" and (python.version or "").startswith("2")
    compiled = () if python.manager == "system" else _of_sources(installed, python.version)
    needed: list[tuple[str, Dependency | Requirement]] = [*_of_wheels(installed), *compiled, *_by_hand(evidence)]
    for apt, asked in needed:
        if python.manager == "conda" and apt == _TK:
            continue
        from roslab.knowledge.apt_renames import name_in  # noqa: PLC0415 - few wheels need more

        name = name_in(apt, ubuntu or "bookworm")
        found.setdefault(name.replace("python3-", "python-") if of_python2 else name, asked)
    if ubuntu and python.manager == "venv" and (drawn := _drawing_by_tk(evidence)):
        found.setdefault(_TK, drawn)
    if python.manager == "system":
        pinned = _pinned(python, installed)
        both = ubuntu in ubuntus_with_python2()
        other = both and only_python3(evidence)
        for dependency in evidence.code:
            if dependency.namespace != "import" or dependency.strength != "used" or places.test(dependency.file):
                continue
            package = (imports().get(dependency.name) or (None, None))[0]
            apt_name = package_of(dependency.name) if other else system_package(dependency.name, ubuntu)
            if apt_name and not (package and canonicalize_name(package) in pinned):
                found.setdefault(apt_name, dependency)
            if dependency.name in {"matplotlib", "pylab"}:
                found.setdefault("python-tk" if both and not other else "python3-tk", dependency)
    return tuple(found.items())


def _of_wheels(installed: tuple[Requirement, ...]) -> Iterator[tuple[str, Requirement]]:
    for asked in installed:
        yield from ((apt, asked) for apt in (*wheels().get(asked.key, ()), *_older(asked)))


def _of_sources(installed: tuple[Requirement, ...], python: str | None) -> Iterator[tuple[str, Requirement]]:
    """Yield what a release is compiled with whose last wheels are for an older Python."""
    for asked in installed:
        needs = sources_need().get(asked.key, ())
        known = framework(asked.key, asked.release) if needs and python and asked.release else None
        if known and python and Version(known.python_max) < Version(python):
            yield from ((apt, asked) for apt in needs)


def _by_hand(evidence: Evidence) -> Iterator[tuple[str, Dependency]]:
    """Yield what the code's imports need that their user installs by hand, as no index has them."""
    for used in evidence.code:
        always = used.namespace == "import" and used.strength == "used" and not places.aside(used.file)
        name = canonicalize_name(used.name)
        if always and name in not_on_index():
            yield from ((apt, used) for apt in wheels().get(name, ()))


def _drawing_by_tk(evidence: Evidence) -> Dependency | None:
    """Return the first import of a part of Python's library that Ubuntu has in a package with Tk: ``turtle``."""
    used = (each for each in evidence.code if each.namespace == "import" and each.strength == "used")
    return next((each for each in used if imports().get(each.name) == (None, _TK)), None)


def _pinned(python: Python, installed: tuple[Requirement, ...]) -> set[str]:
    """Return what pip installs in one release, as a manifest has it: the distribution's own would lie below it."""
    aside = {*python.pip_guessed, *python.pip_tried}
    return {each.key for each in installed if each.release and each not in aside and each.role != "conda"}


def _older(asked: Requirement) -> tuple[str, ...]:
    """Return what wheels from before a release need, if the requirement names such a version."""
    before, packages = older_wheels().get(asked.key, (None, ()))
    named = (version_of(each.version.rstrip(".*")) for each in asked.specifier if each.operator not in {"!=", ">"})
    return packages if before and any(found and found < before for found in named) else ()
