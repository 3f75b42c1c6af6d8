"""Images of Docker Hub that belong to no user: their names have no slash. And the shell of images."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.image import without_tag


@cache
def _names() -> frozenset[str]:
    return frozenset(row["image"] for row in rows("official_images"))


@cache
def _of_publishers() -> frozenset[str]:
    return frozenset(row["image"] for row in rows("usual_shells"))


def with_usual_shell(reference: str) -> bool:
    """Tell whether the steps of a Dockerfile on an image are run by ``/bin/sh``: it is known to name no other shell.

    So it is with Docker's official images, and with those of the publishers in the table; others may have a SHELL.
    """
    name = without_tag(reference).lower().removeprefix("docker.io/").removeprefix("library/")
    return name in _names() | _of_publishers()


def published(reference: str) -> bool:
    """Tell whether a registry may have an image; of names without a slash, Docker Hub has the official ones only."""
    name = without_tag(reference)
    return "/" in name or name.lower() in _names()
