"""Variables of ROS and of robots that the author's Dockerfiles set, where the image is made without them."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Set as AbstractSet

from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import Distro, distro
from roslab.knowledge.released import released

_MIDDLEWARE = "RMW_IMPLEMENTATION"


def author_variables(
    evidence: Evidence, ros: str | None, authored: str | None, apt: AbstractSet[str]
) -> Iterator[tuple[str, str, str, Mention]]:
    """Yield each with its value, why, and its place; none of which Dockerfiles give different values.

    ``authored``: the Dockerfile that the image is made with, which sets its own; ``apt``: what the image installs, a
    middleware among it: without the one that is named no node starts.
    """
    found: dict[str, dict[str, Mention]] = {}
    for dockerfile in evidence.dockerfiles:
        if dockerfile.purpose in {"project", "ci"} and dockerfile.file != authored:
            for said in dockerfile.environment:
                name, _, value = said.value.partition("=")
                found.setdefault(name, {}).setdefault(value, said)
    known = distro(ros)
    if known is None:
        return
    for name, values in found.items():
        value, said = next(iter(values.items()))
        if len(values) == 1 and (name != _MIDDLEWARE or _there(value, known, apt)):
            yield name, value, "the author's own image sets it", said


def _there(middleware: str, ros: Distro, apt: AbstractSet[str]) -> bool:
    package = f"ros-{ros.name}-{middleware.replace('_', '-')}"
    return middleware == ros.middleware or (middleware in released(ros.name) and package in apt)
