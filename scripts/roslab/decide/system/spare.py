"""Packages of the repository that may be left out of an image where they do not compile, as nobody says what it is for.

A tree of exercises has packages of several years, of which no distribution compiles all. It starts a shell, or what
launch files are called and bring. Where a page says what is started, or what is started or another package of the tree
needs it, a package that fails stops the build.
"""

from __future__ import annotations

from collections.abc import Collection, Sized

from roslab.config.model import Config
from roslab.decide.command import Command
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import folders_of
from roslab.decide.system.must_build import of_pages
from roslab.evidence.facts import Evidence

FEWEST = 6
"""Of fewer packages each is most likely what the repository is about."""
_TRIED = frozenset({"test", "doc"})
_NOT_COMPILED = _TRIED | {"exec"}
SHARE = 3
"""One of so many of them may fail: where more do, something else is wrong."""


def spare(
    evidence: Evidence,
    config: Config,
    command: Command,
    packages: Packages,
    *,
    left_out: Collection[str],
    started: Collection[str],
) -> tuple[str, ...]:
    """Return the folders of those with which no other one is compiled, where a shell is started and nothing is tested.

    Or a program that no page runs or names, which needs the packages ``started``: they and what they ask for stay. None
    of which the page at the root launches something, even by a wrong name. A metapackage is compiled with nothing, and
    what a launch file starts may be absent.
    """
    built = [m for m in packages.built if m.name and m.name not in left_out and not m.metapackage]
    unsaid = command.command == Command().command or command.guessed
    if not unsaid or command.given or config.command or config.test or len(built) < FEWEST:
        return ()
    compiled = (m for m in packages.built if not m.metapackage)
    needed = {d.name for m in compiled for d in m.dependencies if d.role not in _NOT_COMPILED}
    needed |= {*_with_all(started, packages), *of_pages(evidence)}
    alone = tuple(m.name for m in built if m.name and m.name not in needed)
    return folders_of(packages, alone) if len(alone) >= FEWEST // 2 else ()


def _with_all(started: Collection[str], packages: Packages) -> set[str]:
    """Return these with what they ask for, in turn: a launch file may find what only a manifest names."""
    asks = {m.name: [d.name for d in m.dependencies if d.role not in _TRIED] for m in packages.built}
    found: set[str] = set()
    left = [*started]
    while left:
        name = left.pop()
        left += () if name in found else asks.get(name, ())
        found.add(name)
    return found


def most(found: Sized) -> int:
    """Return how many of the packages that were found may be left out."""
    return len(found) // SHARE
