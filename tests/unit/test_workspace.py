"""Where a repository lies in its image and what is compiled there: decided in the plan, only written by render."""

from __future__ import annotations

from typing import Any

import pytest

from roslab.config.model import Config, Custom, Source
from roslab.decide.decision import Decision
from roslab.decide.python.image_python import Python
from roslab.knowledge.distros import distro
from roslab.plan.package_sources import sources_of
from roslab.plan.plan import Plan, make_plan

SISTER = Source(
    name="sister", repo="https://example.org/s.git", ref="v1", build="catkin_tools", cmake_options="-DS='1 2'"
)
LIBRARY = Source(name="library", repo="https://example.org/l.git", ref="v1", cmake_options="-DL=1")
OLD: dict[str, Any] = {"file": "roslab.yaml", "generation": "later", "compatible": "later"}
PAPER: dict[str, Any] = {"file": "roslab.yaml", "generation": "paper", "compatible": "paper"}
HOME = Custom(commands=("make",), as_root=False, chained=False, workdir="home")


def plan(config: Config | None = None, **changes: Any) -> Plan:
    fields: dict[str, Any] = {
        "kind": "ros1",
        "ros_distro": "noetic",
        "ubuntu": "focal",
        "base_image": "ros:noetic-ros-base",
        "build_tool": "catkin_make",
        "python": Python(version="3.8", manager="system"),
        "packages": ("package.xml",),
        "workspace": "overlay",
        **changes,
    }
    return make_plan(Decision(**fields), config or Config(), folder_name="paper")


@pytest.mark.parametrize(
    ("changes", "folder", "setup"),
    [
        ({}, "ws/src/paper", "ws/devel/setup.bash"),
        ({"build_tool": "colcon", "kind": "ros2"}, "ws/src/paper", "ws/install/setup.bash"),
        ({"workspace": "root"}, "ws", "ws/devel/setup.bash"),
        ({"workspace": "none", "source": (SISTER,)}, "paper", "ws/devel/setup.bash"),
        ({"build_tool": "cmake"}, "paper", None),
        ({"build_tool": "cmake", "source": (SISTER,)}, "paper", "ws/devel/setup.bash"),
    ],
)
def test_the_place_and_the_setup_script(changes: dict[str, Any], folder: str, setup: str | None) -> None:
    found = plan(**changes).workspace
    assert found.folder == folder
    assert (found.ros.setup if found.ros else None) == setup
    assert found.underlay


def test_a_workspace_has_one_set_of_options_for_all_packages() -> None:
    config = Config(cmake_options="-DA='b c'", build_args=("--only", "x"))
    build = plan(config, source=(SISTER, SISTER)).workspace.ros
    assert build
    assert build.cmake_options == ("-DCMAKE_BUILD_TYPE=Release", "-DA=b c", "-DS=1 2")
    assert build.arguments == ("--only", "x")


def test_options_are_the_programs_where_the_repository_is_no_package() -> None:
    config = Config(cmake_options="-DA=1", build_args=("VERBOSE=1",))
    found = plan(config, build_tool="cmake", cmake_folder="cpp", source=(SISTER,)).workspace
    assert found.ros
    assert (found.ros.tool, found.ros.cmake_options, found.ros.arguments) == ("catkin_tools", ("-DS=1 2",), ())
    assert found.program
    assert found.program.cmake_options == ("-DCMAKE_BUILD_TYPE=Release", "-DA=1")
    assert (found.program.folder, found.program.build, found.program.on_path) == ("cpp", "paper-build", True)


def test_a_build_type_of_the_authors_is_kept() -> None:
    build = plan(Config(cmake_options="-DCMAKE_BUILD_TYPE=Debug")).workspace.ros
    assert build
    assert build.cmake_options == ("-DCMAKE_BUILD_TYPE=Debug",)
    (library,) = plan(source=(LIBRARY,)).libraries
    assert library.cmake_options == "-DCMAKE_BUILD_TYPE=Release -DL=1"


