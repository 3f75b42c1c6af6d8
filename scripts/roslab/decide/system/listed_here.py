"""Releases of libraries that a page asks for as the least, and that the image's Ubuntu does not have."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import page_of, warn
from roslab.decide.system.names import Target, resolve
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import version_of
from roslab.knowledge.libraries import library
from roslab.knowledge.recipes import has_release, header_only, usual_release
from roslab.values.pattern import pattern
from roslab.values.version import Version

_LEAST = pattern(r"[+>≥]|\b(?:newer|later|above|higher|greater|up)\b")
"""A release that is named alone may only be the author's own: it asks for no more."""


def too_old_for_page(evidence: Evidence, target: Target) -> Iterator[CodeLimit]:
    """Yield what a page asks for at least, of the libraries that CMake looks for, where the Ubuntu's is older.

    Of what is built from its source also the release that the author has, where the one that would be built is older.
    """
    if not (evidence.listed_releases and target.ubuntu):
        return
    asked = {each.name for made in evidence.cmake for each in made.dependencies if each.namespace == "cmake"}
    packages = {apt for name in asked if (found := library("cmake", name, target.ubuntu)) for apt in found.apt}
    built = {name.lower() for name in asked if resolve(_asked(name), target).recipe == name.lower()}
    for limit in evidence.listed_releases:
        usual = usual_release(limit.library.lower(), target.ubuntu) if limit.library.lower() in built else None
        if usual and Version(usual) < Version(limit.at_least or "0"):
            yield limit
            continue
        here = version_of(limit.library, target.ubuntu, ros=bool(target.ros_distro))
        same = library("cmake", limit.library, target.ubuntu)
        used = same is not None and not packages.isdisjoint(same.apt)
        least = limit.at_least and _LEAST.search(limit.what)
        if used and here and least and Version(here) < Version(limit.at_least or "0"):
            yield limit


def _asked(name: str) -> Dependency:
    return Dependency(namespace="cmake", name=name, strength="declared", file="CMakeLists.txt", line=1)


def built_for_page(found: Collection[CodeLimit]) -> Iterator[tuple[str, Dependency]]:
    """Yield those of the libraries that are headers alone, in a release that the table has: no program loads two."""
    for limit in found:
        name = limit.library.lower()
        if header_only(name) and has_release(name, limit.at_least or "0", limit.below):
            asked = Dependency(
                namespace="cmake", name=limit.library, strength="prose", file=limit.file, line=limit.line
            )
            yield name, asked


def told_of_page(found: Collection[CodeLimit], names: Collection[str], target: Target) -> Iterator[Warning_]:
    """Yield a warning for each of the others; ``names``: those of what is built from its source, in small letters."""
    for limit in found:
        if limit.library.lower() not in names:
            here = version_of(limit.library, target.ubuntu or "", ros=bool(target.ros_distro))
            message = f"{page_of(limit.file)} asks for {limit.what}, and this Ubuntu ({target.ubuntu}) has {here}"
            yield warn(
                f"{message}: where the code needs more, it does not compile; give the library's repository under "
                "`source` in roslab.yaml, or another base",
                limit,
            )
