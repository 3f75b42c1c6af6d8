"""What a registry holds of one image: its manifests with their tags, what they refer to, and their removal.

https://distribution.github.io/distribution/spec/api/
"""

from __future__ import annotations

import json
from collections.abc import Callable
from urllib.parse import quote, urljoin, urlsplit

from roslab.engine.credentials import Session
from roslab.errors import BuildError, Problem
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MANIFESTS = (
    "application/vnd.oci.image.index.v1+json",
    "application/vnd.oci.image.manifest.v1+json",
    "application/vnd.docker.distribution.manifest.list.v2+json",
    "application/vnd.docker.distribution.manifest.v2+json",
)
NEXT = pattern(r'<([^>]+)>;\s*rel="?next"?')


@dataclass(frozen=True, kw_only=True, slots=True)
class Manifest:
    """An index or the manifest of one image."""

    digest: str
    children: tuple[str, ...] = ()
    """Digests of the manifests that an index names."""
    subject: str | None = None
    """Digest of what it says something about, as a signature does."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Version:
    """One digest with its tags."""

    digest: str
    tags: tuple[str, ...] = ()
    days: float | None = None
    """Since it was pushed; ``None`` where the registry does not say."""
    name: str = ""
    """By which GitHub's API removes it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Store:
    """What an image's registry can do."""

    versions: Callable[[], tuple[Version, ...]]
    manifest: Callable[[str], Manifest | None]
    """Given a tag or digest; ``None`` where it is gone."""
    remove: Callable[[Version], None]
    whole: bool
    """``versions`` has those without a tag too; else only their indexes tell of them."""


def store(ask: Session) -> Store:
    """Return the store of a registry that speaks its standard's protocol alone, which lists tags and no digests."""

    def versions() -> tuple[Version, ...]:
        found: dict[str, list[str]] = {}
        for tag in tags(ask):
            if known := manifest(ask, tag):
                found.setdefault(known.digest, []).append(tag)
        return tuple(Version(digest=digest, tags=tuple(names)) for digest, names in found.items())

    def remove(version: Version) -> None:
        ask("DELETE", f"manifests/{version.digest}")  # it takes its tags along

    return Store(versions=versions, manifest=lambda reference: manifest(ask, reference), remove=remove, whole=False)


def tags(ask: Session) -> tuple[str, ...]:
    """Return every tag, none where nothing was ever pushed."""
    found: list[str] = []
    path: str | None = "tags/list?n=500"
    while path and (reply := ask("GET", path)):
        found += json.loads(reply.body).get("tags") or ()
        following = NEXT.search(reply.headers.get("Link") or "")
        # The host of the address is the registry's own whatever it says: the password goes along
        parts = urlsplit(urljoin("/", following[1])) if following else None
        path = f"{parts.path}?{parts.query}" if parts else None
    return tuple(found)


def manifest(ask: Session, reference: str) -> Manifest | None:
    """Return what a tag or digest names, ``None`` where it is gone.

    Raises ``BuildError`` for what is no manifest: nothing may be removed by half of the truth.
    """
    reply = ask("GET", f"manifests/{quote(reference, safe=':')}", ", ".join(MANIFESTS))
    if reply is None:
        return None
    try:
        data = json.loads(reply.body)
        children = tuple(str(entry["digest"]) for entry in data.get("manifests") or ())
        subject = (data.get("subject") or {}).get("digest")
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise BuildError(Problem(message=f"the registry gives no manifest for {reference}: {error}")) from None
    digest = reference if reference.startswith("sha256:") else reply.headers.get("Docker-Content-Digest")
    if not digest:
        raise BuildError(Problem(message=f"the registry does not say the digest of {reference}"))
    return Manifest(digest=digest, children=children, subject=subject)
