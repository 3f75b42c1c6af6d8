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
    ],
)
def test_a_list_of_a_machine_with_ros_is_not_given_to_pip(tree: Tree, text: str, files: tuple[str, ...]) -> None:
    decision = tree({**NODE, "server/requirements.txt": text})
    assert decision.python.requirements == files
    told = [w.message for w in decision.warnings if w.file == "server/requirements.txt"]
    assert any("is not installed" in message for message in told) == (not files)


ANACONDA = "anaconda-client==1.7.2\nanaconda-navigator==2.0.3\nconda-build==3.21.4\nspyder @ file:///tmp/build/work\n"


@pytest.mark.parametrize(
    ("text", "files"),
    [
        (f"{ANACONDA}numpy==1.21.0\ntensorflow==2.4.0\n", ()),
        ("anaconda-client\nconda-build\nconda-verify\nnumpy==1.21.0\n", ("requirements.txt",)),
        ("anaconda-client==1.7.2\nconda-build==3.21.4\nnumpy==1.21.0\n", ("requirements.txt",)),
    ],
)
def test_a_list_of_an_anaconda_is_not_given_to_pip(tree: Tree, text: str, files: tuple[str, ...]) -> None:
    decision = tree({"main.py": "import numpy\nif __name__ == '__main__':\n    pass\n", "requirements.txt": text})
    assert decision.python.requirements == files
    assert decision.kind == "python"
    told = [
        w.message
        for w in decision.warnings
        if "what an Anaconda had installed, conda's own packages too, not all of which pip can" in w.message
    ]
    assert len(told) == (not files)


def test_what_the_code_imports_is_still_guessed(tree: Tree) -> None:
    decision = tree({"main.py": "import cvxopt\nif __name__ == '__main__':\n    pass\n", "requirements.txt": FROZEN})
    assert decision.python.requirements == ()
    assert [each.key for each in decision.python.pip_guessed] == ["cvxopt"]


@pytest.mark.parametrize(
    ("text", "pip", "whole"),
    [
        ("Django==1.11\nrospy\ncv_bridge==1.16.2\n", ["Django==1.11"], False),
        ("Django==1.11\nrospkg==1.5.0\n", [], True),
        ("Django==1.11\nmy-own-msgs==1.0\n", [], True),
        ("--extra-index-url https://rospypi.github.io/simple/\nDjango==1.11\nrospy\n", [], True),
    ],
)
def test_a_few_of_ros_s_own_packages_are_left_out_of_a_list(tree: Tree, text: str, pip: list[str], whole: bool) -> None:
    decision = tree({**NODE, "requirements.txt": text})
    assert decision.python.requirements == (("requirements.txt",) if whole else ())
    assert [each.written for each in decision.python.pip if each.file == "requirements.txt"] == pip
    told = [
        each.message for each in decision.warnings if "not installed by pip: it is a package of ROS" in each.message
    ]
    assert [message.split()[0] for message in told] == ([] if whole else ["rospy", "cv-bridge"])


def test_what_ros_alone_has_is_left_out_without_ros_too(tree: Tree) -> None:
    text = "numpy==1.24.4\npython-qt-binding==1.1.2\nqt-dotgraph==2.2.3\nstatistics_msgs==1.2.1\nrqt-graph==1.3.0\n"
    decision = tree({"main.py": "import numpy\n", "requirements.txt": text})
    assert [each.written for each in decision.python.pip] == ["numpy==1.24.4"]
    told = [w.message.split()[0] for w in decision.warnings if "it is a package of ROS" in w.message]
    assert told == ["python-qt-binding", "qt-dotgraph", "statistics-msgs", "rqt-graph"]
