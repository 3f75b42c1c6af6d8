"""Parts of modules that the distribution's package does not have yet come from pip, in an image of ROS."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package format='3'><name>eyes</name><exec_depend>rclpy</exec_depend>"
    "<export><build_type>ament_python</build_type></export></package>",
    "setup.py": "from setuptools import setup\nsetup(name='eyes', packages=['eyes'])\n",
    "README.md": "    source /opt/ros/humble/setup.bash\n",
}
CODE = "import cv2\nimport rclpy\n"


@pytest.mark.parametrize(
    ("code", "there"),
    [
        ("from cv2.typing import MatLike\n", True),
        ("import cv2.typing\n", True),
        ("from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from cv2.typing import MatLike\n", False),
        ("import typing\n", False),
    ],
)
def test_cv2_typing_needs_a_newer_opencv_than_the_distributions(tree: Tree, code: str, *, there: bool) -> None:
    found = tree({**FILES, "eyes/look.py": f"{CODE}{code}"})
    assert ("opencv-python>=4.8.0.76" in {each.written for each in found.python.pip_guessed}) is there
    assert "python3-opencv" in found.apt_guessed  # where pip fails, all but that part is there


def test_beside_cv_bridge_numpy_stays_its_own(tree: Tree) -> None:
    found = tree({**FILES, "eyes/look.py": f"{CODE}import cv_bridge\nfrom cv2.typing import MatLike\n"})
    assert "numpy<2" in {each.written for each in found.python.bounds}


def test_an_opencv_that_is_listed_is_the_only_one(tree: Tree) -> None:
    lists = {"README.md": "    pip install -r requirements.txt\n", "requirements.txt": "opencv-python-headless\n"}
    found = tree({**FILES, **lists, "eyes/look.py": f"{CODE}from cv2.typing import MatLike\n"})
    assert [each.key for each in found.pip if "opencv" in each.key] == ["opencv-python-headless"]


def test_without_ros_the_newest_is_taken_anyway(tree: Tree) -> None:
    found = tree({"run.py": "import cv2\nfrom cv2.typing import MatLike\n"})
    assert [each.written for each in found.pip if "opencv" in each.key] == ["opencv-python"]


ROTATION = "import rclpy\nfrom scipy.spatial.transform import Rotation as R\n"


@pytest.mark.parametrize(
    ("distro", "code", "found"),
    [
        ("noetic", "R.from_quat(q).as_matrix()", "scipy>=1.4,<1.9"),
        ("noetic", "rotation = R.from_matrix(m)", "scipy>=1.4,<1.9"),
        ("noetic", "R.from_quat(q).as_euler('xyz')", ""),
        ("noetic", "r = R.as_matrix(q) if new else r.as_dcm()", ""),
        ("noetic", "r.inv().as_quat()  # .as_matrix", ""),
        ("noetic", "from scipy.spatial import cKDTree\nR.from_quat(q).as_matrix()", "scipy>=1.4,<1.9"),
        ("noetic", "from scipy.spatial.transform import Slerp\nR.from_quat(q).as_matrix()", "scipy>=1.4,<1.9"),
        ("melodic", "R.from_quat(q).as_euler('xyz')", "scipy>=1.2,<1.5"),
        ("melodic", "R.from_quat(q).as_matrix()", "scipy>=1.4,<1.5"),
        ("humble", "R.from_quat(q).as_matrix()", ""),
    ],
)
def test_rotations_need_a_newer_scipy_than_old_distributions_have(
    tree: Tree, distro: str, code: str, found: str
) -> None:
    page = {"README.md": f"    source /opt/ros/{distro}/setup.bash\n"}
    if distro != "humble":
        page["package.xml"] = "<package><name>eyes</name><buildtool_depend>catkin</buildtool_depend></package>"
        page["CMakeLists.txt"] = "project(eyes)\nfind_package(catkin REQUIRED)\n"
        page["setup.py"] = ""
    code = ROTATION.replace("rclpy", "rospy" if distro != "humble" else "rclpy") + code + "\n"
    decided = tree({**FILES, **page, "eyes/turn.py": code})
    assert [each.written for each in decided.python.pip_guessed if each.key == "scipy"] == ([found] if found else [])
    assert any(each.endswith("-scipy") for each in decided.apt_guessed)


def test_a_scipy_that_is_listed_is_the_only_one(tree: Tree) -> None:
    lists = {"README.md": "    pip install -r requirements.txt\n", "requirements.txt": "scipy\n"}
    decided = tree({"run.py": f"{ROTATION.partition(chr(10))[2]}R.from_matrix(m)\n", **lists})
    assert [each.written for each in decided.pip if each.key == "scipy"] == ["scipy"]
