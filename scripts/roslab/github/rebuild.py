"""Building an old commit or git tag of the caller instead of the event's: the names of its image."""

from __future__ import annotations

import re

from roslab.github.event import Event
from roslab.github.tags import RELEASE
from roslab.values.dataclass import replace

TAG = "refs/tags/"


def event_of(what: Event, rebuilt: str | None, revision: str) -> Event:
    """Return the event, changed to describe the commit that is built.

    ``rebuilt`` is the full name of that commit's git tag, ``""`` if it has none, ``None`` if the event's own commit is
    built.
    """
    return what if rebuilt is None else replace(what, ref=rebuilt, sha=revision)


def names(what: Event, image: str) -> str:
    """Return the references that an old commit gets, one per line: the commit's own, and its git tag's."""
    found = [f"sha-{what.sha[:7]}"]
    if what.tag:
        found.insert(0, re.sub(r"[^a-zA-Z0-9._-]+", "-", what.tag)[:128])
        if release := RELEASE.fullmatch(what.tag):
            major, minor, patch = release.groups()
            found += [f"{major}.{minor}.{patch}", f"{major}.{minor}"]
    return "\n".join(f"{image}:{name}" for name in dict.fromkeys(found))
