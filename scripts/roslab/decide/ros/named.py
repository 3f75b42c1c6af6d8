"""The packages that catkin_tools is told to build, where a page names them: what else a clone holds stays out."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.config.model import BuildTool, Config, Source
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages, names_of
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released, rosdep_keys


def named(
    evidence: Evidence,
    config: Config,
    build_tool: BuildTool,
    *,
    packages: Packages,
    left_out: Collection[str],
    sources: Iterable[Source],
    ros_distro: str | None,
) -> tuple[str, ...]:
    """Return the repository's packages, and the clones that a page at the root has catkin build; ``()`` for all.

    catkin builds what these need, too, and nothing else of the clones: their tools and bindings may need packages that
    nobody asked for. All is built where a launch file starts a package of a clone that no package.xml names.
    """
    own = names_of(packages, "ros1", left_out)
    cloned = {plain(source.name): source.name for source in sources if source.build == "catkin_tools"}
    said = tuple(_said(evidence)) if cloned and build_tool == "catkin_tools" else ()
    if config.compatible or config.build_args or not {*said} & {*own}:
        return ()
    sisters = tuple(dict.fromkeys(name for name in said if name not in own and cloned.get(plain(name)) == name))
    known = {*own, *sisters, *packages.names} | released(ros_distro or "") | rosdep_keys()
    known |= {dependency.name for manifest in packages.built for dependency in manifest.dependencies}
    named_there = (each for launch in evidence.launch for each in launch.dependencies)
    started = (each.name for each in named_there if each.namespace == "ros")
    return () if any(name not in known for name in started) else (*own, *sisters)


def _said(evidence: Evidence) -> Iterator[str]:
    """Yield the packages after ``catkin build`` on the pages at the root."""
    for mention in evidence.mentions:
        words = mention.text.split()
        of_page = mention.topic == "build_tool" and mention.source == "readme" and "/" not in mention.file
        if of_page and words[:1] == ["catkin"] and words[1:2] in (["build"], ["b"]):
            for word in words[2:]:
                if word.startswith("-"):
                    break
                yield word
