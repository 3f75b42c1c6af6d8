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
class Layers:
    """Values of buildx's ``--cache-from`` and ``--cache-to``."""

    read: tuple[str, ...] = ()
    write: tuple[str, ...] = ()
    reason: str = ""


def layers(event: Event, publication: Publication, wish: Cache, *, image: str, part: str, variant: str = "") -> Layers:
    """Decide the layer cache of one build.

    ``part`` distinguishes the builds of one image (a platform, or ``all`` for one build of several platforms),
    ``variant`` the calls that build the image in different ways. A branch reads its own cache, then the default
    branch's. Only a run that publishes writes a cache, and only that of its own branch, so that a pull request cannot
    place a layer in a later release. The build of a release's tag reads no cache
    (https://docs.zizmor.sh/audits/#cache-poisoning).
    """
    if wish == "none":
        return Layers(reason="`cache: none` was asked for")
    if wish == "auto" and event.act:
        return Layers(reason="under act the builder's own cache is near")
    if event.tag is not None:
        return Layers(reason="a release is built from nothing that another run left")
    own = event.branch or event.base_branch or event.default_branch
    read = tuple(dict.fromkeys(_reference(image, branch, part, variant) for branch in (own, event.default_branch)))
    write = (
        (f"{_reference(image, own, part, variant)},mode=max,ignore-error=true",)
        if publication.push and event.branch
        else ()
    )
    if event.name == "schedule":
        return Layers(write=write, reason="a scheduled build reads no cache: it is there to see what has moved")
    return Layers(read=read, write=write, reason=f"read from the branches {own} and {event.default_branch}")


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


def _reference(image: str, branch: str, part: str, variant: str) -> str:
    """Return a tag that no other branch or variant has, even if the branch's name is too long for a tag.

    A tag has at most 128 characters: https://github.com/distribution/reference/blob/main/regexp.go.
    """
    name = re.sub(r"[^A-Za-z0-9_.-]+", "-", branch)[:80]
    return f"type=registry,ref={image}:{PREFIX}-{name}-{short(branch, variant)}-{part}"
