"""Dates against release windows."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Config, Kind
from roslab.decide import decide
from roslab.decide.ros.distro_dates import of_its_time
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.knowledge.distros import distros
from roslab.repository.checkout import Repository

NEWEST = max((found for found in distros().values() if found.eol), key=lambda found: found.released).name


@pytest.mark.parametrize(
    ("kind", "date", "name"),
    [
        ("ros1", None, "noetic"),
        ("ros1", "2013-01-01", "indigo"),
        ("ros1", "2016-06-01", "indigo"),
        ("ros1", "2018-02-12", "kinetic"),
        ("ros1", "2019-09-01", "melodic"),
        ("ros1", "2021-02-23", "melodic"),
        ("ros1", "2021-06-01", "noetic"),
        ("ros1", "2026-11-21", "noetic"),
        ("ros2", None, "humble"),
        ("ros2", "2019-01-01", "dashing"),
        ("ros2", "2022-03-01", "foxy"),
        ("ros2", "2024-03-01", "humble"),
        ("ros2", "2025-05-22", "humble"),
        ("ros2", "2026-11-21", "jazzy"),
        ("ros2", "2028-01-01", "jazzy"),
        ("ros2", "2140-01-01", NEWEST),
    ],
)
def test_the_distribution_of_a_time(kind: Kind, date: str | None, name: str) -> None:
    assert of_its_time(kind, date) == name


def test_a_date_speaks_only_where_nothing_else_does(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nfind_package(catkin REQUIRED)\n")
    date = Mention(topic="date", value="2018-02-12", source="commit", file=".git/HEAD", line=1, text="")

    def named(*, readme: str = "") -> tuple[str | None, str]:
        (tmp_path / "README.md").write_text(readme)
        evidence = gather(Repository.open(tmp_path))
        evidence = replace(evidence, mentions=(*evidence.mentions, date))
        found = decide(evidence, Config(), folder_name="a")
        reason = next(reason for reason in found.reasons if reason.question == "ros_distro" and reason.decisive)
        return found.ros_distro, reason.reason

    distro, reason = named()
    assert (distro, "2018-02-12" in reason) == ("kinetic", True)
    assert named(readme="Tested with ROS Melodic.\n")[0] == "melodic"


@pytest.mark.parametrize(("date", "name"), [("2024-11-08", "kilted"), ("2140-01-01", "rolling")])
def test_rolling_is_what_it_was_at_the_last_commit(tmp_path: Path, date: str, name: str) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nfind_package(ament_cmake REQUIRED)\n")
    evidence = gather(Repository.open(tmp_path, branch="rolling"))
    mention = Mention(topic="date", value=date, source="commit", file=".git/HEAD", line=1, text="")
    decided = decide(replace(evidence, mentions=(*evidence.mentions, mention)), Config(), folder_name="a")
    assert decided.ros_distro == name


@pytest.mark.parametrize(
    ("code", "name"),
    [
        ("", "humble"),
        ("#include <cv_bridge/cv_bridge.h>\n", "humble"),
        ("#include <cv_bridge/cv_bridge.h>\nceres::Manifold* manifold;\n", "humble"),  # Ceres is built there
    ],
)
def test_todays_rolling_is_not_taken_for_code_of_an_earlier_day(tmp_path: Path, code: str, name: str) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    )
    cmake = "project(a)\nfind_package(ament_cmake REQUIRED)\nfind_package(Ceres REQUIRED)\nadd_executable(a a.cpp)\n"
    (tmp_path / "CMakeLists.txt").write_text(f"{cmake}ament_target_dependencies(a rclcpp)\n")
    (tmp_path / "a.cpp").write_text(f"{code}int main() {{}}\n")
    evidence = gather(Repository.open(tmp_path))
    mention = Mention(topic="date", value="2024-10-07", source="commit", file=".git/HEAD", line=1, text="")
    decided = decide(replace(evidence, mentions=(*evidence.mentions, mention)), Config(), folder_name="a")
    assert decided.ros_distro == name


@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("Requires ROS Indigo+.", "kinetic"),
        ("ROS Indigo or newer must be installed.", "kinetic"),
        ("Install [ROS Indigo](http://wiki.ros.org/indigo) (or later).", "kinetic"),
        ("Works with ROS Hydro and above.", "kinetic"),
        ("Install ROS Indigo Igloo or higher.", "kinetic"),
        ("Install ROS Indigo, Jade or newer.", "kinetic"),
        ("Requires ROS >= Indigo.", "kinetic"),
        ("Install ROS Melodic or newer.", "melodic"),
        ("ROS Indigo or newer. Tested on ROS Jade.", "jade"),
        ("ROS Indigo or newer on Ubuntu 14.04.", "indigo"),
        ("ROS Kinetic or newer on Ubuntu 14.04.", "kinetic"),
        ("Install ROS Indigo and later with catkin a workspace.", "indigo"),
        ("Install ROS Indigo + Gazebo.", "indigo"),
        ("Ubuntu 14.04 or newer.", "kinetic"),
        ("Ubuntu 18.04+.", "melodic"),
        ("Ubuntu 14.04 + Gazebo.", "indigo"),
        ("Ubuntu 14.04.", "indigo"),
        ("Ubuntu 14.04 or newer with ROS Indigo.", "indigo"),
        ("Install ROS Indigo or Jade.", "indigo"),
    ],
)
def test_the_oldest_distribution_that_works_is_not_what_it_was_made_on(tmp_path: Path, page: str, name: str) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nfind_package(catkin REQUIRED)\n")
    (tmp_path / "README.md").write_text(f"# A\n\n{page}\n")
    date = Mention(topic="date", value="2018-02-12", source="commit", file=".git/HEAD", line=1, text="")
    evidence = gather(Repository.open(tmp_path))
    decided = decide(replace(evidence, mentions=(*evidence.mentions, date)), Config(), folder_name="a")
    assert decided.ros_distro == name


@pytest.mark.parametrize(("more", "name"), [("<depend>rtcm_msgs</depend>", "noetic"), ("", "jade")])
def test_an_address_of_a_distribution_without_a_declared_package_tells_less_than_the_date(
    tmp_path: Path, more: str, name: str
) -> None:
    (tmp_path / "package.xml").write_text(
        f"<package format='2'><name>a</name><buildtool_depend>catkin</buildtool_depend>{more}</package>"
    )
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nfind_package(catkin REQUIRED)\n")
    (tmp_path / "README.md").write_text("[Twist](http://docs.ros.org/jade/api/geometry_msgs/html/msg/Twist.html)\n")
    date = Mention(topic="date", value="2022-12-06", source="commit", file=".git/HEAD", line=1, text="")
    evidence = gather(Repository.open(tmp_path))
    decided = decide(replace(evidence, mentions=(*evidence.mentions, date)), Config(), folder_name="a")
    assert decided.ros_distro == name


@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("Ubuntu 18.04+", "focal"),
        ("Requires Ubuntu 18.04 or newer.", "focal"),
        ("Ubuntu 18.04 LTS (or later)", "focal"),
        ("Ubuntu 18.04 (Bionic) or above", "focal"),
        ("Ubuntu >= 18.04", "focal"),
        ("Ubuntu 16.04, 18.04 and above", "focal"),
        ("Ubuntu 22.04+", "jammy"),
        ("Ubuntu 18.04", "bionic"),
        ("Ubuntu 18.04 + CUDA", "bionic"),
        ("Ubuntu 18.04+CUDA", "bionic"),
        ("Ubuntu 18.04 or newer. Tested on Ubuntu 22.04.", "jammy"),
        ("Ubuntu 16.04 or newer. Tested on Ubuntu 18.04.", "bionic"),
    ],
)
def test_the_oldest_ubuntu_that_works_is_not_what_it_was_made_on(tmp_path: Path, page: str, name: str) -> None:
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nadd_executable(a a.cpp)\n")
    (tmp_path / "README.md").write_text(f"# A\n\n{page}\n")
    date = Mention(topic="date", value="2021-10-12", source="commit", file=".git/HEAD", line=1, text="")
    evidence = gather(Repository.open(tmp_path))
    decided = decide(replace(evidence, mentions=(*evidence.mentions, date)), Config(), folder_name="a")
    assert decided.ubuntu == name


_IS = 'if("$ENV{{ROS_DISTRO}}" {}"{}")\n'


@pytest.mark.parametrize(
    ("how", "names", "page", "name"),
    [
        ("STREQUAL ", ("indigo", "jade"), "", "indigo"),
        ("MATCHES ", ("noetic", "melodic"), "", "noetic"),
        ("STREQUAL ", ("jade",), "", "kinetic"),
        ("STREQUAL ", ("noetic", "melodic"), "Tested with ROS Kinetic.\n", "kinetic"),
        ("STREQUAL ", ("humble", "jazzy"), "", "kinetic"),
        ("STRLESS ", ("noetic", "melodic"), "", "kinetic"),
        ("# STREQUAL ", ("noetic", "melodic"), "", "kinetic"),
    ],
)
def test_what_cmake_compares_the_distribution_with_tells_a_little(
    tmp_path: Path, how: str, names: tuple[str, ...], page: str, name: str
) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    )
    cmake = "".join(f"{_IS.format(how, each)}endif()\n" for each in names)
    (tmp_path / "CMakeLists.txt").write_text(f"project(a)\nfind_package(catkin REQUIRED)\n{cmake}")
    (tmp_path / "README.md").write_text(page)
    date = Mention(topic="date", value="2018-02-12", source="commit", file=".git/HEAD", line=1, text="")
    evidence = gather(Repository.open(tmp_path))
    decided = decide(replace(evidence, mentions=(*evidence.mentions, date)), Config(), folder_name="a")
    assert decided.ros_distro == name


@pytest.mark.parametrize(
    ("more", "date", "name"),
    [
        ("find_package(PCL 1.8 REQUIRED)\n", "2019-02-05", "melodic"),
        ("find_package(PCL 1.8 REQUIRED)\n", "2021-02-05", "melodic"),
        ("find_package(PCL 1.8 REQUIRED)\n", "2017-02-05", "noetic"),
        ("find_package(PCL 1.7 REQUIRED)\n", "2019-02-05", "kinetic"),
    ],
)
def test_what_fits_the_code_is_of_the_time_of_the_last_commit(tmp_path: Path, more: str, date: str, name: str) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text(f"project(a)\nfind_package(catkin REQUIRED)\n{more}")
    said = Mention(topic="date", value=date, source="commit", file=".git/HEAD", line=1, text="")
    evidence = gather(Repository.open(tmp_path))
    decided = decide(replace(evidence, mentions=(*evidence.mentions, said)), Config(), folder_name="a")
    assert decided.ros_distro == name


@pytest.mark.parametrize(
    ("condition", "name"),
    [
        ('(($ENV{ROS_DISTRO} MATCHES "other") OR ($ENV{ROS_DISTRO} MATCHES "lunar"))', "lunar"),
        ('("$ENV{ROS_DISTRO}" STREQUAL "melodic" OR "$ENV{ROS_DISTRO}" STREQUAL "noetic")', "noetic"),
        ('($ENV{ROS_DISTRO} MATCHES "other") # or $ENV{ROS_DISTRO} MATCHES "lunar"', "noetic"),
    ],
)
def test_one_condition_may_compare_the_distribution_with_several(tmp_path: Path, condition: str, name: str) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text(f"project(a)\nfind_package(catkin REQUIRED)\nif{condition}\nendif()\n")
    assert decide(gather(Repository.open(tmp_path)), Config(), folder_name="a").ros_distro == name


@pytest.mark.parametrize(
    ("page", "distro"),
    [("old/README.md", "melodic"), ("a/README.md", "kinetic"), ("README.md", "kinetic"), ("docs/README.md", "kinetic")],
)
def test_a_date_tells_more_than_an_address_on_a_page_about_no_package(tmp_path: Path, page: str, distro: str) -> None:
    files = {
        "a/package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>",
        "a/CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n",
        page: "Code derived from https://github.com/lab/ros-cal/tree/kinetic-devel/cal\n",
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    evidence = gather(Repository.open(tmp_path))
    date = Mention(topic="date", value="2021-02-23", source="commit", file=".git/HEAD", line=1, text="")
    evidence = replace(evidence, mentions=(*evidence.mentions, date))
    assert decide(evidence, Config(), folder_name="a").ros_distro == distro


@pytest.mark.parametrize(
    ("starts", "day", "more", "distro"),
    [
        (("gazebo_ros",), "2025-08-01", {}, "humble"),
        (("gazebo_ros", "ros_gz_sim"), "2025-08-01", {}, "humble"),
        (("ros_gz_sim",), "2025-08-01", {}, "jazzy"),
        (("gazebo_ros", "acme_robot"), "2025-08-01", {}, "humble"),  # nobody released the other
        (("gazebo_ros",), "2025-08-01", {"README.md": "For ROS 2 Jazzy\n"}, "jazzy"),
        (("gazebo_ros",), "2025-08-01", {"README.md": "https://github.com/lab/gazebo_ros\n"}, "jazzy"),
        (("gazebo_ros",), "2028-01-01", {}, "jazzy"),  # humble has ended by then
    ],
)
def test_what_launch_files_start(
    tmp_path: Path, starts: tuple[str, ...], day: str, more: dict[str, str], distro: str
) -> None:
    nodes = ", ".join(f"Node(package='{name}', executable='a')" for name in starts)
    files = {
        "package.xml": "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
        "CMakeLists.txt": "find_package(ament_cmake REQUIRED)\ninstall(DIRECTORY launch DESTINATION share/a)\n",
        "launch/a.launch.py": f"def generate_launch_description():\n    return LaunchDescription([{nodes}])\n",
        **more,
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    date = Mention(topic="date", value=day, source="commit", file=".git/HEAD", line=1, text="")
    evidence = gather(Repository.open(tmp_path))
    evidence = replace(evidence, mentions=(*evidence.mentions, date))
    assert decide(evidence, Config(), folder_name="a").ros_distro == distro
