"""A path that is of no folder, so that there is nothing to open."""

from __future__ import annotations

from pathlib import Path

from roslab.errors import ConfigurationError, Problem
from roslab.repository.checkout import printable


def no_folder(path: str | Path) -> ConfigurationError:
    """Return why a path cannot be opened. Raises ``OSError`` where it cannot be looked at."""
    named, hint = printable(str(path)), "give the root of a repository"
    if "://" in str(path):
        why, hint = "it is an address", "clone it first (`git clone --recursive`), and give the folder"
    elif Path(path).exists():
        why = "it is a file"
    else:
        why = "it is a link that leads nowhere" if Path(path).is_symlink() else "there is nothing at that path"
    return ConfigurationError(Problem(message=f"not a directory: {named}: {why}", hint=hint))
