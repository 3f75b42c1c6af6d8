"""A component of catkin that no configuration file is called like is no solved dependency."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, components: str) -> dict[str, str]:
    manifest = f"<package format='2'><name>{name}</name><version>1.0.0</version><description>d</description>"
    manifest += "<maintainer email='a@b.c'>a</maintainer><license>MIT</license><buildtool_depend>catkin"
    manifest += "</buildtool_depend><depend>roscpp</depend></package>"
    cmake = f"project({name})\nfind_package(catkin REQUIRED COMPONENTS roscpp {components})\ncatkin_package()\n"
    return {f"src/{name}/package.xml": manifest, f"src/{name}/CMakeLists.txt": cmake}


@pytest.mark.parametrize(
    ("components", "told"),
    [
        ("opencv2", {"opencv2": "OpenCV"}),
        ("Eigen opencv2", {"opencv2": "OpenCV", "Eigen": "Eigen3"}),
        ("OpenCV PCL Eigen3", {}),
        ("", {}),
    ],
)
def test_the_name_that_cmake_knows_is_told(tree: Tree, components: str, told: dict[str, str]) -> None:
    page = "# Eyes\nROS Noetic\n```\ngit clone https://github.com/lab/other_driver.git\n```\n"
    decision = tree({"README.md": page, **package("eyes", components), **package("ears", "")})
    messages = [each.message for each in decision.warnings]
    for name, config in told.items():
        assert any(f"component {name}," in each and f"find_package({config} REQUIRED)" in each for each in messages)
    assert sum("asks catkin for the component" in each for each in messages) == len(told)
    assert not any("brings" in each or "may hold" in each for each in messages)
    assert ("eyes" in decision.left_out) is bool(told)
