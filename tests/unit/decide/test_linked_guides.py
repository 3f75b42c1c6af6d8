"""Guides that the root's page or an installation page links to, where no page that is read anyway runs anything."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": '<package format="3"><name>demo</name><exec_depend>ros_gz_sim</exec_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "sim/gazebo/worlds/hall.sdf": "<sdf/>",
    "launch/map.launch.py": "from launch import LaunchDescription\n",
    "launch/drive.launch.py": "from launch import LaunchDescription\n",
}
DRIVE = "# Drive\n\nROS 2 jazzy\n\n    ros2 launch demo drive.launch.py\n"
WORLD = (
    '# World\n\nROS 2 jazzy\n\n    export GZ_SIM_RESOURCE_PATH="{PATH ON YOUR COMPUTER}/demo/sim/gazebo/"\n\n'
    "Start it:\n\n    gz sim -r worlds/hall.sdf\n"
)


@pytest.mark.parametrize(
    "pages",
    [
        {"README.md": "See [guide](/docs/user_guides/drive.md).\n"},
        {"README.md": "See [guide](docs/user_guides/drive.md).\n"},
        {"README.md": "See [guides](/docs/user_guides/).\n"},
        {"README.md": "See [guides](docs/user_guides).\n"},
        {"README.md": "See [it](docs/installing/).\n", "docs/installing/x.md": "[try](../user_guides/drive.md)\n"},
        {"README.md": "# Demo\n", "docs/install.md": "Then [try it](/docs/user_guides/drive.md).\n"},
        {"README.md": "# Demo\n", "docs/install.md": "Then [try it](user_guides/drive.md).\n"},
    ],
)
def test_a_linked_guide_starts_the_program(tree: Tree, pages: dict[str, str]) -> None:
    found = tree({**FILES, "docs/user_guides/drive.md": DRIVE, **pages})
    assert found.command == ("ros2", "launch", "demo", "drive.launch.py")


@pytest.mark.parametrize(
    "pages",
    [
        {"README.md": "# Demo\n"},  # nobody links to it
        {"README.md": "See [guides](/docs/gone/) and [x](https://example.org/docs/user_guides/drive.md).\n"},
        {"README.md": "See [guides](launch/).\n", "launch/drive.md": DRIVE},  # a folder of code
        {"README.md": "See [guide](../docs/user_guides/drive.md).\n"},  # outside of the tree
    ],
)
def test_what_is_no_link_to_a_guide(tree: Tree, pages: dict[str, str]) -> None:
    found = tree({**FILES, "docs/user_guides/drive.md": DRIVE, **pages})
    assert found.command == ("bash",)


def test_the_root_page_comes_first(tree: Tree) -> None:
    page = "See [guide](/docs/user_guides/drive.md).\n```\nros2 launch demo map.launch.py\n```\n"
    found = tree({**FILES, "docs/user_guides/drive.md": DRIVE, "README.md": page})
    assert found.command == ("ros2", "launch", "demo", "map.launch.py")


def test_a_world_below_the_folder_that_the_guide_has_the_simulator_look_in(tree: Tree) -> None:
    found = tree({**FILES, "docs/guides/world.md": WORLD, "README.md": "[world](/docs/guides/world.md), ROS 2 jazzy\n"})
    assert found.command == ("gz", "sim", "-r", "sim/gazebo/worlds/hall.sdf")
    assert ("GZ_SIM_RESOURCE_PATH", "./sim/gazebo") in found.variables


def test_of_two_worlds_of_one_name_none_is_meant(tree: Tree) -> None:
    more = {"first/worlds/hall.sdf": "<sdf/>", "second/worlds/hall.sdf": "<sdf/>"}
    files = {path: text for path, text in FILES.items() if not path.endswith(".sdf")}
    found = tree({**files, **more, "docs/guides/world.md": WORLD, "README.md": "[world](/docs/guides/world.md)\n"})
    assert found.command[0] != "gz"


@pytest.mark.parametrize("page", ["README.md", "docs/guides/webots.md"])
def test_a_world_of_webots_is_told(tree: Tree, page: str) -> None:
    line = "Then run:\n\n    webots sim/webots/hall.wbt\n"
    found = tree({**FILES, "README.md": "[webots](/docs/guides/webots.md)\n", page: line})
    said = [w.message for w in found.warnings if "`webots sim/webots/hall.wbt`" in w.message]
    assert len(said) == 1
    assert found.command == ("bash",)
