"""Headers of the Ubuntu that the code includes together although they contradict each other."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.header_links import header_links


def linked_headers(evidence: Evidence, ubuntu: str | None) -> tuple[tuple[str, str], ...]:
    """Return the headers that links take the place of, each with the one that its link leads to."""
    included = [d.name for d in evidence.code if d.namespace == "include" and not places.vendored(d.file)]
    return tuple(
        (link.file, link.instead)
        for link in header_links()
        if link.ubuntu == ubuntu
        and any(name.startswith(link.one) for name in included)
        and any(name.startswith(link.other) for name in included)
    )
