"""A package whose folder a compiled program looks for is needed, though no manifest names it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>{}</buildtool_depend></package>"
OLD = 'ros::package::getPath("lab_maps")'
NEW = 'ament_index_cpp::get_package_share_directory("lab_maps")'
PAGE = "# Demo\n\n## ROS dependencies\n\n1. [ROS](https://www.ros.org/)\n1. [Maps](https://github.com/lab/lab_maps)\n"
CI = (
    "jobs:\n  a:\n    steps:\n      - run: |\n          git clone https://github.com/lab/lab_maps.git\n          make\n"
)


def files(code: str, tool: str = "catkin") -> dict[str, str]:
    cmake = f"project(demo)\nfind_package({tool} REQUIRED)\nadd_executable(demo src/a.cpp)\n"
    return {
        "package.xml": PACKAGE.format(tool),
        "CMakeLists.txt": cmake + ("catkin_package()\n" if tool == "catkin" else "ament_package()\n"),
        "src/a.cpp": f"{code}\nint main() {{}}\n",
    }


@pytest.mark.parametrize(
    ("code", "tool", "others", "cloned"),
    [
        (f"auto maps = {OLD};", "catkin", {"README.md": PAGE}, True),
        (f"auto maps = {NEW};", "ament_cmake", {"README.md": PAGE}, True),
        (f"auto maps = {OLD};", "catkin", {".github/workflows/a.yml": CI}, True),
        (f"// auto maps = {OLD};", "catkin", {"README.md": PAGE}, False),
        ("auto maps = ros::package::getPath(name);", "catkin", {"README.md": PAGE}, False),
        (f"auto maps = {OLD};", "catkin", {"README.md": "# Demo\n\nROS Noetic\n"}, False),
        (
            f"auto own = {OLD.replace('lab_maps', 'demo')};",
            "catkin",
            {"README.md": PAGE.replace("_maps", "_demo")},
            False,
        ),
    ],
)
def test_what_a_page_lists_or_ci_clones_is_cloned(
    tree: Tree, code: str, tool: str, others: dict[str, str], *, cloned: bool
) -> None:
    found = tree({**files(code, tool), **others})
    assert bool(found.source) is cloned


def test_what_is_released_comes_from_apt(tree: Tree) -> None:
    code = OLD.replace("lab_maps", "turtlebot3_description")
    found = tree({**files(f"auto robot = {code};"), "README.md": "ROS Noetic\n"})
    assert "ros-noetic-turtlebot3-description" in found.apt_guessed


PYTHON = "import rospkg\nimport rospy\n\nrospy.init_node('a')\nmaps = rospkg.RosPack().get_path({})\n"


@pytest.mark.parametrize(
    ("changed", "found"),
    [
        ({"src/a.cpp": f"auto maps = {OLD};\nint main() {{}}\n"}, True),
        ({"scripts/a.py": PYTHON.format("'lab_maps'")}, True),
        ({"scripts/a.py": PYTHON.format("name")}, False),
        ({"scripts/a.py": PYTHON.format("'lab_maps'").replace("maps =", "# maps =")}, False),
        ({"scripts/a.py": "import rospy\nmaps = store.get_path('lab_maps')\n"}, False),
        ({"src/a.cpp": f"auto maps = {OLD.replace('lab_maps', 'turtlebot3_description')};\nint main() {{}}\n"}, False),
    ],
)
def test_what_nothing_brings_is_looked_for_at_the_owner(
    tmp_path: Path, changed: dict[str, str], *, found: bool
) -> None:
    sought = _of_owner(tmp_path, {**files("int a;"), "README.md": "ROS Noetic\n", **changed})
    assert sought == ([("https://github.com/lab/lab_maps.git", ("lab_maps",), "catkin_make")] if found else [])


def test_a_package_of_the_tree_is_not_looked_for(tmp_path: Path) -> None:
    tree = {f"demo/{path}": text for path, text in files("int a;", "ament_cmake").items()}
    tree |= {"lab_maps/package.xml": PACKAGE.format("ament_cmake").replace("demo", "lab_maps")}
    tree |= {"lab_maps/CMakeLists.txt": "project(lab_maps)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"}
    code = "from ament_index_python.packages import get_package_share_directory\n\n"
    tree |= {"lab_maps/launch/a.launch.py": f"{code}maps = get_package_share_directory('lab_maps')\n"}
    assert _of_owner(tmp_path, {**tree, "README.md": "ROS 2 Humble\n"}) == []


def test_it_is_for_a_package_of_rosbuild_too(tmp_path: Path) -> None:
    cmake = (
        "include($ENV{ROS_ROOT}/core/rosbuild/rosbuild.cmake)\nrosbuild_init()\nrosbuild_add_executable(a src/a.cpp)\n"
    )
    tree = {"manifest.xml": '<package>\n<depend package="roscpp"/>\n</package>\n', "CMakeLists.txt": cmake}
    sought = _of_owner(tmp_path, {**tree, "src/a.cpp": f"auto maps = {OLD};\nint main() {{}}\n"})
    assert sought == [("https://github.com/lab/lab_maps.git", ("lab_maps",), "none")]
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "RUN clone-holding --ros1 --rosmake https://github.com/lab/lab_maps.git" in text


def _of_owner(folder: Path, files: dict[str, str]) -> list[tuple[str | None, tuple[str, ...], str]]:
    """Return where a repository of the owner ``lab`` has packages looked for."""
    config = '[remote "origin"]\n\turl = https://github.com/lab/demo\n'
    tree_of(folder, {**files, ".git/config": config, ".git/HEAD": "ref: refs/heads/main\n"})
    plan = plan_repository(folder).plan
    return [(each.repo, each.holding, each.build) for each in plan.workspace.sources if each.holding]
