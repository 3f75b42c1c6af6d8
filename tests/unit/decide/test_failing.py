"""A command in a sentence about its failure is named there, and not to be started."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "find_package(ament_cmake REQUIRED)\ninstall(DIRECTORY launch DESTINATION share/demo)\n",
    "launch/pool.launch.py": "from launch import LaunchDescription\n",
}
START = "```\n# Terminal 1\nros2 launch demo pool.launch.py\n\n# Terminal 2\nros2 run demo bridge.py\n```\n"


@pytest.mark.parametrize(
    ("sentence", "named"),
    [
        ("If `ros2 run demo bridge.py` says *No executable found*: rebuild.", True),
        ("But if `ros2 run demo bridge.py` says\n  *No executable found*: rebuild.", True),
        ("The zip drops bits, so when `ros2 run demo bridge.py` fails, rebuild.", True),
        ("If `ros2 run demo bridge.py` doesn't start, rebuild.", True),
        ("If all is built, `ros2 run demo bridge.py` starts it.", False),
        ("When `ros2 run demo bridge.py` shows the window, you are done.", False),
        ("Run `ros2 run demo bridge.py`; it does not need a camera.", False),
    ],
)
def test_what_fails_is_not_started(tree: Tree, sentence: str, named: bool) -> None:
    decision = tree({**FILES, "README.md": f"# Demo\nROS 2 Humble\n## Start\n* {sentence}\n\n{START}"})
    assert decision.command == (
        ("ros2", "launch", "demo", "pool.launch.py") if named else ("ros2", "run", "demo", "bridge.py")
    )


def test_what_is_installed_is(tree: Tree) -> None:
    page = "# Demo\nROS 2 Humble\n## Build\nIf `sudo apt install libyaml-cpp-dev` fails, update first.\n"
    assert "libyaml-cpp-dev" in tree({**FILES, "README.md": page}).apt_guessed
