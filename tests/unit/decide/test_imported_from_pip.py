"""A package of ROS is not installed for a module that pip brings: two builds of one library do not go together."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>msgs</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(msgs)\nfind_package(ament_cmake REQUIRED)\n",
    "README.md": "ROS 2 Humble\n\n```\ncolcon build\npip install -r requirements.txt\npython arm.py\n```\n",
    "arm.py": "import rclpy\nfrom msgs.msg import Arm\nimport pinocchio\nimport dynamixel_sdk\n",
}


@pytest.mark.parametrize(
    ("declared", "more", "found"),
    [
        ("numpy\n", {}, ["dynamixel-sdk", "pinocchio"]),
        ("dynamixel-sdk\n", {}, ["pinocchio"]),
        ("dynamixel-sdk\npin\n", {}, []),
        ("dynamixel_sdk\nplaco>=0.9\n", {}, []),
        # what is compiled finds it as CMake's package
        (
            "pin\n",
            {"CMakeLists.txt": "project(msgs)\nfind_package(pinocchio REQUIRED)\n"},
            ["dynamixel-sdk", "pinocchio"],
        ),
    ],
)
def test_what_pip_brings(tree: Tree, declared: str, more: dict[str, str], found: list[str]) -> None:
    decision = tree(PACKAGE | {"requirements.txt": declared} | more)
    assert decision.ros_distro == "humble"
    names = [name.removeprefix("ros-humble-") for name in (*decision.apt, *decision.apt_guessed)]
    assert sorted(name for name in names if name in {"pinocchio", "dynamixel-sdk"}) == found


def test_a_module_that_the_index_lacks_comes_from_its_repository(tree: Tree) -> None:
    decision = tree(PACKAGE | {"arm.py": "import rclpy\nimport detectron2\n"})
    asked = [each.written for each in decision.python.pip_guessed]
    assert asked == ["torch", "torchvision", "detectron2 @ git+https://github.com/facebookresearch/detectron2"]
    assert decision.python.first == ()  # no step that must succeed comes before a guess


@pytest.mark.parametrize(
    ("said", "taken"), [("pytorch3d==0.7.2", "@v0.7.2"), ("pytorch3d>=0.7", ""), ("pytorch3d", "")]
)
def test_a_version_that_the_index_lacks_is_the_tag_of_its_repository(tree: Tree, said: str, taken: str) -> None:
    files = {"requirements.txt": f"torch==2.4.1\n{said}\n", "main.py": "import torch, pytorch3d\n"}
    asked = [each.written for each in tree(files).python.pip]
    assert f"pytorch3d @ git+https://github.com/facebookresearch/pytorch3d{taken}" in asked


def test_a_library_of_crowds_that_its_author_never_released(tree: Tree) -> None:
    """It is built beside Cython and a CMake that takes its old lists, both as optional as itself."""
    found = tree({"run.py": "import rvo2\nimport ott\n"})
    asked = [each.written for each in found.python.pip_guessed]
    address = "pyrvo2 @ git+https://github.com/sybrenstuvel/Python-RVO2"
    assert sorted(asked) == ["Cython", "cmake<4", "ott-jax", address]
    assert not [each.message for each in found.warnings if "rvo2" in each.message]
