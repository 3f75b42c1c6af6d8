"""Which layers a build may start from, and where it leaves its own."""

from __future__ import annotations

import re
from dataclasses import dataclass

from roslab.github.event import Event, Publication
from roslab.github.inputs import Cache
from roslab.github.run import short

PREFIX = "buildcache"
"""Beginning of the cache's tags, which lie beside the image's own."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Layers:
    """Values of buildx's ``--cache-from`` and ``--cache-to``."""

    read: tuple[str, ...] = ()
    write: tuple[str, ...] = ()
    reason: str = ""


def layers(event: Event, publication: Publication, wish: Cache, *, image: str, part: str, variant: str = "") -> Layers:
    """Decide the layer cache of one build.

    ``part`` tells the builds of one image apart (a platform, ``all`` for one build of several), ``variant`` the calls
    that build it in several ways. A branch reads its own
    cache, then the default branch's; only a run that publishes writes, and only its own branch's, so that a pull
    request cannot put a layer under anybody's next release. A release's tag reads nothing at all
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


def _reference(image: str, branch: str, part: str, variant: str) -> str:
    """Return a tag that no other branch or variant has, although a tag holds fewer characters than a branch's name.

    It has at most 128: https://github.com/distribution/reference/blob/main/regexp.go.
    """
    name = re.sub(r"[^A-Za-z0-9_.-]+", "-", branch)[:80]
    return f"type=registry,ref={image}:{PREFIX}-{name}-{short(branch, variant)}-{part}"
