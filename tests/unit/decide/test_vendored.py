"""Libraries of Gazebo come from ROS where it packages them, whatever pages install."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>{}'
    "<export><build_type>ament_cmake</build_type></export></package>"
)
PAGE = "# ROS 2 {}\n```bash\nsudo apt install {}\n```\n"


@pytest.mark.parametrize(
    ("distro", "depend", "said", "found", "other"),
    [
        ("Jazzy", "gz-sim8", "libgz-sim8-dev", "ros-jazzy-gz-sim-vendor", "libgz-sim8-dev"),
        ("Jazzy", "", "libgz-sim8-dev rapidjson-dev", "ros-jazzy-gz-sim-vendor", "libgz-sim8-dev"),
        ("Humble", "gz-sim8", "libgz-sim8-dev", "libgz-sim8-dev", "ros-humble-gz-sim-vendor"),
        ("Jazzy", "", "libgz-sim7-dev", "libgz-sim7-dev", "ros-jazzy-gz-sim-vendor"),
    ],
)
def test_of_a_page_and_of_a_key(  # noqa: PLR0917 - a row each
    tree: Tree, distro: str, depend: str, said: str, found: str, other: str
) -> None:
    files = {
        "package.xml": MANIFEST.format(f"<depend>{depend}</depend>" if depend else ""),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "README.md": PAGE.format(distro, said),
    }
    installed = {*(decision := tree(files)).apt, *decision.apt_guessed}
    assert found in installed
    assert other not in installed


@pytest.mark.parametrize(
    ("call", "found"),
    [
        ("gz_find_package(gz-sim8 REQUIRED COMPONENTS core)", True),
        ("gz_find_package(TINYXML2 REQUIRED PRIVATE_FOR gz-sim8)", False),
    ],
)
def test_what_gazebo_s_own_call_finds_is_needed(tree: Tree, call: str, *, found: bool) -> None:
    files = {
        "package.xml": MANIFEST.format(""),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n"
        f"find_package(gz-cmake3 REQUIRED)\n{call}\n",
        "README.md": "# ROS 2 Jazzy\n",
    }
    decision = tree(files)
    assert ("ros-jazzy-gz-sim-vendor" in {*decision.apt, *decision.apt_guessed}) is found
    assert not [w for w in decision.warnings if "TINYXML2" in w.message]
