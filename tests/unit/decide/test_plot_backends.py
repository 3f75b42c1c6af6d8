"""Libraries of windows that matplotlib imports because code names them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROS = {
    "package.xml": "<package format='3'><name>demo</name><exec_depend>rclpy</exec_depend><export>"
    "<build_type>ament_python</build_type></export></package>",
    "setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'])\n",
    "README.md": "ROS 2 Humble\n",
    "demo/__init__.py": "",
}
GTK3 = {"python3-gi", "python3-gi-cairo", "gir1.2-gtk-3.0"}
GTK4 = {"python3-gi", "python3-gi-cairo", "gir1.2-gtk-4.0"}
EVERY = GTK3 | GTK4 | {"python3-pyqt5", "python3-wxgtk4.0"}


@pytest.mark.parametrize(
    ("code", "asked"),
    [
        ("matplotlib.use('GTK3agg')\n", GTK3),
        ('matplotlib.use("GTK4Cairo")\n', GTK4),
        ("matplotlib.use(backend='Qt5Agg')\n", {"python3-pyqt5"}),
        ("import matplotlib.pyplot as plt\nplt.switch_backend('WXAgg')\n", {"python3-wxgtk4.0"}),
        ("import os\nos.environ['MPLBACKEND'] = 'Qt5Agg'\n", {"python3-pyqt5"}),
        ("matplotlib.use('Agg')\n", set()),
        ("# matplotlib.use('Qt5Agg')\n", set()),
        ("try:\n    matplotlib.use('Qt5Agg')\nexcept ImportError:\n    matplotlib.use('Agg')\n", set()),
        ("def show():\n    matplotlib.use('Qt5Agg')\n", set()),
        ("def show():\n    if a:\n        pass\n    matplotlib.use('Qt5Agg')\n", set()),
        ("def show():\n    matplotlib.use('Qt5Agg')\n\nshow()\n", {"python3-pyqt5"}),
        ("with a:\n    matplotlib.use('Qt5Agg')\n", {"python3-pyqt5"}),
        ("class A:\n    def __init__(self):\n        matplotlib.use('Qt5Agg')\n", {"python3-pyqt5"}),
        ("def main():\n    matplotlib.use('WXAgg')\n", {"python3-wxgtk4.0"}),
    ],
)
def test_what_a_named_backend_needs(tree: Tree, code: str, asked: set[str]) -> None:
    decision = tree({**ROS, "demo/show.py": f"import rclpy\nimport matplotlib\n{code}"})
    assert EVERY & {*decision.apt, *decision.apt_guessed} == asked


def test_pip_brings_it_where_pip_brings_matplotlib(tree: Tree) -> None:
    decision = tree({"show.py": "import matplotlib\nmatplotlib.use('Qt5Agg')\n", "requirements.txt": "matplotlib\n"})
    assert "pyqt5" in {each.key for each in decision.pip}


def test_that_of_a_test_is_not_needed(tree: Tree) -> None:
    decision = tree({**ROS, "test/show.py": "import matplotlib\nmatplotlib.use('Qt5Agg')\n"})
    assert not EVERY & {*decision.apt_guessed}


@pytest.mark.parametrize(
    ("other", "asked"),
    [
        ("from demo.show import draw\ndraw()\n", True),
        ("from demo import show\nshow.draw()\n", True),
        ("import turtle\nturtle.draw()\n", False),
    ],
)
def test_a_function_that_another_module_calls(tree: Tree, other: str, asked: bool) -> None:
    code = "import rclpy\nimport matplotlib\ndef draw():\n    matplotlib.use('Qt5Agg')\n"
    decision = tree({**ROS, "demo/show.py": code, "demo/other.py": other})
    assert ("python3-pyqt5" in {*decision.apt, *decision.apt_guessed}) == asked
