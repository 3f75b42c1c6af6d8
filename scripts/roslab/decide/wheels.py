"""System packages that wheels need and do not carry."""

from __future__ import annotations

from roslab.decide.decision import Python
from roslab.evidence.facts import Dependency, Evidence


def apt_for_wheels(
    python: Python, ubuntu: str | None, evidence: Evidence
) -> tuple[tuple[str, Dependency], ...]:
    """Return ``(apt name, the requirement that needs it)`` for everything pip installs."""
    del python, ubuntu, evidence
    return ()
