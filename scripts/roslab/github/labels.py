"""The labels of an image, which are its annotations too: its name, its commit and that commit's time."""

from __future__ import annotations

import datetime as dt
import re

from roslab.github.event import Event
from roslab.plan.plan import Plan

PREFIX = "org.opencontainers.image"
"""https://github.com/opencontainers/image-spec/blob/main/annotations.md"""
LONGEST = 512
"""Most characters of a description that GitHub shows:
https://docs.github.com/en/packages/working-with-a-github-packages-registry/working-with-the-container-registry"""


def labels(plan: Plan, event: Event, *, revision: str, seconds: int | None) -> tuple[tuple[str, str], ...]:
    """Return the labels; none has the time of the build, so that two builds of a commit can be identical.

    Only the description and the licence are not the commit's, but what GitHub says of the repository. ``revision`` is
    the commit that was checked out, ``seconds`` its time since 1970.
    """
    found = {
        "title": plan.name,
        "description": event.description[:LONGEST],
        "licenses": event.licence,
        "url": f"{event.server}/{event.repository}",
        "source": f"{event.server}/{event.repository}",
        "revision": revision or event.sha,
        "version": event.tag or event.branch or (f"pr-{event.pull}" if event.pull else ""),
        "base.name": plan.base_image,
        "created": timestamp(seconds) if seconds is not None else "",
    }
    # buildx reads one label per line, as CSV: a quote or a line break would end the value
    return tuple((f"{PREFIX}.{key}", re.sub(r'[\s"]+', " ", value).strip()) for key, value in found.items() if value)


def timestamp(seconds: int) -> str:
    """Return a time in UTC in the format of RFC 3339."""
    return dt.datetime.fromtimestamp(seconds, tz=dt.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
