"""catkin_make or catkin_tools: what people type to build a workspace of ROS 1, and what its packages need."""

from __future__ import annotations

from typing import ClassVar

from roslab.config.model import BuildTool
from roslab.decide.decision import Choice
from roslab.decide.reasons import because, ranked, strongest
from roslab.decide.ros.workspace import packages_of, types
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.values.origin import Place


class Weight:
    """What speaks for a tool, by who typed it and where."""

    MENTION: ClassVar = {
        "dockerfile": 420,  # it built this code
        "readme": 400,
        "ci": 380,  # hardly ever what people do
        "script": 300,
    }
    ELSEWHERE = 100
    PLAIN_CMAKE = 350  # catkin_make refuses it: more than a script, less than what people type
    CATKIN_SIMPLE = 250  # its authors build with catkin_tools; catkin_make knows it too
    DEFAULT = 1
    DEEPER = 30  # what a folder deeper in the tree takes off: it tells of a part
    DEEPER_DOCKERFILE = 5  # Dockerfiles have folders of their own
    VENDORED = 200  # what it takes off that others wrote the page
    DOCUMENTATION = 50
    ISOLATED = 100  # an isolated build is what CI runs


def tool_of_ros1(evidence: Evidence) -> Choice[BuildTool]:
    """Return the tool with everything that speaks for either."""
    reasons = [
        because("build_tool", mention.value, mention.text[:120], mention, weight=_weight(mention))
        for mention in evidence.mentions
        if mention.topic == "build_tool" and mention.value in {"catkin_make", "catkin_tools"}
    ]
    if plain := next((m for m in packages_of(evidence).built if types(m, 1) == {"cmake"}), None):
        why = "a plain CMake package, which catkin_make refuses"
        reasons.append(because("build_tool", "catkin_tools", why, plain, weight=Weight.PLAIN_CMAKE))
    simple = next((p for p in evidence.cmake for d in p.dependencies if d.name == "catkin_simple"), None)
    if simple:
        why = "it uses catkin_simple, whose authors build with catkin_tools"
        place = Place(file=simple.file, line=1)
        reasons.append(because("build_tool", "catkin_tools", why, place, weight=Weight.CATKIN_SIMPLE))
    if not reasons:
        reasons.append(because("build_tool", "catkin_make", "ROS 1's own", weight=Weight.DEFAULT))
    answer: BuildTool = "catkin_tools" if strongest(reasons).answer == "catkin_tools" else "catkin_make"
    return Choice(answer=answer, reasons=ranked(reasons, answer))


def _weight(mention: Mention) -> int:
    weight = Weight.MENTION.get(mention.source, Weight.ELSEWHERE)
    deeper = Weight.DEEPER_DOCKERFILE if mention.source == "dockerfile" else Weight.DEEPER
    weight -= deeper * mention.file.count("/")
    weight -= Weight.VENDORED if places.vendored(mention.file) else 0
    weight -= Weight.DOCUMENTATION if places.documentation(mention.file) else 0
    return weight - (Weight.ISOLATED if "isolated" in mention.text else 0)
