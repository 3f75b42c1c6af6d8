"""The build tool for ROS 1: by what people type to build, and by what the packages need."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from typing import ClassVar

from roslab.config.model import WORKSPACE_TOOLS, BuildTool, WorkspaceTool
from roslab.decide.decision import Choice, Reason
from roslab.decide.programs import configured_by
from roslab.decide.reasons import because, ranked, strongest
from roslab.decide.ros.source_names import wraps
from roslab.decide.ros.without_manifest import by_cmake
from roslab.decide.ros.workspace import of_one_ros, of_rosbuild, packages_of, ros_versions, types
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import distros

OF_ROS1: tuple[WorkspaceTool, ...] = tuple(tool for tool in WORKSPACE_TOOLS if tool != "colcon")
"""The tools of catkin; colcon is taken where somebody builds with it and with none of these."""


class Weight:
    """How much each reason for a tool counts, by who uses it and where."""

    MENTION: ClassVar = {
        "dockerfile": 420,  # this code was built that way
        "readme": 400,
        "ci": 380,  # CI often builds in other ways than people
        "script": 300,
    }
    ELSEWHERE = 100
    ROSBUILD = 500  # nothing else builds them
    PLAIN_CMAKE = 350  # catkin_make refuses plain CMake packages: wins over a script, not over what people type
    SAME_TARGETS = 410  # catkin_make stops there, whatever a page says; what a Dockerfile built is read better there
    LEFT = 375  # what the author's own build left: over the pages of folders, not over what people type at the root
    CATKIN_SIMPLE = 250  # its authors build with catkin_tools, but catkin_make can often build it too
    DEFAULT = 1
    DEEPER = 30  # subtracted for each folder above it: deeper files are about a part
    DEEPER_DOCKERFILE = 5  # subtracted for a Dockerfile instead, which often has its own folder
    VENDORED = 200  # subtracted for a file copied from another project
    DOCUMENTATION = 50
    ISOLATED = 100  # an isolated build is what CI runs


def tool_of_ros1(evidence: Evidence) -> Choice[BuildTool]:
    """Return the tool, with the reasons for both."""
    if by_itself := alone(evidence):
        return by_itself
    if old := next(filter(of_rosbuild, packages_of(evidence).built), None):
        why = "its packages have a manifest.xml, from before catkin"
        return Choice(answer="rosmake", reasons=(because("build_tool", "rosmake", why, old, weight=Weight.ROSBUILD),))
    copied = {authored.file for authored in evidence.dockerfiles if authored.purpose == "vendored"}
    reasons = [
        because("build_tool", mention.value, mention.text[:120], mention, weight=_weight(mention, copied))
        for mention in evidence.mentions
        if mention.topic == "build_tool" and mention.value in OF_ROS1
    ]
    for left in (mention for mention in evidence.mentions if mention.topic == "built_by"):
        weight = Weight.LEFT - Weight.DEEPER * left.file.count("/")
        reasons.append(because("build_tool", left.value, left.text, left, weight=weight))
    if not reasons and (said := _colcon(evidence)):
        reasons.append(because("build_tool", "colcon", said.text[:120], said, weight=_weight(said)))
        return Choice(answer="colcon", reasons=tuple(reasons))
    one_by_one = _one_by_one(reasons)
    if plain := next((m for m in packages_of(evidence).built if types(m, 1) == {"cmake"}), None):
        why = "a plain CMake package, which catkin_make refuses"
        reasons.append(because("build_tool", one_by_one, why, plain, weight=Weight.PLAIN_CMAKE))
    if simple := next(_simple(evidence), None):
        why = f"it uses {simple.name}, whose authors build with catkin_tools"
        reasons.append(because("build_tool", one_by_one, why, simple, weight=Weight.CATKIN_SIMPLE))
    if not reasons:
        reasons.append(because("build_tool", "catkin_make", "ROS 1's own", weight=Weight.DEFAULT))
    if strongest(reasons).answer == "catkin_make" and (twice := same_targets(evidence)):
        why = f"two packages have a CMake target `{twice[0]}`, at which one catkin_make stops"
        reasons.append(because("build_tool", "catkin_make_isolated", why, twice[1], weight=Weight.SAME_TARGETS))
    best = strongest(reasons).answer
    answer: BuildTool = next((tool for tool in OF_ROS1 if tool == best), "catkin_make")
    return Choice(answer=answer, reasons=ranked(reasons, answer))


def alone(evidence: Evidence) -> Choice[BuildTool] | None:
    """Return CMake for a tree without a package.xml whose CMake requires packages of ROS, ``None`` for others."""
    made = by_cmake(evidence)
    if made is None:
        return None
    why = f"no package.xml, so that {'catkin' if made[1] == 'ros1' else 'colcon'} finds no package: CMake alone"
    said = because("build_tool", "cmake", why, made[0], weight=Weight.PLAIN_CMAKE)
    return Choice(answer="cmake", reasons=(said,))


def same_targets(evidence: Evidence) -> tuple[str, CMakeProject] | None:
    """Return a name that is a target of two packages, with the second file that makes it, if there is any."""
    built = of_one_ros(packages_of(evidence), evidence, "ros1").built
    folders = {manifest.file.rpartition("/")[0]: manifest.name for manifest in built}
    owners: dict[str, str] = {}
    for project in evidence.cmake:
        package = configured_by(project, folders)
        for name in project.targets if package else ():
            if owners.setdefault(name, str(package)) != package:
                return name, project
    return None


def _one_by_one(reasons: Sequence[Reason]) -> WorkspaceTool:
    """Return the tool that builds each package by itself: what people type, catkin_tools where nobody types either."""
    alone = [reason for reason in reasons if reason.answer in {"catkin_make_isolated", "catkin_tools"}]
    isolated = bool(alone) and strongest(alone).answer == "catkin_make_isolated"
    return "catkin_make_isolated" if isolated else "catkin_tools"


def _simple(evidence: Evidence) -> Iterator[Dependency]:
    """Yield where catkin_simple is asked for, or a wrapper of a library for catkin (``yaml_cpp_catkin``).

    In the one project that catkin_make makes of all packages such a wrapper does not find its own files.
    """
    declared = [dependency for manifest in packages_of(evidence).built for dependency in manifest.dependencies]
    found = [dependency for project in evidence.cmake for dependency in project.dependencies]
    yield from (d for d in (*declared, *found) if d.name == "catkin_simple" or wraps(d.name))


def _colcon(evidence: Evidence) -> Mention | None:
    """Return where somebody builds with colcon, in a repository of which nothing is for ROS 2, whose tool it is."""
    named = {m.value for m in evidence.mentions if m.topic == "distro"}
    if any(found.ros == 2 and name in named for name, found in distros().items()):
        return None
    if any(2 in ros_versions(manifest) for manifest in packages_of(evidence).built):
        return None
    said = [m for m in evidence.mentions if m.topic == "build_tool" and m.value == "colcon" and m.source != "script"]
    return max(said, key=_weight, default=None)


def _weight(mention: Mention, copied: Container[str] = ()) -> int:
    """Return how much it counts where a tool is named; ``copied``: Dockerfiles of other projects in the tree."""
    weight = Weight.MENTION.get(mention.source, Weight.ELSEWHERE)
    deeper = Weight.DEEPER_DOCKERFILE if mention.source == "dockerfile" else Weight.DEEPER
    weight -= deeper * mention.file.count("/")
    weight -= Weight.VENDORED if places.vendored(mention.file) or mention.file in copied else 0
    weight -= Weight.DOCUMENTATION if places.documentation(mention.file) else 0
    return weight - (Weight.ISOLATED if "isolated" in mention.text else 0)
