"""What a build of a Python package prints where what builds it is too new, and the release before which it is not."""

from __future__ import annotations

from roslab.knowledge.table import rows


def build_limits() -> str:
    """Return a line for each: the package that builds, the first that is too new, an extended regular expression."""
    return "\n".join(f"{row['package']} {row['below']} {row['pattern']}" for row in rows("build_limits"))
