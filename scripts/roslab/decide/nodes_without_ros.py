"""Nodes of ROS in Python beside what the image is for: it has no ROS that they would start with."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.base import BaseImage
from roslab.decide.decision import Choice
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import warn
from roslab.decide.ros.without_manifest import CLIENTS
from roslab.decide.system.ubuntu_ros import of_ros1_alone, ubuntu_brings
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_ROS = pattern(r"(?<![a-z])ros(?![a-z])")
"""How the name of an image tells that it has ROS."""


def decide_nodes(evidence: Evidence, config: Config, kind: Kind, base: BaseImage, python: Python) -> Choice[None]:
    """Return a warning for the nodes of a tree whose image, from this ``base`` and with this Python, has no ROS.

    And for the first module that needs what ROS 1 alone has beside its client library, where its Ubuntu brings none.
    Not where conda, pip or the base brings it.
    """
    used = [each for each in evidence.code if each.namespace == "import" and each.strength == "used"]
    client = next((each.name for each in used if each.name in CLIENTS and not places.vendored(each.file)), None)
    nodes = [each for each in evidence.programs if each.kind == "node" and not places.aside(each.file)]
    tool = None if ubuntu_brings(python, base.ubuntu) else of_ros1_alone(evidence)
    if not ((client and nodes) or tool) or kind in {"ros1", "ros2"} or config.compatible or _ROS.search(base.image):
        return Choice(answer=None)
    if any(package.name.startswith(("ros-", "ros2-")) for each in evidence.conda for package in each.packages):
        return Choice(answer=None)
    by_pip = _by_pip(evidence, python)
    if not (client and nodes) and tool:
        message = f"{tool.file} stops at its import of {tool.name}: the image has no ROS 1, which alone has it"
        hint = "`kind: ros1` in roslab.yaml makes an image with it"
        return Choice(answer=None, warnings=() if tool.name in by_pip else (warn(f"{message}; {hint}", tool),))
    if client is None or not by_pip.isdisjoint({client, f"{client}-all"}):
        return Choice(answer=None)
    others = f" and {len(nodes) - 1} other program{'s' * (len(nodes) > 2)}" if len(nodes) > 1 else ""
    message = f"{nodes[0].file}{others} cannot start: the image has no ROS, which {client} is of"
    hint = f"`kind: {CLIENTS[client]}` in roslab.yaml makes an image with it"
    return Choice(answer=None, warnings=(warn(f"{message}; {hint}", nodes[0]),))


def _by_pip(evidence: Evidence, python: Python) -> set[str]:
    """Return the names of what pip installs: it has ROS's libraries where it is given an index that holds them."""
    files = {*python.requirements, *python.manifests}
    folders = set(python.projects).difference(python.alone)
    asked = [*python.pip, *python.pip_guessed]
    asked += [each for file in evidence.requirements if file.file in files for each in file.requirements]
    asked += [each for one in evidence.conda if one.file == python.conda_file for each in one.requirements]
    asked += [each for one in evidence.python if (one.folder or ".") in folders for each in one.requirements]
    return {each.key for each in asked if not each.group}
