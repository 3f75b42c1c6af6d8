"""Code of ROS without a package.xml, and the script that an author's image starts with."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GUARD = "if __name__ == '__main__':\n    main()\n"
GUARDED = "try:\n    import rospy\nexcept ImportError:\n    pass\n"
NODE = "import rospy\nimport tf\n"
DOCKERFILE = "FROM ros:noetic-ros-base\nCOPY . /bags\nRUN pip install -e /bags\n"
CATKIN = "project(bags)\nfind_package(catkin)\ncatkin_package()\n"
MANIFEST = "package.xml"
SETUP = {"setup.py": "from setuptools import setup\nsetup(name='bags', install_requires=['tqdm'])\n"}


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"bags/convert.py": f"import numpy\nimport rospy\nimport rosbag\n{GUARD}"}, "ros1"),
        ({"bags/convert.py": f"import numpy\nimport rclpy\n{GUARD}"}, "ros2"),
        (
            {"bags/convert.py": f"import numpy\n{GUARDED}{GUARD}"},
            "python",
        ),
        (
            {"bags/convert.py": f"import numpy\nimport cv2\n{GUARD}", "bags/node.py": "import rospy\nimport tf\n"},
            "python",
        ),
        ({"bags/convert.py": f"import numpy\n{GUARD}", "examples/node.py": NODE}, "python"),
        ({"bags/convert.py": f"import torch\nimport rospy\n{GUARD}"}, "cuda"),
    ],
)
def test_a_program_that_imports_what_only_ros_brings(tree: Tree, files: dict[str, str], kind: str) -> None:
    assert tree({**SETUP, **files}).kind == kind


@pytest.mark.parametrize(
    ("last", "command"),
    [
        ('exec bags-convert "$@"', ("bags-convert",)),
        ("exec python3 -m bags $@", ("python3", "-m", "bags")),
        ('exec "$@"', ("bash",)),
        ('exec -- "$@"', ("bash",)),
        ('exec -- bags-convert "$@"', ("bags-convert",)),
        ('exec bags-convert "$@"\nsleep 1', ("bash",)),
    ],
)
def test_a_script_that_gives_all_arguments_to_one_program(tree: Tree, last: str, command: tuple[str, ...]) -> None:
    files = {
        "bags/convert.py": "import numpy\nimport rospy\n",
        "Dockerfile": f'{DOCKERFILE}ENTRYPOINT ["/bags/entrypoint.sh"]\n',
        "entrypoint.sh": f"#!/bin/bash\nset -e\nsource /opt/ros/noetic/setup.bash\n{last}\n",
    }
    decision = tree({**SETUP, **files})
    assert (decision.dockerfile, decision.command) == ("Dockerfile", command)


@pytest.mark.parametrize(
    ("more", "packages", "projects"),
    [({}, (), (".",)), ({"CMakeLists.txt": CATKIN}, (MANIFEST,), ())],
)
def test_a_project_of_setup_py_that_catkin_cannot_build_is_pips(
    tree: Tree, more: dict[str, str], packages: tuple[str, ...], projects: tuple[str, ...]
) -> None:
    package = "<package><name>bags</name><version>1.0.0</version><buildtool_depend>catkin</buildtool_depend></package>"
    decision = tree({**SETUP, MANIFEST: package, "bags/convert.py": f"import numpy\nimport rospy\n{GUARD}", **more})
    assert decision.kind == "ros1"
    assert (decision.packages, decision.python.projects) == (packages, projects)
