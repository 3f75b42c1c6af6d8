"""The official images of Python."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def python_images() -> dict[str, str]:
    """Return ``{version: release of Debian}`` of the images ``python:VERSION-slim-RELEASE`` that exist."""
    return {row["python"]: row["debian"] for row in rows("python_images")}
