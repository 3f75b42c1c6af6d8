"""README, INSTALL and installation pages: what humans are told to install and run."""

from __future__ import annotations

from roslab.evidence.facts import Prose
from roslab.repository import Repository


def read(repository: Repository) -> Prose:
    """Return the install lines and the names of the world that stand there."""
    del repository
    return Prose()
