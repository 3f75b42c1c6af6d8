"""Nodes of ROS in Python beside what the image is for: it has no ROS that they would start with."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.decide.ros.without_manifest import CLIENTS
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_ROS = pattern(r"(?<![a-z])ros(?![a-z])")
"""How the name of an image tells that it has ROS."""


def decide_nodes(evidence: Evidence, config: Config, kind: Kind, base: str) -> Choice[None]:
    """Return a warning for the nodes of a tree whose image, from this ``base``, has no ROS.

    Not where conda, pip or the base brings it.
    """
    used = [each for each in evidence.code if each.namespace == "import" and each.strength == "used"]
    client = next((each.name for each in used if each.name in CLIENTS and not places.vendored(each.file)), None)
    nodes = [each for each in evidence.programs if each.kind == "node" and not places.aside(each.file)]
    if not client or not nodes or kind in {"ros1", "ros2"} or config.compatible or _ROS.search(base):
        return Choice(answer=None)
    if any(package.name.startswith(("ros-", "ros2-")) for each in evidence.conda for package in each.packages):
        return Choice(answer=None)
    others = f" and {len(nodes) - 1} other program{'s' * (len(nodes) > 2)}" if len(nodes) > 1 else ""
    message = f"{nodes[0].file}{others} cannot start: the image has no ROS, which {client} is of"
    hint = f"`kind: {CLIENTS[client]}` in roslab.yaml makes an image with it"
    return Choice(answer=None, warnings=(warn(f"{message}; {hint}", nodes[0]),))
