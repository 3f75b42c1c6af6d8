"""Installations that a page leaves to the page of another repository of the same owner, which nobody read."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import address
from roslab.evidence.facts import Evidence

MOST = 3


def told(evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for each such repository; a link to somebody else's is a tool or a library."""
    own = _repository(evidence.origin)
    seen: set[str] = set()
    for mention in evidence.mentions:
        there = _repository(mention.value) if mention.topic == "guide" else ""
        same_owner = own and there.rpartition("/")[0] == own.rpartition("/")[0]
        if not same_owner or there in {own, *seen} or len(seen) == MOST:
            continue
        seen.add(there)
        message = (
            f"{mention.file} leaves the installation to {mention.value}, which was not read: what it has its readers "
            "install is in the image only where a file here asks for it by name; put the rest under `apt`, `pip` or "
            "`source` in roslab.yaml"
        )
        yield warn(message, mention)


def _repository(url: str) -> str:
    """Return the host, the owner and the name that an address begins with, in one spelling."""
    parts = address(url.partition("#")[0].partition("?")[0]).partition("://")[2].split("/")
    return "/".join(parts[:3]).removesuffix(".git").removeprefix("www.")
