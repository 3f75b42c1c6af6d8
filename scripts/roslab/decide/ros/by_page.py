"""Packages that the pages of the repository install themselves, so that no other place has to be looked for."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.decide.ros.misnamed import library_called
from roslab.decide.system.apt_sources import NEAR, PPA
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern


def by_page(asked: Iterable[Dependency], evidence: Evidence) -> frozenset[str]:
    """Return the names of what a package of apt of their name has (``drake-dev``), or what is compiled and installed.

    ``asked``: names of packages in a manifest. Of what is compiled, not those that a table knows as libraries: it says
    how they are built.
    """
    apt = {each.name for each in evidence.prose if each.namespace == "apt"}
    built = {git.name for git in evidence.sources if git.installed and library_called(git.name, None) is None}
    return frozenset(each.name for each in asked if each.name in built or not apt.isdisjoint(packages_of(each.name)))


def by_own_source(names: Iterable[str], evidence: Evidence) -> frozenset[str]:
    """Return the names of what apt brings from a source that the same page adds, whatever else compiles it."""
    pages = {source.file for source in evidence.apt_sources}
    apt = {each.name for each in evidence.prose if each.namespace == "apt" and each.file in pages}
    return frozenset(name for name in names if not apt.isdisjoint(packages_of(name)))


def installed_beside(name: str, evidence: Evidence, *, called: bool = False) -> tuple[str, ...]:
    """Return the packages of a library that a page installs below a source or a PPA which it adds to apt.

    ``called``: also those that only begin with its name, as ``libdart6-all-dev`` does with that of ``dart``.
    """
    alike = pattern(rf"(?:lib)?{re.escape(name.replace('_', '-'))}[\d.]*(?:-.*)?")
    added = {(source.file, source.line) for source in evidence.apt_sources}
    added |= {(m.file, m.line) for m in evidence.mentions if m.topic == "step" and PPA in m.value}
    found = (
        each.name
        for each in evidence.prose
        if each.namespace == "apt"
        and (each.name in packages_of(name) or (called and alike.fullmatch(each.name)))
        and any(file == each.file and 0 < each.line - line <= NEAR for file, line in added)
    )
    return tuple(dict.fromkeys(found))


def packages_of(name: str) -> set[str]:
    """Return the names that a package of Ubuntu with a library and its configuration for CMake may have."""
    plain = name.replace("_", "-")
    return {f"{prefix}{plain}-dev" for prefix in ("", "lib")}
