"""What the setup.py of ament's packages of nodes asks pip for: colcon installs such a package without it."""

from __future__ import annotations

from collections.abc import Iterator, Set

from roslab.config.model import Kind
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import ros_modules, same_module
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def of_nodes(evidence: Evidence, kind: Kind, known: Set[str]) -> Iterator[Requirement]:
    """Yield what ``install_requires`` of packages that are built names, and pip alone has.

    What apt has too comes from there, by the code's imports; names of no table may be packages of ROS.
    """
    if kind != "ros2":
        return
    pip = {canonicalize_name(name): module for module, (name, apt) in imports().items() if name and not apt}
    built = packages_of(evidence).built
    folders = {manifest.file.rpartition("/")[0] for manifest in built}
    keys = {each.name.removesuffix("-pip") for manifest in built for each in manifest.dependencies}
    done = set(known)
    for project in evidence.python:
        for asked in project.requirements if project.folder in folders and not project.installable else ():
            theirs = asked.key not in pip or pip[asked.key] in ros_modules() or f"python3-{asked.key}" in keys
            there = any(same_module(asked.key, name) for name in done) or asked.key in done
            if asked.role == "" and not (theirs or there or asked.url):
                done.add(asked.key)
                yield asked
