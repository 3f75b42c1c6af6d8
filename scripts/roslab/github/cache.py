"""The caches of a build: where it reads layers from and writes its own, and whose cache mounts it may use."""

from __future__ import annotations

import re

from roslab.github.event import Event, Publication
from roslab.github.inputs import Cache
from roslab.github.run import short
from roslab.values.dataclass import dataclass

PREFIX = "buildcache"
"""Prefix of the cache's tags, which are in the same registry repository as the image's tags."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Branches:
    """Whose caches a build reads, the nearest first, and whose it writes, ``""`` for none."""

    read: tuple[str, ...] = ()
    write: str = ""
    reason: str = ""


@dataclass(frozen=True, kw_only=True, slots=True)
class Layers:
    """Values of buildx's ``--cache-from`` and ``--cache-to``."""

    read: tuple[str, ...] = ()
    write: tuple[str, ...] = ()
    reason: str = ""


@dataclass(frozen=True, kw_only=True, slots=True)
class Tree:
    """Images that hold a workspace's build tree: those to take it from, the nearest first, and the one to write."""

    read: tuple[str, ...] = ()
    write: str = ""


def branches(event: Event, publication: Publication, wish: Cache) -> Branches:
    """Decide whose caches one build uses.

    A branch reads its own cache, then the default branch's. Only a run that publishes writes a cache, and only that of
    its own branch, so that a pull request cannot place anything in a later release. The build of a release's tag reads
    no cache (https://docs.zizmor.sh/audits/#cache-poisoning).
    """
    if wish == "none":
        return Branches(reason="`cache: none` was asked for")
    if wish == "auto" and event.act:
        return Branches(reason="under act the builder's own cache is near")
    if event.tag is not None:
        return Branches(reason="a release is built from nothing that another run left")
    own = event.branch or event.base_branch or event.default_branch
    write = own if publication.push and event.branch else ""
    if event.name == "schedule":
        return Branches(write=write, reason="a scheduled build reads no cache: it is there to see what has moved")
    read = tuple(dict.fromkeys((own, event.default_branch)))
    return Branches(read=read, write=write, reason=f"read from the branches {own} and {event.default_branch}")


def layers(event: Event, publication: Publication, wish: Cache, *, image: str, part: str, variant: str = "") -> Layers:
    """Decide the layer cache of one build.

    ``part`` distinguishes the builds of one image (a platform, or ``all`` for one build of several platforms),
    ``variant`` the calls that build the image in different ways.
    """
    found = branches(event, publication, wish)
    read, write = _references(found, image, part, variant)
    return Layers(
        read=tuple(f"type=registry,ref={each}" for each in read),
        write=(f"type=registry,ref={write},mode=max,ignore-error=true",) if write else (),
        reason=found.reason,
    )


def tree(event: Event, publication: Publication, wish: Cache, *, image: str, part: str, variant: str = "") -> Tree:
    """Decide where one build finds an earlier one's build tree: beside the layers, by the same rules."""
    read, write = _references(branches(event, publication, wish), image, f"{part}.tree", variant)
    return Tree(read=read, write=write)


def mounts(event: Event, wish: Cache, *, variant: str = "") -> str:
    """Return the namespace of a build's cache mounts, which outlive it where a builder serves many jobs.

    What a step leaves in such a mount is used by a later one as it is, so that no namespace is shared across a line
    of trust: a pull request has its own, a branch its own, and a release or a build that asked for no cache one of this
    run alone. https://docs.docker.com/build/buildkit/frontend/ (BUILDKIT_CACHE_MOUNT_NS)
    """
    if wish == "none" or event.tag is not None or event.name == "schedule":
        return f"once-{short(event.repository, event.ref, event.sha, event.run, variant)}"
    if event.branch is None or event.queued:
        return f"proposed-{short(event.repository, event.ref, event.head or '', variant)}"
    return f"branch-{short(event.repository, event.branch, variant)}"


def _references(found: Branches, image: str, part: str, variant: str) -> tuple[tuple[str, ...], str]:
    read = tuple(_reference(image, branch, part, variant) for branch in found.read)
    return read, _reference(image, found.write, part, variant) if found.write else ""


def _reference(image: str, branch: str, part: str, variant: str) -> str:
    """Return a reference that no other branch or variant has, even if the branch's name is too long for a tag.

    A tag has at most 128 characters: https://github.com/distribution/reference/blob/main/regexp.go.
    """
    name = re.sub(r"[^A-Za-z0-9_.-]+", "-", branch)[:80]
    return f"{image}:{PREFIX}-{name}-{short(branch, variant)}-{part}"
