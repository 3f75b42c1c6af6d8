"""Packages of the tree that the author's Dockerfile, where that is built, copies and does not build."""

from __future__ import annotations

from roslab.decide.author_command import of_system
from roslab.decide.candidate import Candidate, is_component
from roslab.decide.chains import local_bases
from roslab.evidence.facts import AuthorDockerfile, Evidence

_AT = {"roslaunch": 1, "rosrun": 1, "ros2": 2}


def unbuilt(evidence: Evidence, authored: AuthorDockerfile) -> frozenset[str]:
    """Return the names of the packages that no step builds; a base that somebody made may have any of them."""
    if authored.built is None or not of_system(authored.base or "") or authored.file in local_bases(evidence):
        return frozenset()
    released = {each.name.split("-", 2)[-1] for each in authored.dependencies if each.name.startswith("ros-")}
    return frozenset(
        each.name
        for each in evidence.manifests
        if each.name
        and {each.name, each.file.rpartition("/")[0]}.isdisjoint(authored.built)
        and each.name.replace("_", "-") not in released
    )


def starts_one(candidate: Candidate, packages: frozenset[str]) -> bool:
    """Tell whether a command starts a node or a launch file of one of these packages."""
    at = _AT.get(candidate.argv[0])
    return at is not None and bool(packages.intersection(candidate.argv[at + is_component(candidate.argv) :][:1]))
