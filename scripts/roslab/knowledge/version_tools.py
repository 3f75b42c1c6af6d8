"""Tools that give a Python project its version from git, and what they read where there is no git."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def version_tools() -> dict[str, str]:
    """Return, by canonical package name, ``PKG-INFO`` (a source distribution's) or ``git_refnames`` (an archive's).

    Or the variable that it reads the version from; ``tool.pdm.version`` stands for that table of a pyproject.toml.
    """
    return {row["package"]: row["reads"] for row in rows("version_tools")}
