"""What shows the kind of a repository that has neither a manifest nor code of Python, nor a file of CMake or make."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import WORKSPACE_TOOLS
from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.octave import file_of
from roslab.knowledge.distros import distro
from roslab.knowledge.other_builders import of_cpp

BUILT_BY_ROS, OTHER_BUILDER, BY_OCTAVE = 300, 80, 70
"""Weights of the reasons, in the order in which they count."""


def last_signs(evidence: Evidence) -> Iterator[Reason]:
    """Yield the kinds that build tools without a file of their own tell, and programs that no kind is for."""
    yield from _built_by_ros(evidence)
    included = any(found.namespace == "include" for found in evidence.code)
    for said in evidence.mentions:
        if said.topic == "other_builder" and said.value in of_cpp() and included:
            yield because("kind", "cpp", f"C++, which {said.value} builds", said, weight=OTHER_BUILDER)
        elif file_of(said):
            why = "a program of Octave, which the page runs, and nothing to build"
            yield because("kind", "python", why, said, weight=BY_OCTAVE)


def _built_by_ros(evidence: Evidence) -> Iterator[Reason]:
    """Yield the ROS whose distribution and build tool the text names, of a tree that holds no code of its own.

    Its scripts fetch what is built, or its links lead there.
    """
    tools = [m for m in evidence.mentions if m.topic == "build_tool" and m.value in WORKSPACE_TOOLS]
    sides = [found.ros for m in evidence.mentions if m.topic == "distro" and (found := distro(m.value))]
    if tools and len({*sides}) == 1:
        why = f"nothing of its own is compiled; {tools[0].value} builds it, and a ROS {sides[0]} distribution is named"
        yield because("kind", f"ros{sides[0]}", why, tools[0], weight=BUILT_BY_ROS)
