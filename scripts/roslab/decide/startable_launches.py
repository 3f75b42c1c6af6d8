"""Which launch files can start what they name: those that nobody mentions are worth a guess only where they can."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from collections.abc import Set as AbstractSet
from functools import cache

from roslab.decide.ros.source_names import plain
from roslab.evidence.dependency import Dependency
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
    distribution or table knows; what a page or a list clones may hold it, and then all may start. So do those that
    include a launch file which a package of the tree does not have, or load a file by a path with a blank in it. What
    sets parameters alone starts nothing. Without ``programs`` of its own, the repository may consist of launch files
    for what others wrote.
    """
    files = {launch.file.rpartition("/")[2] for launch in evidence.launch}
    cloned = any(git.kind not in {"link", "fetch"} for git in evidence.sources)
    cloned = cloned or any(authored.clones for authored in evidence.dockerfiles)
    lacking = {} if cloned else lacks(evidence, lambda _: False)
    own = _of_tree(evidence)
    return frozenset(
        launch.file
        for launch in evidence.launch
        if launch.file in lacking
        or launch.gone
        or launch.to_fill
        or launch.idle
        or (programs and _of_others(launch, own, files))
    )


def lacks(
    evidence: Evidence, may_hold: Callable[[str], bool], ros_distro: str | None = None, *, asked: bool = True
) -> dict[str, tuple[Dependency, ...]]:
    """Return the packages that launch files need, whatever their arguments are, and nothing brings, by the file's path.

    Also those that what they start needs. ``may_hold``: whether something that is cloned may hold a package of a name;
    ``ros_distro``: the distribution that has to have it, else any. ``asked``: what a package.xml asks for is there.
    """
    has = released(ros_distro or "").__contains__ if released(ros_distro or "") else ever_released
    keys = _asked(evidence)
    ours = _of_tree(evidence) | (keys if asked else set())
    families = {ros: _families(frozenset(keys), ros) for ros in (1, 2)}
    found = {
        launch.file: tuple(_lacking(launch, ours, families[launch.ros], may_hold, has, ros_distro=ros_distro or ""))
        for launch in evidence.launch
    }
    return {file: names for file, names in found.items() if names}


def _lacking(
    launch: LaunchFile,
    ours: AbstractSet[str | None],
    families: frozenset[str],
    may_hold: Callable[[str], bool],
    has: Callable[[str], bool],
    *,
    ros_distro: str,
) -> Iterator[Dependency]:
    for asked in (*launch.dependencies, *launch.reached):
        if asked.namespace != "ros" or asked.strength == "optional" or asked.name in ours:
            continue
        if has(asked.name) or ros_sources(asked.name, launch.ros, ros_distro):
            continue
        if asked.name.partition("_")[0] not in families and not may_hold(asked.name):
            yield asked


def _of_others(launch: LaunchFile, own: AbstractSet[str | None], files: AbstractSet[str]) -> bool:
    """Tell whether a launch file names packages and none of the repository's, nor another of its launch files.

    One in Python is a program, which may name its package in ways that are not seen.
    """
    named = {asked.name for asked in launch.dependencies if asked.namespace == "ros"}
    python = launch.file.endswith(".py")
    others = {name for _, name in launch.includes} - {launch.file.rpartition("/")[2]}
    return bool(named) and not (python or named & (own | {launch.package}) or files & others)


def _of_tree(evidence: Evidence) -> set[str | None]:
    return {manifest.name for manifest in evidence.manifests}


def _asked(evidence: Evidence) -> set[str]:
    return {dependency.name for manifest in evidence.manifests for dependency in manifest.dependencies}


@cache
def _families(asked: frozenset[str], ros: int) -> frozenset[str]:
    """Return the first words of the repositories that the table has for what is asked: they may hold more packages."""
    found = (each.repo for name in asked for each in ros_sources(name, ros))
    return frozenset(plain(repo.removesuffix(".git")).partition("_")[0] for repo in found)
