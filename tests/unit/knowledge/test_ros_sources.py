"""Which packages the table of ROS sources finds in a repository."""

from __future__ import annotations

import pytest

from roslab.knowledge.ros_sources import held_by, packages_at, ros_sources

ARM = "https://github.com/xArm-Developer/xarm_ros"


@pytest.mark.parametrize("spelled", [ARM, f"{ARM}.git", ARM.lower()])
def test_a_repository_is_the_same_in_each_spelling(spelled: str) -> None:
    assert "xarm_msgs" in packages_at(spelled)
    assert held_by(spelled, 1, "noetic") == packages_at(spelled)


def test_another_ros_may_have_packages_of_the_same_names_elsewhere() -> None:
    assert held_by(ARM, 2, "humble") == frozenset()
    assert "xarm_msgs" in held_by(f"{ARM}2", 2, "humble")


def test_a_distribution_that_has_the_package_or_is_not_meant_finds_none_there() -> None:
    driver = "https://github.com/ros-industrial/ur_modern_driver"
    assert packages_at(driver) == held_by(driver, 1, "melodic") == {"ur_modern_driver"}
    assert held_by(driver, 1, "indigo") == held_by(driver, 1, "noetic") == set()


def test_of_a_repository_that_it_does_not_name_it_finds_nothing() -> None:
    assert packages_at("https://github.com/nobody/nothing") == set()


def test_a_package_that_left_a_distribution_comes_from_its_last_commit_there() -> None:
    """Every other package of the repository is still released, or lacks what the Ubuntu no longer has."""
    found = ros_sources("ps3joy", 1, "noetic")
    assert [source.repo for source in found] == ["https://github.com/ros-drivers/joystick_drivers.git"]
    assert found[0].prepare.count("CATKIN_IGNORE") == 4
    assert ros_sources("ps3joy", 1, "melodic") == ()


def test_a_repository_with_submodules_holds_what_is_in_them() -> None:
    held = packages_at("https://github.com/whoenig/crazyflie_ros")
    assert {"crazyflie_cpp", "crazyflie_demo", "crazyflie_driver"} <= held
