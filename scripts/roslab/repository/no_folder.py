"""A path that is of no folder, so that there is nothing to open."""

from __future__ import annotations

from pathlib import Path

from roslab.errors import ConfigurationError, Problem
from roslab.repository.checkout import printable


def no_folder(path: str | Path) -> ConfigurationError:
    """Return why a path cannot be opened. Raises ``OSError`` where it cannot be looked at."""
    why = "it is a file" if Path(path).exists() else "there is nothing at that path"
    return ConfigurationError(
        Problem(message=f"not a directory: {printable(str(path))}: {why}", hint="give the root of a repository")
    )
