"""A Python library whose page calls ROS optional gets an image of plain Python, without what a robot's image has."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Base, Config
from roslab.decide.decision import Decision
from trees import decided

HEADING = "# Arm\n\n### Preparation for ROS (only required if you want to use the real robot)\n\nInstall ROS Kinetic.\n"
SETUP = "from setuptools import setup\nsetup(name='arm', packages=['arm'], install_requires=['numpy', 'pybullet'])\n"
ROBOT = (
    "FROM ubuntu:16.04\nENV ROS_DISTRO kinetic\nRUN apt-get install -y ros-kinetic-moveit gazebo7\nRUN sh torch.sh\n"
)
FILES = {
    "setup.py": SETUP,
    "arm/__init__.py": "",
    "arm/real.py": "import rospy\nimport numpy\n",
    "arm/simulated.py": "import pybullet\nimport numpy\n",
    "docker/robot.dockerfile": ROBOT,
    "docker/torch.sh": "pip install torch\nsudo apt-get install -y tmux\n",
}
PACKAGE = {
    "ws/arm/package.xml": "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
    "ws/arm/CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
}
FOR_ALL = (
    "You do not need to install ROS if you use our Docker image.",
    "You do not need to install ROS if you\nuse our Docker image.",
    "ROS is not required when you use the Docker image.",
    "ROS is only needed for building.",
    "ROS is only required to run the code.",
    "ROS is not required to be built from source, install the packages.",
)


def _decided(folder: Path, page: str, more: dict[str, str] | None = None, config: Config | None = None) -> Decision:
    files = {**FILES, "README.md": page, **(more or {})}
    return decided(folder, files, config=config)


@pytest.mark.parametrize(
    "page",
    [
        HEADING,
        "# Arm\n\nROS is only needed for the real robot. In simulation, ROS Kinetic is of no use.\n",
        "# Arm\n\nROS 1 is not required if you simulate. It was tested with ROS Kinetic.\n",
        "# Arm\n\n- **ROS** (optional): Kinetic\n",
        "# Arm\n\n- *(Optional)* **ROS 2:** Humble\n",
        "# Arm\n\nROS is only needed to build the ROS wrapper. Use our Docker image or install ROS Kinetic.\n",
        "# Arm\n\nYou don't need ROS for the simulation. It was tested with ROS Kinetic.\n",
    ],
)
def test_plain_python(tmp_path: Path, page: str) -> None:
    found = _decided(tmp_path, page)
    assert (found.kind, found.ros_distro, found.dockerfile) == ("python", None, None)
    apt = {*found.apt, *found.apt_guessed}
    assert not any(name.startswith("ros-") for name in apt)
    assert apt.isdisjoint({"gazebo7", "tmux"})
    assert any("says that not everybody needs ROS" in warning.message for warning in found.warnings)


@pytest.mark.parametrize(
    ("page", "more"),
    [
        ("# Arm\n\nInstall ROS Kinetic.\n", {}),
        ("# Arm\n\nROS packages are only read if asked for. Install ROS Kinetic.\n", {}),
        ("# Arm\n\nThe option `--ros-args` is optional. Install ROS Kinetic.\n", {}),
        *((f"# Arm\n\n{said} It was tested with ROS Kinetic.\n", {}) for said in FOR_ALL),
        (HEADING, {"setup.py": ""}),
        (HEADING, PACKAGE),
    ],
)
def test_of_ros(tmp_path: Path, page: str, more: dict[str, str]) -> None:
    found = _decided(tmp_path, page, more)
    assert "tmux" in {*found.apt, *found.apt_guessed}
    assert not any("says that not everybody needs ROS" in warning.message for warning in found.warnings)


PLAIN = "FROM nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04\nRUN apt-get update && apt-get install -y libarm-dev\n"


@pytest.mark.parametrize("script", ["", "COPY . /arm\nRUN bash /arm/weights.sh\n"])
@pytest.mark.parametrize("robot", [True, False])
def test_a_dockerfile_without_ros_stays(tmp_path: Path, script: str, *, robot: bool) -> None:
    more = {"docker/Dockerfile": PLAIN + script} | ({} if robot else {"docker/robot.dockerfile": ""})
    found = _decided(tmp_path, HEADING, more)
    assert (found.ros_distro, found.cuda) == (None, "11.3")
    assert "gazebo7" not in {*found.apt, *found.apt_guessed}


def test_who_chooses_ros_has_it(tmp_path: Path) -> None:
    found = _decided(tmp_path, HEADING, config=Config(base=Base(ros="kinetic")))
    assert (found.kind, found.ros_distro) == ("ros1", "kinetic")
    assert "gazebo7" in found.apt_guessed


def test_a_dockerfile_that_the_page_builds_is_kept(tmp_path: Path) -> None:
    page = f"{HEADING}\n## Docker\n```\ndocker build -f docker/Dockerfile -t arm .\n```\n"
    copies = 'FROM ros:noetic\nCOPY . /arm\nRUN pip3 install /arm\nCMD ["python3", "/arm/arm/real.py"]\n'
    found = _decided(tmp_path, page, {"docker/Dockerfile": copies})
    assert (found.kind, found.dockerfile) == ("ros1", "docker/Dockerfile")
