"""Compiling a ROS workspace: the tool, its options, and what is made ready in the workspace before."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from posixpath import relpath
from typing import Literal, get_args

from roslab.config.model import Config, Source, WorkspaceTool
from roslab.decide.decision import Decision
from roslab.decide.ros.base_paths import BASE_PATHS
from roslab.decide.ros.linked_install import OPTION
from roslab.decide.ros.source_names import address
from roslab.decide.system.missing import skipping
from roslab.knowledge.cpp_standards import raised
from roslab.knowledge.ros_sources import alone
from roslab.plan.own_options import own_options
from roslab.values.dataclass import dataclass

RosTool = Literal[WorkspaceTool, "rosmake"]
ROS_TOOLS: tuple[RosTool, ...] = get_args(RosTool)
"""Build tools of a ROS workspace."""
WORKSPACE = "ws"
"""The folder of the ROS workspace; as every folder of this module, relative to the home of the image's user."""


_SETUP: dict[RosTool, str] = {
    "catkin_make": "devel/setup.bash",
    "catkin_make_isolated": "devel_isolated/setup.bash",
    "catkin_tools": "devel/setup.bash",
    "rosmake": "setup.bash",
    "colcon": "install/setup.bash",
}


@dataclass(frozen=True, kw_only=True, slots=True)
class RosBuild:
    """Compiling the ROS workspace: the repository's packages, or sisters alone."""

    tool: RosTool
    arguments: tuple[str, ...]
    """For rosmake the packages too, as it builds only those that are named."""
    cmake_options: tuple[str, ...]
    """For all packages: a workspace has one set of them."""
    setup: str
    """The script that makes the compiled workspace known."""
    ignored: tuple[str, ...] = ()
    """Folders of the repository that the tool must not look into."""
    named: tuple[str, ...] = ()
    """Packages that are built with what they need; all of the workspace where none is named."""
    jobs: int | None = None
    """Most compilers that may run at once, where the author says so."""
    unsure: tuple[str, ...] = ()
    """Sisters whose packages are not known before they are cloned: one may have the name of one in the repository."""
    lacking: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """Packages that a clone may bring, each with the folders that the tool must not look into without it."""
    not_there: tuple[str, ...] = ()
    """Folders (``a/b/``) and files of the repository that its packages install, made empty where they are not there."""
    undeclared: bool = False
    """Packages may require others of the workspace that their package.xml does not name."""
    executable: tuple[str, ...] = ()
    """Names of scripts that get the right to be executed where they are installed: ros2 finds no program without it."""
    in_bin: tuple[tuple[str, str], ...] = ()
    """Packages of Python that do not say where their programs go, and ros2 finds them nowhere else: folder and name."""
    raised: tuple[tuple[str, str], ...] = ()
    """Standards of C++ that the Ubuntu's libraries ask for, each with the names of these: cloned packages that need one
    and name an older standard are compiled with this one."""


def ros_build(decision: Decision, config: Config, sisters: tuple[Source, ...], folder: str) -> RosBuild:
    """Return how the workspace is compiled; ``sisters`` are cloned into it, ``folder`` is the repository's."""
    # Where the repository is no package of the workspace, the tool is its sisters', and the options are its cmake's
    tools = (decision.build_tool, *(source.build for source in sisters))
    default: RosTool = "catkin_make" if decision.kind == "ros1" else "colcon"
    tool = next((known for tool in tools for known in ROS_TOOLS if known == tool), default)
    own = decision.build_tool in ROS_TOOLS
    linked = (OPTION,) if decision.by_links else ()
    of_sisters = dict.fromkeys(word for source in sisters for word in shlex.split(source.cmake_options))
    return RosBuild(
        tool=tool,
        arguments=(
            *_of_rosmake(decision),
            *linked,
            *config.build_args,
            *skipping(tool, decision.left_out),
            *_told(decision, folder),
        )
        if own
        else (),
        cmake_options=(*(own_options(decision, config) if own else ()), *of_sisters),
        setup=f"{WORKSPACE}/{_SETUP[tool]}",
        ignored=decision.ignored if own else (),
        named=decision.by_pages.packages if own else (),
        jobs=decision.by_pages.jobs if own else None,
        unsure=() if config.compatible or tool == "rosmake" else tuple(_unsure(sisters)),
        lacking=decision.lacking if own else (),
        not_there=decision.not_there if own else (),
        undeclared=not config.compatible and tool != "rosmake" and (decision.undeclared or bool(sisters)),
        executable=_executable(decision, config) if own and tool == "colcon" else (),
        in_bin=decision.in_bin if own and tool == "colcon" and not config.compatible else (),
        raised=raised(decision.ubuntu) if sisters and not config.compatible and tool != "rosmake" else (),
    )


def _executable(decision: Decision, config: Config) -> tuple[str, ...]:
    """Return the scripts that get the right to be executed, where colcon installs into the workspace's own folder."""
    elsewhere = any(word.startswith("--install-base") for word in config.build_args)
    return () if config.compatible or elsewhere else decision.copied_scripts


def _unsure(sisters: tuple[Source, ...]) -> Iterator[str]:
    """Yield the sisters of which no table knows that their root is the package."""
    single = {address(url) for url in alone()}
    yield from (
        source.name for source in sisters if source.build != "cmake" and address(source.repo or "") not in single
    )


def _told(decision: Decision, folder: str) -> tuple[str, ...]:
    """Return the arguments that tell colcon the packages to which it does not come from the workspace."""
    if not decision.hidden:
        return ()
    first = "." if folder == WORKSPACE and "" not in decision.ignored else "src"
    return (BASE_PATHS, first, *(relpath(f"{folder}/{each}", WORKSPACE) for each in decision.hidden))


def _of_rosmake(decision: Decision) -> tuple[str, ...]:
    if decision.build_tool != "rosmake":
        return ()
    return (*(f"--without={name}" for name in decision.ended), *decision.package_names)
