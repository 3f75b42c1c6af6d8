"""Dockerfiles for other distributions than the chosen one, beside the author's own for that."""

from __future__ import annotations

from roslab.decide.ros.vcs_files import distros_in
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.distros import distros
from roslab.values.dataclass import replace


def distros_of(authored: AuthorDockerfile, evidence: Evidence) -> frozenset[str]:
    """Return the distributions in the name of a Dockerfile's base, else the one that its first line names which does.

    An image of CUDA has none in its name: ROS is installed on it by ``ARG ROS_DISTRO=humble``.
    """
    if named := distros_in(authored.base or ""):
        return frozenset(named)
    said = (m for m in evidence.mentions if m.topic == "distro" and m.source == "dockerfile")
    lines = sorted((m.line or 0, m.value) for m in said if m.file == authored.file and m.value in distros())
    return frozenset(name for _, name in lines[:1])


def without_their_clones(evidence: Evidence, distro: str | None) -> Evidence:
    """Return the evidence without what Dockerfiles for other distributions clone, if one is for the chosen one.

    Their branches and forks are for those. Of the CUDA of several the first counts, so they come last.
    """
    if distro is None or len(evidence.dockerfiles) == 1:
        return evidence
    of = {each.file: distros_of(each, evidence) for each in evidence.dockerfiles}
    if not any(distro in names for names in of.values()):
        return evidence
    others = {file for file, names in of.items() if names and distro not in names}
    if not others:
        return evidence
    first = (each for each in evidence.dockerfiles if each.file not in others)
    last = (replace(each, clones=()) for each in evidence.dockerfiles if each.file in others)
    return replace(evidence, dockerfiles=(*first, *last))
