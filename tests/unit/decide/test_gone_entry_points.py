"""A program whose module is no longer there starts nothing."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "import rclpy\n\n\ndef main():\n    rclpy.init()\n"


def package(*entries: str) -> dict[str, str]:
    return {
        "planner/package.xml": "<package><name>planner</name><depend>rclpy</depend>"
        "<export><build_type>ament_python</build_type></export></package>",
        "planner/setup.py": "from setuptools import setup\nsetup(name='planner', packages=['planner'],\n"
        f"  entry_points={{'console_scripts': {list(entries)!r}}})\n",
        "planner/planner/__init__.py": "",
        "planner/planner/executor.py": MAIN,
    }


@pytest.mark.parametrize(
    ("entry", "command"),
    [
        ("a_star = planner.a_star:main", ("ros2", "run", "planner", "executor")),
        ("a_star = planner.old.a_star:main", ("ros2", "run", "planner", "executor")),
        ("a_star = made_elsewhere.a_star:main", ("bash",)),
        ("a_star = planner.executor:again", ("bash",)),
    ],
)
def test_an_entry_without_its_module_is_no_candidate(tree: Tree, entry: str, command: tuple[str, ...]) -> None:
    assert tree(package("executor = planner.executor:main", entry)).command == command


def test_a_module_that_a_compiler_makes_stays(tree: Tree) -> None:
    files = package("executor = planner.executor:main", "fast = planner.fast:main") | {"planner/planner/fast.pyx": ""}
    assert tree(files).command == ("bash",)
