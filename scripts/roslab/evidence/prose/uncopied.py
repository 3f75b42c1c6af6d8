"""What a Dockerfile starts and does not hold: the rest of the repository is mounted where its container is run."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Sequence

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_OPEN = pattern(r"[*?\[$]")
_PUNCTUATION = "\"'`;&()"


def paths_of(context: str, copied: Iterable[tuple[str, int]]) -> tuple[str, ...]:
    """Return what is copied, relative to the root: none where a pattern is among it. ``copied``: each with its line."""
    paths = tuple(f"{context}/{source}".strip("/") for source in dict(copied))
    return () if any(re.search(r"[*?\[]", path) for path in paths) else paths


def uncopied(repository: Repository, context: str, copied: Iterable[str], starts: Sequence[str]) -> str | None:
    """Return the first file of the build context that a Dockerfile starts while no COPY of it brings that file.

    ``copied`` are the sources of its COPY lines, ``""`` for the whole context; ``starts`` are its CMD and ENTRYPOINT.
    """
    held = tuple(copied)
    if any(not source or _OPEN.search(source) for source in held):
        return None
    for word in (word.strip(_PUNCTUATION).removeprefix("./") for part in starts for word in part.split()):
        path = posixpath.normpath(f"{context}/{word}".lstrip("/"))
        if word.startswith("/") or "/" not in word or not repository.has(path):
            continue
        inside = any(word == source or word.startswith(f"{source}/") for source in held)
        if not inside and not any(
            repository.has(posixpath.normpath(f"{context}/{s}/{word}".lstrip("/"))) for s in held
        ):
            return path
    return None
