"""A release of Gazebo that is not the distribution's own comes from Gazebo's packages, and so does ros_gz for it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SOURCE = (
    "deb [signed-by=https://packages.osrfoundation.org/gazebo.gpg] "
    "https://packages.osrfoundation.org/gazebo/ubuntu-stable jammy main"
)


def ros2(cmake: str, needs: str = "", page: str = "Needs ROS 2 Humble.\n") -> dict[str, str]:
    return {
        "package.xml": f'<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>{needs}'
        "<export><build_type>ament_cmake</build_type></export></package>",
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.8)\nproject(demo)\nfind_package(ament_cmake REQUIRED)\n"
        f"{cmake}",
        "README.md": page,
    }


HARMONIC = "find_package(gz-transport13 REQUIRED)\nfind_package(gz-msgs10 REQUIRED)\n"


def test_harmonic_beside_humble(tree: Tree) -> None:
    decision = tree(ros2(HARMONIC, "<depend>gz-transport13</depend><exec_depend>ros_gz_bridge</exec_depend>"))
    assert decision.ros_distro == "humble"
    assert {"libgz-transport13-dev", "libgz-msgs10-dev", "ros-humble-ros-gzharmonic-bridge"} <= {*decision.apt}
    assert "ros_gz_bridge" not in decision.rosdep
    assert decision.repositories == (SOURCE,)
    assert "gz-harmonic" not in decision.apt


def test_all_of_a_release_is_there_for_ros_gz_from_its_source(tree: Tree) -> None:
    listed = "repositories:\n  ros_gz:\n    type: git\n    url: https://github.com/gazebosim/ros_gz\n"
    assert "gz-harmonic" in tree({**ros2(HARMONIC), "demo.repos": listed}).apt


@pytest.mark.parametrize("listed", [True, False])
def test_what_is_cloned_brings_no_ros_gz_of_the_distributions_release(tree: Tree, listed: bool) -> None:
    """The two cannot be installed together: https://github.com/gazebosim/ros_gz/issues/755."""
    clone = "repositories:\n  worlds:\n    type: git\n    url: https://github.com/lab/worlds\n" if listed else ""
    needs = "<depend>gz-transport13</depend><exec_depend>ros_gz_bridge</exec_depend>"
    decision = tree({**ros2(HARMONIC, needs), "demo.repos": clone})
    assert {"ros_gz", "ros_gz_bridge", "ros_gz_sim", "ros_gz_image"} <= {*decision.skip_keys}
    assert ("ros-humble-ros-gzharmonic" in decision.apt_guessed) == listed
    assert "ros_gz_sim" not in tree(ros2("", "<exec_depend>ros_gz_bridge</exec_depend>")).skip_keys


@pytest.mark.parametrize(
    ("cmake", "page", "source"),
    [
        (HARMONIC, "Needs ROS 2 Jazzy.\n", False),
        ("", "Needs ROS 2 Humble.\n", False),
        ("find_package(ignition-transport11 REQUIRED)\n", "Needs ROS 2 Humble.\n", False),
        ("", "Needs ROS 2 Humble.\n```\nsudo apt install gz-harmonic\n```\n", True),
    ],
)
def test_the_distributions_own_release_stays(tree: Tree, cmake: str, page: str, source: bool) -> None:
    decision = tree(ros2(cmake, "<exec_depend>ros_gz_bridge</exec_depend>", page))
    assert (SOURCE in decision.repositories, "ros_gz_bridge" in decision.rosdep) == (source, not source)
    assert not any(name.startswith("libgz") for name in decision.apt)


def test_a_page_that_adds_the_source_adds_it_once(tree: Tree) -> None:
    page = (
        "Needs ROS 2 Humble.\n```\nsudo curl https://packages.osrfoundation.org/gazebo.gpg --output "
        '/usr/share/keyrings/osrf.gpg\necho "deb [signed-by=/usr/share/keyrings/osrf.gpg] '
        'http://packages.osrfoundation.org/gazebo/ubuntu-stable $(lsb_release -cs) main" | sudo tee '
        "/etc/apt/sources.list.d/gazebo-stable.list\nsudo apt install gz-harmonic\n```\n"
    )
    assert len(tree(ros2(HARMONIC, page=page)).repositories) == 1
