"""Nodes for Python 3 that import what ROS compiles for its own Python: before noetic that is Python 2."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

CATKIN = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>rospy</depend></package>"
CMAKE = "project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
NODE = "#!/usr/bin/env python3\nimport rospy\nfrom cv_bridge import CvBridge\nrospy.init_node('a')\n"
FILES = {"a/package.xml": CATKIN, "a/CMakeLists.txt": CMAKE, "a/scripts/node.py": NODE}
OWN = {"cv_bridge/package.xml": CATKIN.replace(">a<", ">cv_bridge<"), "cv_bridge/CMakeLists.txt": CMAKE}
CLONED = {".rosinstall": "- git: {local-name: vision_opencv, uri: https://github.com/ros-perception/vision_opencv}\n"}
DAY = "2023-04-25"
COMPILED = "is compiled for Python 2.7"


@pytest.mark.parametrize(
    ("node", "date", "distro"),
    [
        (NODE, "2021-01-15", "noetic"),
        (NODE.replace("from cv_bridge import CvBridge", "import tf"), "2021-01-15", "noetic"),
        (NODE, "2020-01-15", "melodic"),
        (NODE.replace("python3", "python"), "2021-01-15", "melodic"),
        (NODE.replace("from cv_bridge import CvBridge", "import yaml"), "2021-01-15", "melodic"),
    ],
)
def test_the_distribution(tmp_path: Path, node: str, date: str, distro: str) -> None:
    found = decided(tmp_path, {**FILES, "a/scripts/node.py": node}, date)
    assert found.ros_distro == distro


WITH_IT = CATKIN.replace("</package>", "<exec_depend>python-pathlib</exec_depend></package>")
PATHS = "import rospy\nfrom pathlib import Path\nrospy.init_node('a')\n"


@pytest.mark.parametrize(
    ("files", "date", "distro"),
    [
        ({"a/scripts/node.py": PATHS}, "2021-01-15", "noetic"),
        ({"a/scripts/node.py": f"#!/usr/bin/env python\n{PATHS}"}, "2021-01-15", "noetic"),
        ({"a/scripts/node.py": PATHS}, "2020-01-15", "melodic"),
        ({"a/scripts/node.py": f"#!/usr/bin/env python3\n{PATHS}"}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS.replace("rospy", "numpy")}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS.replace("from", "try:\n  from", 1)}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS, "requirements.txt": "pathlib\n"}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS, "README.md": "Tested on ROS Melodic.\n"}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS.replace("pathlib", "functools32")}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS, "a/package.xml": WITH_IT}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS, "README.md": "`sudo apt install python-pathlib`\n"}, "2021-01-15", "melodic"),
        ({"a/scripts/node.py": PATHS, "README.md": "`pip install pathlib`\n"}, "2021-01-15", "melodic"),
    ],
    ids=[
        "none",
        "python",
        "before",
        "python3",
        "no node",
        "caught",
        "installed",
        "named",
        "of Python 2",
        *("key", "by apt", "by pip"),
    ],
)
def test_what_python_3_alone_has(tmp_path: Path, files: dict[str, str], date: str, distro: str) -> None:
    assert decided(tmp_path, {**FILES, **files}, date).ros_distro == distro


@pytest.mark.parametrize(
    ("page", "more", "told"),
    [
        ("Tested on ROS Melodic.\n", {}, True),
        ("Tested on ROS Noetic.\n", {}, False),
        ("Tested on ROS Melodic with Python 2.7.\n", {}, False),
        ("Tested on ROS Melodic.\n", OWN, False),
        ("Tested on ROS Melodic.\n", CLONED, False),
        ("Tested on ROS Melodic.\n", {"scripts/old.py": "#!/usr/bin/env python\nimport rospy\n"}, False),
    ],
)
def test_what_does_not_load_is_told(tmp_path: Path, page: str, more: dict[str, str], told: bool) -> None:
    found = decided(tmp_path, {**FILES, "README.md": page, **more}, DAY)
    assert any(COMPILED in warning.message for warning in found.warnings) == told


def test_a_python_that_the_page_names_and_ros_has_not_is_told(tmp_path: Path) -> None:
    found = decided(tmp_path, {**FILES, "README.md": "Tested on ROS Melodic.\n\n- Python 3.8\n"}, DAY)
    assert any(w.message.startswith("Python 3.8 is asked for") and "is 3.6" in w.message for w in found.warnings)
    at_least = decided(tmp_path, {**FILES, "README.md": "Tested on ROS Melodic.\n\n- Python 3.6+\n"}, DAY)
    assert not any("is asked for" in warning.message for warning in at_least.warnings)


@pytest.mark.parametrize(
    ("node", "wanted", "other"),
    [
        (NODE, {"python3-yaml", "python3-scipy", "python3-tk"}, {"python-yaml", "python-scipy", "python-tk"}),
        (NODE.replace("python3", "python"), {"python-yaml", "python-scipy", "python-tk"}, {"python3-scipy"}),
    ],
)
def test_what_modules_import_is_for_the_python_of_the_nodes(
    tmp_path: Path, node: str, wanted: set[str], other: set[str]
) -> None:
    module = "import yaml\nimport scipy\nimport matplotlib\n"
    files = {**FILES, "a/scripts/node.py": node, "a/src/a/draw.py": module, "README.md": "Tested on ROS Melodic.\n"}
    found = decided(tmp_path, files, DAY)
    assert found.ros_distro == "melodic"
    assert wanted <= {*found.apt_guessed}
    assert other.isdisjoint(found.apt_guessed)
