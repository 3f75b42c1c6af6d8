"""A library whose package has no configuration file for CMake is compiled where the code asks for that file."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
NLOPT = "find_package(catkin REQUIRED COMPONENTS roscpp NLopt)\n"


@pytest.mark.parametrize(
    ("distro", "asks", "more", "built"),
    [
        ("Melodic", NLOPT, {}, True),
        ("Melodic", "find_package(NLopt REQUIRED)\n", {}, True),
        ("Melodic", NLOPT, {"cmake/FindNLopt.cmake": ""}, True),  # catkin looks for configuration files alone
        ("Melodic", "find_package(NLopt REQUIRED)\n", {"cmake/FindNLopt.cmake": ""}, False),
        ("Melodic", "find_package(NLOPT REQUIRED)\n", {}, False),  # that has never been the name of such a file
        ("Noetic", NLOPT, {}, False),
    ],
)
def test_a_package_without_its_configuration_file_is_compiled(
    tree: Tree, distro: str, asks: str, more: dict[str, str], built: bool
) -> None:
    cmake = {"CMakeLists.txt": f"cmake_minimum_required(VERSION 2.8.3)\nproject(demo)\n{asks}", "package.xml": XML}
    decision = tree({"README.md": f"ROS {distro}\n", **cmake, **more})
    assert [source.name for source in decision.source] == (["nlopt"] if built else [])
    assert ("libnlopt-dev" in (*decision.apt, *decision.apt_guessed)) is not built


@pytest.mark.parametrize(
    ("distro", "name", "more", "built"),
    [
        ("Melodic", "Glog", {}, True),
        ("Kinetic", "glog", {}, True),
        ("Melodic", "Glog", {"cmake/FindGlog.cmake": ""}, False),
        ("Indigo", "Glog", {}, False),  # its CMake is too old for glog's
    ],
)
def test_glog_is_compiled_where_ubuntu_has_no_configuration_file(
    tree: Tree, distro: str, name: str, more: dict[str, str], built: bool
) -> None:
    asks = f"cmake_minimum_required(VERSION 2.8.3)\nproject(demo)\nfind_package({name} REQUIRED)\n"
    decision = tree({"README.md": f"ROS {distro}\n", "CMakeLists.txt": asks, "package.xml": XML, **more})
    assert [source.name for source in decision.source] == (["glog"] if built else [])
    assert ("libgoogle-glog-dev" in (*decision.apt, *decision.apt_guessed)) is not built
