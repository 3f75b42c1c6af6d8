"""What the setup.py of nodes asks pip for is installed, as colcon installs none of it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = "<package><name>{0}</name>{1}<export><build_type>ament_python</build_type></export></package>"


def sim(requires: str, depends: str = "") -> dict[str, str]:
    return {
        "sim/package.xml": XML.format("sim", f"<depend>rclpy</depend>{depends}"),
        "sim/setup.py": f"from setuptools import setup\nsetup(name='sim', install_requires=[{requires}],"
        " extras_require={'x': ['gym']})\n",
        "sim/sim/__init__.py": "",
        "sim/sim/node.py": "import rclpy\n",
        "mujoco/include/mujoco.h": "",
    }


@pytest.mark.parametrize(
    ("requires", "depends", "guessed"),
    [
        ("'setuptools', 'mujoco>=3', 'glfw'", "", {"mujoco>=3", "glfw"}),
        ("'setuptools', 'rclpy', 'std_msgs', 'my_msgs'", "", set()),
        ("'numpy', 'pyserial', 'opencv-python'", "", set()),
        ("'glfw'", "<exec_depend>python3-glfw-pip</exec_depend>", set()),
    ],
)
def test_what_pip_alone_has(tree: Tree, requires: str, depends: str, guessed: set[str]) -> None:
    assert {each.written for each in tree(sim(requires, depends)).python.pip_guessed} == guessed
