"""Python imports, and the Python programs that can be started."""

from __future__ import annotations

from roslab.evidence.facts import Dependency, Script
from roslab.repository import Repository


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return what the tree's Python files import from outside the tree and the standard library."""
    del repository
    return ()


def scripts(repository: Repository) -> tuple[Script, ...]:
    """Return the Python files that are programs."""
    del repository
    return ()
