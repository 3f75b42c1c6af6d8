"""Which keys of rosdep are skipped: those whose package apt does not have, or has under another name already."""

from __future__ import annotations

from pathlib import Path

from failed_builds import log, repaired

ROS = {
    "package.xml": '<package format="3"><name>arm</name><version>1.0.0</version><description>d</description>'
    '<maintainer email="a@example.org">a</maintainer><license>MIT</license>'
    "<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend></package>\n",
    "CMakeLists.txt": "project(arm)\n",
    "roslab.yaml": "format: 3\nbase: {ros: humble}\n",
}
STEP = "install-rosdep-keys --required /tmp/manifests"


def changes(folder: Path, *lines: str) -> list[str]:
    return [f"{change.key}: {change.value}" for change in repaired(folder, log(STEP, *lines), ROS).changes]


def test_the_key_of_a_package_whose_files_another_of_this_ros_has_is_skipped(tmp_path: Path) -> None:
    found = changes(
        tmp_path,
        "dpkg: error processing archive /var/cache/apt/archives/ros-humble-ros-gz-sim_0.244.24-1_amd64.deb (--unpack):",
        " trying to overwrite '/opt/ros/humble/include/ros_gz_sim/a.hpp', which is also in package"
        " ros-humble-ros-gzharmonic-sim 0.244.12-1000~jammy",
    )
    assert found == ["skip_keys: ros_gz_sim"]


def test_a_package_of_another_repository_keeps_its_key(tmp_path: Path) -> None:
    found = changes(
        tmp_path,
        "dpkg: error processing archive /var/cache/apt/archives/ros-humble-ros-gz-sim_0.244.24-1_amd64.deb (--unpack):",
        " trying to overwrite '/usr/include/a.hpp', which is also in package libarm-dev 1.0",
    )
    assert found == []


def test_the_key_of_a_clone_s_package_that_apt_does_not_have_is_skipped(tmp_path: Path) -> None:
    found = changes(tmp_path, "  apt: Failed to detect successful installation of [ros-humble-ros-gz-sim]")
    assert found == ["skip_keys: ros_gz_sim"]
    assert changes(tmp_path, "  apt: Failed to detect successful installation of [ros-humble-no-such-arm]") == []
