"""What a Dockerfile clones, and the folders that this makes."""

from __future__ import annotations

from collections.abc import Set

from roslab.evidence.dependency import GitSource
from roslab.repository.checkout import Repository


def from_one(folders: Set[str], path: str) -> str:
    """Return the end of a path from the last of the folders on that it names, ``""`` where it names none."""
    parts = path.split("/")
    return next(("/".join(parts[at:]) for at in reversed(range(len(parts))) if parts[at] in folders), "")


def is_itself(repository: Repository, clone: GitSource) -> bool:
    """Tell whether a clone is of the repository itself, by its name."""
    origin = (repository.origin or "").rstrip("/").removesuffix(".git").rpartition("/")[2].lower()
    folder = repository.folder_name.rpartition("__")[2].lower()
    return clone.name.lower() in {origin, folder} - {""}
