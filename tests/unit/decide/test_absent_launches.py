"""A launch file that the page starts and the package does not have is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LAUNCH = "def generate_launch_description():\n    return LaunchDescription([])\n"
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "launch/controller.launch.py": LAUNCH,
    "launch/robot.launch.py": LAUNCH,
    "launch/late.launch.py.in": LAUNCH,
}


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("ros2 launch demo controllers.launch.py", "which has no such launch file; it has controller.launch.py"),
        ("ros2 launch demo camera_with_a_lens.launch.py", "which has no such launch file"),
        ("ros2 launch demo robot.launch.py", ""),
        ("ros2 launch demo robot.launch", ""),
        ("ros2 launch demo late.launch.py", ""),
        ("ros2 launch other controllers.launch.py", ""),
        ("ros2 launch demo <name>.launch.py", ""),
        ("roslaunch demo controllers.launch", ""),
    ],
)
def test_a_launch_file_that_the_package_lacks(tree: Tree, line: str, told: str) -> None:
    decision = tree(FILES | {"README.md": f"# Demo\n## Run\n```\n{line}\n```\n"})
    said = [w for w in decision.warnings if "the page starts" in w.message]
    assert [w.message.endswith(told) and w.line == 4 for w in said] == [True] * bool(told)


@pytest.mark.parametrize(("name", "told"), [("robot.launch.py", False), ("robots.launch.py", True)])
def test_a_submodule_that_is_checked_out_may_have_it(tree: Tree, name: str, told: bool) -> None:
    module = '[submodule "src/demo"]\n\tpath = src/demo\n\turl = https://github.com/lab/demo.git\n'
    inside = {f"src/demo/{path}": text for path, text in FILES.items()}
    page = {"README.md": f"# Demo\n## Run\n```\nros2 launch demo {name}\n```\n"}
    decision = tree(inside | page | {".gitmodules": module})
    assert any("the page starts" in w.message for w in decision.warnings) is told
