"""Programs that a page runs by their path in the tree that a workspace is installed into."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
AMENT = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)
CATKIN = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
BUILT = (
    "project(demo)\nfind_package({} REQUIRED)\n"
    "add_executable(talker talker.cpp)\nadd_executable(listener listener.cpp)\nadd_executable(relay relay.cpp)\n"
)
CODE = {f"{name}.cpp": "int main() {}\n" for name in ("talker", "listener", "relay")}


def command(tree: Tree, line: str, *, ros: int = 2) -> tuple[str, ...] | str:
    made = {"package.xml": AMENT if ros == 2 else CATKIN}
    made["CMakeLists.txt"] = BUILT.format("ament_cmake" if ros == 2 else "catkin")
    return tree({**made, **CODE, "README.md": f"# Demo\n## Usage\n```bash\n{line}\n```\n"}).command


@pytest.mark.parametrize(
    "line",
    [
        "~/ws/install/demo/lib/demo/listener -a 1",
        "~/ws/install/demo/lib/demo/./listener -a 1",
        "$HOME/ws/install/lib/demo/listener -a 1",
        "./install/demo/lib/demo/listener -a 1",
        "install/demo/lib/demo/listener -a 1",
        "/home/me/ws/install/demo/lib/demo/listener -a 1 &",
    ],
)
def test_it_is_run_by_its_package(tree: Tree, line: str) -> None:
    assert command(tree, line) == ("ros2", "run", "demo", "listener", "-a", "1")


def test_catkin_has_such_a_tree_too(tree: Tree) -> None:
    assert command(tree, "~/catkin_ws/devel/lib/demo/listener", ros=1) == ("rosrun", "demo", "listener")


@pytest.mark.parametrize(
    "line",
    [
        "~/ws/install/demo/lib/demo/listener_c",  # the tree builds none of that name
        "~/ws/install/agent/lib/agent/agent udp4",  # another package's
        "export LD_LIBRARY_PATH=~/ws/install/demo/lib/demo",
        "ls ~/ws/install/demo/lib/demo/listener",
        "cp listener ~/ws/install/demo/lib/demo/listener",
    ],
)
def test_no_program_is_invented(tree: Tree, line: str) -> None:
    assert command(tree, line) == ("bash",)
