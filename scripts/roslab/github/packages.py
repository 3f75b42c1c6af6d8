"""An image's versions in GitHub's API, which lists untagged ones too and gives their age.

https://docs.github.com/en/rest/packages/packages
"""

from __future__ import annotations

import datetime as dt
from urllib.parse import quote

from roslab.engine.credentials import Session
from roslab.engine.versions import Store, Version, manifest
from roslab.errors import BuildError, Problem
from roslab.github.api import Ask, pages


class NoPackageError(BuildError):
    """There is no such package, or the job may not see it."""


def store(image: str, ask: Ask, remove: Ask, session: Session, *, now: dt.datetime) -> Store:
    """Return the store of an image on ghcr.io.

    ``ask`` reads GitHub's API, ``remove`` deletes through it; ``session`` reads the image's manifests. ``versions``
    raises ``NoPackageError`` if the job's token sees no such package.
    """
    _, owner, name = image.split("/", 2)
    place: list[str] = []

    def versions() -> tuple[Version, ...]:
        for kind in ("orgs", "users"):
            path = f"/{kind}/{owner}/packages/container/{quote(name, safe='')}/versions"
            if (found := pages(ask, path)) is not None:
                place[:] = [path]
                return tuple(_version(entry, now) for entry in found)
        hint = (
            "grant the calling job `packages: write`, and name the package by the input image where it has another name"
        )
        raise NoPackageError(Problem(message=f"GitHub shows no package {name} of {owner} to this job", hint=hint))

    def gone(version: Version) -> None:
        remove(f"{place[0]}/{version.name}")

    return Store(versions=versions, manifest=lambda reference: manifest(session, reference), remove=gone, whole=True)


def _version(entry: dict[str, object], now: dt.datetime) -> Version:
    pushed = dt.datetime.fromisoformat(str(entry["updated_at"]).replace("Z", "+00:00"))
    metadata = entry.get("metadata")
    container = metadata.get("container") if isinstance(metadata, dict) else None
    tags = container.get("tags") if isinstance(container, dict) else None
    return Version(
        digest=str(entry["name"]),
        tags=tuple(map(str, tags or ())),
        days=(now - pushed).total_seconds() / 86400,
        name=str(entry["id"]),
    )
