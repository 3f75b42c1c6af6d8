"""Which launch files can start what they name: those that nobody mentions are worth a guess only where they can."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from functools import cache

from roslab.decide.ros.source_names import plain
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.distros import distros
from roslab.knowledge.released import ever_released, released
from roslab.knowledge.ros_sources import ros_sources


def known(launch: LaunchFile, evidence: Evidence) -> bool:
    """Tell whether one distribution released all packages that a launch file starts, but for those of the tree.

    Those that a package.xml asks for count as the tree's.
    """
    asked = _of_tree(evidence) | _asked(evidence)
    started = {dependency.name for dependency in launch.dependencies if dependency.namespace == "ros"} - asked
    return not started or any(started <= released(name) for name in distros())


def unstartable(evidence: Evidence, *, programs: bool) -> frozenset[str]:
    """Return the launch files that stop at once, or that start nothing of the repository; their paths.

    Those stop that need, without a condition, a package which neither the tree has, nor a package.xml asks for, nor any
    distribution or table knows; what a page or a list clones may hold it, and then all may start. Without ``programs``
    of its own, the repository may consist of launch files for what others wrote.
    """
    cloned = any(git.kind not in {"link", "fetch"} for git in evidence.sources)
    cloned = cloned or any(authored.clones for authored in evidence.dockerfiles)
    files = {launch.file.rpartition("/")[2] for launch in evidence.launch}
    own, asked = _of_tree(evidence), _asked(evidence)
    families = {ros: _families(frozenset(asked), ros) for ros in (1, 2)}
    return frozenset(
        launch.file
        for launch in evidence.launch
        if (not cloned and _lacks(launch, own | asked, families[launch.ros]))
        or (programs and _of_others(launch, own, files))
    )


def _lacks(launch: LaunchFile, ours: AbstractSet[str | None], families: frozenset[str]) -> bool:
    """Tell whether a launch file needs, whatever its arguments are, a package that nothing brings."""
    return any(
        asked.namespace == "ros"
        and asked.strength != "optional"
        and not (asked.name in ours or ever_released(asked.name) or ros_sources(asked.name, launch.ros))
        and asked.name.partition("_")[0] not in families
        for asked in launch.dependencies
    )


def _of_others(launch: LaunchFile, own: AbstractSet[str | None], files: AbstractSet[str]) -> bool:
    """Tell whether a launch file names packages and none of the repository's, nor another of its launch files.

    One in Python is a program, which may name its package in ways that are not seen.
    """
    named = {asked.name for asked in launch.dependencies if asked.namespace == "ros"}
    python = launch.file.endswith(".py")
    return bool(named) and not (python or named & (own | {launch.package}) or files & {*launch.includes})


def _of_tree(evidence: Evidence) -> set[str | None]:
    return {manifest.name for manifest in evidence.manifests}


def _asked(evidence: Evidence) -> set[str]:
    return {dependency.name for manifest in evidence.manifests for dependency in manifest.dependencies}


@cache
def _families(asked: frozenset[str], ros: int) -> frozenset[str]:
    """Return the first words of the repositories that the table has for what is asked: they may hold more packages."""
    found = (each.repo for name in asked for each in ros_sources(name, ros))
    return frozenset(plain(repo.removesuffix(".git")).partition("_")[0] for repo in found)
