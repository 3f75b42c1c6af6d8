"""An editor's settings and what a build wrote tell the distribution of the author's machine where no page does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
AMENT = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
CATKIN = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = {AMENT: "project(a)\nfind_package(ament_cmake REQUIRED)\n", CATKIN: "project(a)\nfind_package(catkin)\n"}
SETTINGS = '{\n  "ros.distro": "iron"\n}\n'
INCLUDED = '{"configurations": [{"includePath": ["/opt/ros/iron/include/**"]}]}\n'
CACHE = "actionlib_DIR:PATH=/opt/ros/indigo/share/actionlib/cmake\n"
PREFIX = "colcon_command_prefix_build.sh.env"
APT = "sudo apt-get install -y ros-kinetic-joy ros-kinetic-tf\n"
UNSAID = "nothing says which ROS distribution"


@pytest.mark.parametrize(
    ("manifest", "files", "distro"),
    [
        (AMENT, {".vscode/settings.json": SETTINGS}, "iron"),
        (AMENT, {".vscode/settings.json": SETTINGS, ".vscode/c_cpp_properties.json": INCLUDED}, "iron"),
        (CATKIN, {"ws/build/CMakeCache.txt": CACHE}, "indigo"),
        (CATKIN, {"build/CMakeCache.txt": CACHE, "build/catkin_make.cache": "a\n"}, "indigo"),
        (AMENT, {"install/.colcon_install_layout": "", "install/setup.bash": 'A="/opt/ros/iron"\n'}, "iron"),
        (AMENT, {"build/.built_by": "colcon\n", f"build/a/{PREFIX}": "PATH=/a\nROS_DISTRO=iron\nUSER=b\n"}, "iron"),
        (AMENT, {f"ws/build/a/{PREFIX}": "ROS_DISTRO=iron\n"}, "iron"),
        (CATKIN, {"devel/_setup_util.py": "CMAKE_PREFIX_PATH = '/opt/ros/kinetic'.split(';')\n"}, "kinetic"),
        (AMENT, {".vscode/settings.json": SETTINGS, "README.md": "Tested on ROS 2 Jazzy.\n"}, "jazzy"),
        (CATKIN, {"scripts/run.sh": "#!/bin/bash\nsource /opt/ros/kinetic/setup.bash\n"}, "kinetic"),
        (CATKIN, {"tools/robot.sh": APT}, "kinetic"),
        (CATKIN, {"tools/robot.sh": f"apt purge ros-melodic-joy; {APT}"}, "kinetic"),
        (CATKIN, {"Makefile": f"deps:\n\t{APT}"}, "kinetic"),
        (CATKIN, {"run.sh": f"{APT}source /opt/ros/melodic/setup.bash\n"}, "melodic"),
        (CATKIN, {"apt-packages.txt": "ros-kinetic-joy\nros-kinetic-tf\n"}, "kinetic"),
        (CATKIN, {"ansible/roles/robot.yml": "- apt:\n    name:\n      - ros-kinetic-joy\n"}, "kinetic"),
        (AMENT, {"robot.service": "[Service]\nExecStart=bash -c '. /opt/ros/iron/setup.sh; ros2 run a b'\n"}, "iron"),
    ],
)
def test_the_distribution_of_a_machine(tree: Tree, manifest: str, files: dict[str, str], distro: str) -> None:
    decision = tree({"package.xml": manifest, "CMakeLists.txt": CMAKE[manifest], **files})
    assert decision.ros_distro == distro
    assert not any(UNSAID in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    "files",
    [
        {".vscode/settings.json": '{\n  // "ros.distro": "iron"\n}\n'},
        {"third_party/b/.vscode/settings.json": SETTINGS},
        {".vscode/settings.json": SETTINGS.replace("iron", "noetic")},
        {"run.sh": "# source /opt/ros/iron/setup.bash\n"},
        {"run.sh": "source /opt/ros/iron/setup.bash || source /opt/ros/foxy/setup.bash\n"},
        {"third_party/build/a/" + PREFIX: "ROS_DISTRO=iron\n"},
        {"build/a/" + PREFIX: "ROS_DISTRO=iron_wheels\nMY_ROS_DISTRO=iron\n"},
        {"config/robot.env": "ROS_DISTRO=iron\n"},
        {"third_party/run.sh": "source /opt/ros/iron/setup.bash\n"},
        {"scripts/install_old.sh": "source /opt/ros/iron/setup.bash\n"},
        {"tools/robot.sh": "# apt install ros-iron-joy\n"},
        {"tools/robot.sh": "sudo apt-get -y remove ros-iron-joy && sudo apt autoremove\n"},
        {"tools/robot.sh": "apt install ros-iron-joy || apt install ros-foxy-joy\n"},
        {"config/robot.yaml": "names: [ros-iron-joy]\n"},
        {"names.txt": "ros-iron-joy\n"},
        {"third_party/apt.txt": "ros-iron-joy\n"},
    ],
)
def test_what_tells_of_no_machine(tree: Tree, files: dict[str, str]) -> None:
    plain = {"package.xml": AMENT, "CMakeLists.txt": CMAKE[AMENT]}
    without = tree(plain).ros_distro
    assert without not in {"iron", "foxy", "noetic"}
    assert tree({**plain, **files}).ros_distro == without


TOPLEVEL = "/opt/ros/indigo/share/catkin/cmake/toplevel.cmake"


@pytest.mark.parametrize("linked", [True, False])
def test_the_link_of_catkin_init_workspace(tmp_path: Path, *, linked: bool) -> None:
    (tmp_path / "src/a").mkdir(parents=True)
    (tmp_path / "src/a/package.xml").write_text(CATKIN, encoding="utf-8")
    (tmp_path / "src/a/CMakeLists.txt").write_text(CMAKE[CATKIN], encoding="utf-8")
    if linked:
        (tmp_path / "src/CMakeLists.txt").symlink_to(TOPLEVEL)
    else:
        (tmp_path / "src/CMakeLists.txt").write_text(TOPLEVEL, encoding="utf-8")
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert decision.ros_distro == "indigo"
    assert any("is a link to /opt/ros/indigo" in reason.reason for reason in decision.reasons)


def test_a_link_to_another_place_tells_of_no_machine(tmp_path: Path) -> None:
    (tmp_path / "src").mkdir()
    (tmp_path / "src/CMakeLists.txt").symlink_to("/opt/ros/indigo/share/demo/cmake/toplevel.cmake")
    assert not [m for m in gather(Repository.open(tmp_path)).mentions if m.topic == "machine"]


def test_several_distributions_tell_less_than_the_date(tmp_path: Path) -> None:
    plain = {"package.xml": AMENT, "CMakeLists.txt": CMAKE[AMENT], ".vscode/settings.json": SETTINGS}
    for path, text in {**plain, ".vscode/c_cpp_properties.json": INCLUDED.replace("iron", "foxy")}.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    evidence = gather(Repository.open(tmp_path))
    date = Mention(topic="date", value="2026-10-01", source="commit", file=".git/HEAD", line=1, text="a commit")
    decision = decide(replace(evidence, mentions=(*evidence.mentions, date)), Config(), folder_name="demo")
    assert decision.ros_distro == "jazzy"
    assert any(UNSAID in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    ("manifest", "listed", "distro"),
    [
        (AMENT, "numpy==1.26.4\nrclpy==7.1.3\nros2cli==0.32.2\nlaunch==3.4.3\n", "jazzy"),
        (CATKIN, "cv_bridge==1.16.2\nrospy==1.16.0\nsensor_msgs==1.13.1\ntf==1.13.2\n", "noetic"),
        (CATKIN, "rospy==1.14.13\nroslaunch==1.14.13\nnumpy==1.19\n", "melodic"),
    ],
)
def test_the_distribution_of_a_list_of_a_machine(tree: Tree, manifest: str, listed: str, distro: str) -> None:
    decision = tree({"package.xml": manifest, "CMakeLists.txt": CMAKE[manifest], "requirements.txt": listed})
    assert decision.ros_distro == distro
    assert not any(UNSAID in warning.message for warning in decision.warnings)


@pytest.mark.parametrize("listed", ["rclpy==7.1.3\n", "rclpy>=7.1.3\nros2cli\n", "rclpy==7.1.3\nros2cli==0.18.4\n"])
def test_a_list_that_tells_of_no_machine(tree: Tree, listed: str) -> None:
    plain = {"package.xml": AMENT, "CMakeLists.txt": CMAKE[AMENT]}
    assert tree({**plain, "requirements.txt": listed}).ros_distro == "humble"


@pytest.mark.parametrize(
    ("page", "said", "distro"),
    [
        ("src/a/README.md", "Tested on Ubuntu 18.04 with ROS Melodic.", "noetic"),
        ("src/a/README.md", "Install ROS Kinetic.", "noetic"),
        ("README.md", "Tested on Ubuntu 18.04 with ROS Melodic.", "melodic"),
    ],
)
def test_the_link_tells_more_than_pages_of_packages(tree: Tree, page: str, said: str, distro: str) -> None:
    """Only the workspace's own page tells more than where the author ran catkin."""
    link = TOPLEVEL.replace("indigo", "noetic")
    files = {"src/a/package.xml": CATKIN, "src/a/CMakeLists.txt": CMAKE[CATKIN], "src/CMakeLists.txt": link}
    assert tree({**files, page: f"# a\n\n{said}\n"}).ros_distro == distro


def test_a_link_tells_more_than_what_a_build_wrote(tree: Tree) -> None:
    files = {"src/a/package.xml": CATKIN, "src/a/CMakeLists.txt": CMAKE[CATKIN], "build/CMakeCache.txt": CACHE}
    assert tree({**files, "src/CMakeLists.txt": TOPLEVEL.replace("indigo", "noetic")}).ros_distro == "noetic"


BADGES = """# a
Indigo Trusty [![Build Status](http://build.ros.org/job/Ibin_uT64__a__ubuntu_trusty_amd64__binary/badge/icon)](x)

Melodic Bionic [![Build Status](http://build.ros.org/job/Mbin_uB64__a__ubuntu_bionic_amd64__binary/badge/icon)](x)
"""


@pytest.mark.parametrize(("page", "distro"), [("src/a/README.md", "noetic"), ("README.md", "melodic")])
def test_badges_of_a_package_in_a_workspace_choose_nothing(tree: Tree, page: str, distro: str) -> None:
    files = {"src/a/package.xml": CATKIN, "src/a/CMakeLists.txt": CMAKE[CATKIN], "src/README.md": "For Ubuntu 20.04.\n"}
    assert tree({**files, page: BADGES}).ros_distro == distro
