"""What is said of the keys that the packages declare, where they tell the distribution."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

EVERY = "it has every key that the packages declare"
REST = ", and the code compiles with its libraries"


def decided(folder: Path, *keys: str) -> Decision:
    depends = "".join(f"<depend>{key}</depend>" for key in ("rclcpp", *keys))
    manifest = (
        f'<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>{depends}</package>'
    )
    (folder / "package.xml").write_text(manifest, encoding="utf-8")
    (folder / "CMakeLists.txt").write_text("project(demo)\nfind_package(ament_cmake REQUIRED)\n", encoding="utf-8")
    (folder / "README.md").write_text("# demo\n\nIt runs with ROS 2 Galactic.\n", encoding="utf-8")
    return decide(gather(Repository.open(folder)), Config(), folder_name="demo")


def why(found: Decision) -> str:
    return next(each.reason for each in found.reasons if each.question == "ros_distro")


@pytest.mark.parametrize(
    ("nowhere", "but"),
    [
        ((), ""),
        (("our_own_msgs",), " but our_own_msgs"),
        (
            ("c_own_msgs", "a_own_msgs", "d_own_msgs", "b_own_msgs", "e_own_msgs"),
            " but a_own_msgs, b_own_msgs, c_own_msgs and 2 more",
        ),
    ],
)
def test_a_key_that_the_chosen_one_lacks_too_is_named(tmp_path: Path, nowhere: tuple[str, ...], but: str) -> None:
    found = decided(tmp_path, "delphi_esr_msgs", *nowhere)  # galactic has none, humble has
    assert found.ros_distro == "jazzy"
    assert why(found) == f"{EVERY}{but}{REST}"


def test_a_key_that_no_distribution_has_tells_nothing_against_a_named_one(tmp_path: Path) -> None:
    assert decided(tmp_path, "our_own_msgs").ros_distro == "galactic"
