"""A list of what a whole machine with ROS had installed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
NODE = {
    "ws/demo/package.xml": PACKAGE,
    "ws/demo/CMakeLists.txt": "find_package(catkin REQUIRED)\ncatkin_package()\n",
}
FROZEN = "catkin==0.7.6\nDjango==1.11\npycurl==7.19.3\nroslib==1.13.5\nrospy==1.12.7\n"


@pytest.mark.parametrize(
    ("text", "files"),
    [
        (FROZEN, ()),
        ("ament-index-python==1.4.0\nlaunch-ros==0.19.4\nnumpy==1.21.5\nrclpy==3.3.7\n", ()),
        ("Django==1.11\npycurl==7.19.3\n", ("server/requirements.txt",)),
        ("Django==1.11\nrospy\nroslib\ncatkin\n", ("server/requirements.txt",)),
    ],
)
def test_a_list_of_a_machine_with_ros_is_not_given_to_pip(tree: Tree, text: str, files: tuple[str, ...]) -> None:
    decision = tree({**NODE, "server/requirements.txt": text})
    assert decision.python.requirements == files
    told = [w.message for w in decision.warnings if w.file == "server/requirements.txt"]
    assert any("is not installed" in message for message in told) == (not files)


def test_what_the_code_imports_is_still_guessed(tree: Tree) -> None:
    decision = tree({"main.py": "import cvxopt\nif __name__ == '__main__':\n    pass\n", "requirements.txt": FROZEN})
    assert decision.python.requirements == ()
    assert [each.key for each in decision.python.pip_guessed] == ["cvxopt"]
