"""What a build of a Python package prints where what builds it is too new, and the release before which it is not.

Releases that old do not run from the Python of the column ``python`` on.
"""

from __future__ import annotations

from roslab.knowledge.table import rows


def build_limits() -> str:
    """Return a line for each: the package that builds, the first that is too new, that Python, an extended pattern."""
    return "\n".join(
        f"{row['package']} {row['below']} {row['python']} {row['pattern']}" for row in rows("build_limits")
    )
