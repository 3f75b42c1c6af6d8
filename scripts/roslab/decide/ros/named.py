"""What pages tell the build tool: the packages to build (what else a clone holds stays out), the number of jobs."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import takewhile

from roslab.config.model import BuildTool, Config, Source
from roslab.decide.decision import ByPages
from roslab.decide.ros.build_tool import OF_ROS1
from roslab.decide.ros.part_builds import builds, ends_whole
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages, names_of
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released, rosdep_keys
from roslab.values.pattern import pattern

_LIMIT = pattern(r"\s(?:-j|--jobs)[ =]?([1-9]\d?)(?=\s|$)")
_NO_BUILD = pattern(r"catkin\s+(?:init|config)\b")
UP_TO = "--packages-up-to"
"""https://colcon.readthedocs.io/en/released/reference/package-selection-arguments.html"""


def by_pages(
    evidence: Evidence,
    config: Config,
    build_tool: BuildTool,
    *,
    packages: Packages,
    left_out: Collection[str],
    sources: Iterable[Source],
    ros_distro: str | None,
    needed: Collection[str],
) -> ByPages:
    """Return what the pages at the root tell; roslab.yaml's ``build_args`` are told in their place.

    ``needed``: packages without which the default command does not start.
    """
    if config.compatible or config.build_args:
        return ByPages()
    own = names_of(packages, "ros2" if build_tool == "colcon" else "ros1", left_out, build_tool)
    cloned = {plain(source.name): source.name for source in sources if source.build == build_tool}
    some = cloned and not ends_whole(builds(evidence, build_tool))
    known = _known(packages, ros_distro) | {*own}
    started = {*needed, *_launched(evidence)}
    named = _named(evidence, build_tool, own=own, cloned=cloned, started=started - known) if some else ()
    return ByPages(packages=named, jobs=_jobs(evidence, build_tool))


def _jobs(evidence: Evidence, build_tool: BuildTool) -> int | None:
    """Return the most jobs that a page gives a tool of catkin, which takes all cores by itself: code may need fewer.

    ``None`` where a page builds without a limit too.
    """
    if build_tool not in OF_ROS1:
        return None
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == build_tool)
    lines = [m.text for m in said if m.source == "readme" and "/" not in m.file and not _NO_BUILD.match(m.text)]
    limits = [_LIMIT.search(line) for line in lines]
    return max((int(limit[1]) for limit in limits if limit), default=None) if all(limits) else None


def _named(
    evidence: Evidence,
    build_tool: BuildTool,
    *,
    own: tuple[str, ...],
    cloned: Mapping[str, str],
    started: Collection[str],
) -> tuple[str, ...]:
    """Return the repository's packages, and the clones that a page at the root has built; ``()`` for all.

    The build tool builds what these need, too, and nothing else of the clones: their tools and bindings may need
    packages that nobody asked for. All is built where the default command or a launch file starts a package of a clone
    that no package.xml names: ``started``.
    """
    said = tuple(_said(evidence, build_tool))
    if not {*said} & {*own}:
        return ()
    sisters = tuple(dict.fromkeys(name for name in said if name not in own and cloned.get(plain(name)) == name))
    return () if {*started} - {*sisters} else (*own, *sisters)


def _known(packages: Packages, ros_distro: str | None) -> frozenset[str]:
    """Return the packages that are there whichever clones are built, and those that are built for a package.xml."""
    asked = (dependency.name for manifest in packages.built for dependency in manifest.dependencies)
    return frozenset((*packages.names, *asked)) | released(ros_distro or "") | rosdep_keys()


def _launched(evidence: Evidence) -> Iterator[str]:
    for launch in evidence.launch:
        yield from (each.name for each in launch.dependencies if each.namespace == "ros")


def _said(evidence: Evidence, build_tool: BuildTool) -> Iterator[str]:
    """Yield the packages after ``catkin build`` or ``colcon build --packages-up-to`` on the pages at the root."""
    for mention in evidence.mentions:
        if mention.topic != "build_tool" or mention.source != "readme" or "/" in mention.file:
            continue
        words = mention.text.split()
        if build_tool == "catkin_tools" and words[:1] == ["catkin"] and words[1:2] in (["build"], ["b"]):
            yield from takewhile(_is_name, words[2:])
        elif build_tool == "colcon" and words[:2] == ["colcon", "build"] and UP_TO in words:
            yield from takewhile(_is_name, words[words.index(UP_TO) + 1 :])


def _is_name(word: str) -> bool:
    return not word.startswith("-")
