"""A conda environment with exactly an Ubuntu's own Python is a weak sign of its distribution."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
AMENT = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
CMAKE = "project(a)\nfind_package(ament_cmake REQUIRED)\n"
CONDA = "name: a\ndependencies:\n  - python{}\n  - numpy\n"


@pytest.mark.parametrize(
    ("python", "page", "distro"),
    [
        ("=3.12.3", "", "jazzy"),
        ("=3.8.10", "", "foxy"),
        ("=3.8.20", "", "humble"),
        (">=3.12.3", "", "humble"),
        ("=3.12.3", "Tested on ROS 2 Humble.\n", "humble"),
    ],
)
def test_the_python_of_an_ubuntu(tree: Tree, python: str, page: str, distro: str) -> None:
    files = {"package.xml": AMENT, "CMakeLists.txt": CMAKE, "environment.yml": CONDA.format(python), "README.md": page}
    decision = tree(files)
    assert decision.ros_distro == distro
    told = any("nothing says which ROS distribution" in warning.message for warning in decision.warnings)
    assert told == (not page)