def test_an_old_format_gets_no_build_type_and_keeps_its_paths() -> None:
    found = plan(Config(**OLD), source=(LIBRARY,))
    assert found.libraries == (LIBRARY,)
    assert found.workspace.ros
    assert found.workspace.ros.cmake_options == ()
    assert found.workspace.links == (("catkin_ws", "ws"), ("paper", "ws/src/paper"))
    program = plan(
        Config(**OLD), build_tool="cmake", cmake_folder="cpp", kind="cpp", workspace="none"
    ).workspace.program
    assert program
    assert (program.build, program.on_path) == ("paper/cpp/build", False)


def test_the_papers_home_folder_was_the_source_where_that_is_no_workspace() -> None:
    inside = plan(Config(custom=HOME, **PAPER))
    beside = plan(Config(custom=HOME, **PAPER), kind="python", build_tool="none", workspace="none", ros_distro=None)
    assert inside.custom
    assert inside.custom.workdir == "home"
    assert beside.custom
    assert beside.custom.workdir == "source"


@pytest.mark.parametrize(
    ("distro", "base", "ubuntu", "ros", "ended"),
    [
        pytest.param("humble", "ros:humble-ros-base", "jammy", "kept", False, id="maintained"),
        pytest.param("humble", "osrf/ros:humble-desktop", "jammy", "replaced", False, id="not-built-again"),
        pytest.param("humble", "nvidia/cuda:12.1.0-devel-ubuntu22.04", "jammy", "added", True, id="cuda"),
        pytest.param("noetic", "ros:noetic-ros-base", "focal", "replaced", True, id="ended"),
        pytest.param("noetic", "ghcr.io/someone/ros:noetic", "focal", "replaced", True, id="somebody's"),
        pytest.param("noetic", "ubuntu:20.04", "focal", "added", True, id="plain"),
        pytest.param("iron", "ros:iron-ros-base", "jammy", "replaced", False, id="ended-on-a-maintained-ubuntu"),
    ],
)
def test_what_is_changed_in_a_bases_package_sources(distro: str, base: str, ubuntu: str, ros: str, ended: bool) -> None:
    kind = "ros1" if distro == "noetic" else "ros2"
    found = plan(base_image=base, ros_distro=distro, ubuntu=ubuntu, kind=kind).package_sources
    assert found
    if ros == "kept":
        assert (found.ros, found.ended) == (None, ended)
        return
    assert found.ros
    assert (found.ros.in_base, found.ended) == (ros == "replaced", ended)
    assert (found.ros.distro, found.ros.ubuntu) == (distro, ubuntu)
    snapshots = (f"http://snapshots.ros.org/{distro}/final/ubuntu", "ros-snapshots")
    assert ((found.ros.url, found.ros.key) == snapshots) == (distro != "humble")


def test_a_plain_program_on_an_ended_ubuntu_needs_no_ros() -> None:
    changes: dict[str, Any] = {"kind": "cpp", "ros_distro": None, "workspace": "none", "build_tool": "cmake"}
    found = plan(base_image="ubuntu:16.04", ubuntu="xenial", **changes).package_sources
    assert found
    assert (found.ros, found.ended) == (None, True)


@pytest.mark.parametrize(
    ("base", "ros", "day", "snapshot"),
    [
        ("ros:humble-ros-base", "humble", "2027-04-30", "http://snapshots.ros.org/humble/final/ubuntu"),
        ("ros:kilted-ros-base", "kilted", "2026-11-30", "http://snapshots.ros.org/kilted/final/ubuntu"),
        ("ros:rolling-ros-base", "rolling", "2031-04-30", None),
        ("python:3.12-slim-bookworm", None, "2028-06-30", None),
    ],
)
def test_a_maintained_base_knows_what_to_do_once_it_has_ended(
    base: str, ros: str | None, day: str, snapshot: str | None
) -> None:
    found = sources_of(base, None, distro(ros))
    assert found
    assert found.end
    assert found.end.day == day
    assert (found.end.ros.url if found.end.ros else None) == snapshot


def test_a_base_that_nothing_is_known_of_is_left_alone() -> None:
    assert sources_of("registry.example.org/lab/base:1", None, None) is None


def test_the_package_sources_of_an_authors_own_dockerfile_are_left_alone() -> None:
    assert plan(dockerfile="Dockerfile").package_sources is None
