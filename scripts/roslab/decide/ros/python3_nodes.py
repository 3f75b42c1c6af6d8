"""Nodes of ROS 1 that are all for Python 3, and import what ROS compiles for its own Python alone, or name no Python.

Before noetic that is Python 2, so what was worked on since noetic is there was most likely written for that one.
"""

from __future__ import annotations

from roslab.decide.decision import Warning_
from roslab.decide.python.only_python3 import only_python3
from roslab.decide.reasons import Placed, warn
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.python.of_python3 import ROLE
from roslab.knowledge.distros import distro, distros
from roslab.knowledge.modules_of_one_python import modules_of_one_python

_OF_ROSPY = "python3-rospkg-modules"
"""What a program for Python 3 needs that imports rospy."""


def with_python3(evidence: Evidence, ros: int, answer: str) -> tuple[str, str, Placed] | None:
    """Return the distribution of ROS 1 whose own Python is 3, why, and the import that another one cannot load.

    That is also one of Python 3's own library, in code of ROS that ROS's own Python runs.

    ``None`` where ``answer`` has Python 3 as well, for other nodes, and for what was last worked on before it was out.
    """
    if ros != 1 or not distros()[answer].python.startswith("2"):
        return None
    found = _import(evidence) or _of_own_library(evidence)
    if found is None:
        return None
    date = dated(evidence)
    having = [each for each in distros().values() if each.ros == 1 and each.python.startswith("3")]
    having = [each for each in having if date is None or each.released <= date.value]
    if not having:
        return None
    best = max(having, key=lambda each: each.preference).name
    if isinstance(found, Mention):
        why = f"code of ROS imports {found.value} of Python 3, which {best} has"
    else:
        why = f"programs for Python 3 import {found.name}, and {best} has it for that"
    return best, f"no distribution is named; {why}", found


def _of_own_library(evidence: Evidence) -> Mention | None:
    """Return an import of what Python 3's own library has, where nothing is for Python 2 and nobody installs it.

    ``python-pathlib`` is the package of the same for Python 2.
    """
    said = next((each for each in evidence.mentions if each.topic == "python3_module"), None)
    old = any(each.topic == "python" and each.value.startswith("2") for each in evidence.mentions)
    if said is None or old:
        return None
    listed = [*evidence.prose_pip, *(each for file in evidence.requirements for each in file.requirements)]
    keys = [*evidence.prose, *(each for manifest in evidence.manifests for each in manifest.dependencies)]
    installed = {each.key for each in listed} | {each.name.removeprefix("python-") for each in keys}
    return None if said.value in installed else said


def not_for_python3(evidence: Evidence, ros_distro: str | None) -> tuple[Warning_, ...]:
    """Return a warning where a distribution with Python 2 has such a module, and every node is for Python 3.

    Not where the package is in the tree or among what is cloned, which is built for the nodes' Python.
    """
    known = distro(ros_distro) if ros_distro else None
    if known is None or known.ros != 1 or not known.python.startswith("2") or not (found := _import(evidence)):
        return ()
    built = {*packages_of(evidence).names, *(plain(source.name) for source in evidence.sources)}
    if not built.isdisjoint(modules_of_one_python()[found.name]):
        return ()
    message = (
        f"{found.name} of ROS {known.name} is compiled for Python {known.python}, and the programs ask for Python 3"
    )
    hint = "where they need its compiled part, they stop; `base.ros: noetic` in roslab.yaml has it for Python 3"
    return (warn(f"{message}: {hint}", found),)


def _import(evidence: Evidence) -> Dependency | None:
    """Return the import of such a module, if a node is for Python 3, and nothing of the tree is for Python 2."""
    if not only_python3(evidence) or not any(each.role == ROLE and each.name == _OF_ROSPY for each in evidence.code):
        return None
    used = (each for each in evidence.code if each.namespace == "import" and each.strength == "used")
    return next((e for e in used if e.name in modules_of_one_python() and not places.aside(e.file)), None)
