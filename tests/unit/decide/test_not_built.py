"""What a package of the other ROS imports, includes, starts and says brings nothing: it is not built."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
CATKIN = "<package format='2'><name>seer</name><buildtool_depend>catkin</buildtool_depend></package>"
SEER = {
    "src/seer/package.xml": CATKIN,
    "src/seer/CMakeLists.txt": "project(seer)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "src/seer/scripts/see.py": "#!/usr/bin/env python3\nimport open3d\nif __name__ == '__main__':\n    pass\n",
    "src/seer/src/a.cpp": "#include <pcl/point_cloud.h>\n",
    "src/seer/launch/s.launch": "<launch><node pkg='seer' type='see.py' name='s'/></launch>\n",
    "src/seer/README.md": (
        "# Seer\n\n```\npip install detectron2\nsudo apt install libceres-dev\npython3 scripts/see.py\n```\n"
    ),
}
ARM = {
    "src/arm/package.xml": (
        "<package format='3'><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend>"
        "<export><build_type>ament_cmake</build_type></export></package>"
    ),
    "src/arm/CMakeLists.txt": "project(arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
    "README.md": "ROS 2 Humble\n",
}
PLAIN = {
    "src/lib/package.xml": (
        "<package format='3'><name>lib</name><export><build_type>cmake</build_type></export></package>"
    ),
    "src/lib/CMakeLists.txt": "project(lib)\n",
}
TOLD = "no package of the tree is made for ROS 2, which the image has: seer is for ROS 1"


def brought(decision: Decision) -> set[str]:
    pip = (each.key for each in (*decision.python.pip, *decision.python.pip_guessed, *decision.python.first))
    return {*decision.apt, *decision.apt_guessed, *pip}


def test_what_is_for_the_other_ros_brings_nothing(tree: Tree) -> None:
    decision = tree(ARM | SEER)
    assert (decision.kind, decision.ignored, decision.command) == ("ros2", ("src/seer",), ("bash",))
    assert not brought(decision)
    assert not any(TOLD in each.message for each in decision.warnings)


def test_the_same_is_brought_where_the_package_is_built(tree: Tree) -> None:
    decision = tree(SEER | {"README.md": "ROS Noetic\n"})
    assert {"libpcl-dev", "libceres-dev", "open3d", "detectron2"} <= brought(decision)


@pytest.mark.parametrize("others", [{}, PLAIN])
def test_a_tree_without_a_package_for_the_images_ros_is_told(
    tree: Tree, tmp_path: Path, others: dict[str, str]
) -> None:
    tree(SEER | others)
    decision = decide(gather(Repository.open(tmp_path)), Config(kind="ros2"), folder_name="demo")
    assert decision.kind == "ros2"
    assert any(TOLD in each.message for each in decision.warnings)
