"""A plain CMake project of the tree that a package requires is built before it by colcon."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SDK = "project({})\nadd_library(sdk a.cpp)\ninstall(EXPORT sdk FILE {}Config.cmake DESTINATION lib)\n"


@pytest.mark.parametrize(
    ("tool", "name", "config", "told"),
    [
        ("ament_cmake", "arm-sdk", "arm-sdk", True),
        ("ament_cmake", "sdk", "arm-sdk", False),  # colcon knows it by another name
        ("catkin", "arm-sdk", "arm-sdk", False),  # it is installed before the workspace
    ],
)
def test_it_is_named_in_the_image(tree: Tree, tool: str, name: str, config: str, *, told: bool) -> None:
    decision = tree(
        {
            "arm/package.xml": f"<package><name>arm</name><buildtool_depend>{tool}</buildtool_depend></package>",
            "arm/CMakeLists.txt": f"project(arm)\nfind_package({tool} REQUIRED)\nfind_package(arm-sdk 1.2 REQUIRED)\n",
            "sdk/CMakeLists.txt": SDK.format(name, config),
            "sdk/a.cpp": "",
        }
    )
    assert decision.undeclared is told
    assert any("CMake of arm requires arm-sdk" in each.message for each in decision.warnings) is told
