"""Packages of the repository that may be left out of an image that starts a shell, where they do not compile.

A tree of exercises has packages of several years, of which no distribution compiles all. Where something else is
started, or another package of the tree needs it, a package that fails stops the build.
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
_NOT_COMPILED = frozenset({"exec", "test", "doc"})
SHARE = 3
"""One of so many of them may fail: where more do, something else is wrong."""


def spare(
    evidence: Evidence, config: Config, command: Command, packages: Packages, left_out: Collection[str]
) -> tuple[str, ...]:
    """Return the folders of those with which no other one is compiled, where a shell is started and nothing is tested.

    None of which the page at the root launches something, even by a wrong name. A metapackage is compiled with nothing,
    and what a launch file starts may be absent.
    """
    built = [m for m in packages.built if m.name and m.name not in left_out and not m.metapackage]
    if command.command != Command().command or command.given or config.command or config.test or len(built) < FEWEST:
        return ()
    compiled = (m for m in packages.built if not m.metapackage)
    needed = {*of_pages(evidence)} | {d.name for m in compiled for d in m.dependencies if d.role not in _NOT_COMPILED}
    alone = tuple(m.name for m in built if m.name and m.name not in needed)
    return folders_of(packages, alone) if len(alone) >= FEWEST // 2 else ()


def most(found: Sized) -> int:
    """Return how many of the packages that were found may be left out."""
    return len(found) // SHARE
