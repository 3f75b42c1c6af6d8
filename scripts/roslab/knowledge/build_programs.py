"""What a build of a Python package prints where it lacks a program or a module, and what brings that by pip."""

from __future__ import annotations

from roslab.knowledge.table import rows


def build_programs() -> str:
    """Return a line for each: the requirement, and an extended regular expression."""
    return "\n".join(f"{row['pip']} {row['pattern']}" for row in rows("build_programs"))
