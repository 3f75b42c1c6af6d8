"""What exists only for amd64, and since which version other things exist for arm64 too."""

from __future__ import annotations

from functools import cache
from typing import Literal

from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def amd64_only(what: Literal["image", "conda", "archive", "source"]) -> tuple[str, ...]:
    """Return names of conda packages, or prefixes of image names or of addresses, that exist only for amd64.

    A ``source`` is the address of a repository whose build downloads or has libraries for amd64 alone.
    """
    return tuple(row["name"] for row in rows("amd64_only") if row["what"] == what)


@cache
def arm64_since(what: Literal["cuda image", "cuda wheels", "conda python"]) -> Version:
    """Return the first version for arm64: of CUDA with images, of CUDA with wheels, or of conda's Python."""
    return next(Version(row["first"]) for row in rows("arm64_since") if row["what"] == what)


@cache
def arm64_wheels() -> dict[str, Version | None]:
    """Return the first release of a pip package with a Linux arm64 wheel, ``None`` for never."""
    return {row["pip"]: Version(row["first"]) if row["first"] else None for row in rows("arm64_wheels")}
