"""Packages that the author's own build leaves out, as its page or its pixi tasks say."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place

_SKIP = frozenset({"--packages-skip", "--packages-ignore"})
"""https://colcon.readthedocs.io/en/released/reference/package-selection-arguments.html"""


def skipped(evidence: Evidence, packages: Packages) -> dict[str, Place]:
    """Return the packages of the tree that a page at the root, or a task of pixi's, has colcon leave out."""
    found: dict[str, Place] = {}
    for text, place in _builds(evidence):
        words = text.split()
        for index, word in enumerate(words):
            after = words[index + 1 :] if word in _SKIP else []
            end = next((position for position, each in enumerate(after) if each.startswith("-")), len(after))
            for name in after[:end]:
                if name in packages.names:
                    found.setdefault(name, place)
    return found


def _builds(evidence: Evidence) -> Iterator[tuple[str, Place]]:
    for mention in evidence.mentions:
        built = mention.topic == "build_tool" and mention.value == "colcon"
        if built and mention.source == "readme" and "/" not in mention.file:
            yield mention.text, Place(file=mention.file, line=mention.line)
    for environment in evidence.conda:
        for name, command, line in environment.tasks:
            if name == "build" and "colcon build" in command and "/" not in environment.file:
                yield command, Place(file=environment.file, line=line)
