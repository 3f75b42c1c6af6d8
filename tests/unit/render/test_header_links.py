"""Headers of two packages of an Ubuntu that contradict each other where one file includes both."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile

PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
MADE = "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(PCL REQUIRED)\nadd_executable(demo demo.cpp)\n"
LZ4 = "/usr/include/flann/ext/lz4.h"


def planned(folder: Path, page: str, *headers: str) -> Plan:
    code = "".join(f"#include <{header}>\n" for header in headers)
    files = {"package.xml": PACKAGE, "CMakeLists.txt": MADE, "README.md": page, "demo.cpp": code}
    for path, text in files.items():
        (folder / path).write_text(text, encoding="utf-8")
    return plan_repository(folder).plan


def test_the_older_copy_is_a_link_before_anything_is_compiled(tmp_path: Path) -> None:
    plan = planned(tmp_path, "ROS Melodic\n", "rosbag/bag.h", "pcl/kdtree/kdtree_flann.h")
    assert dict(plan.header_links)[LZ4] == "/usr/include/lz4.h"
    text = dockerfile(plan)
    link = f"if [ -e {LZ4} ] && [ -e /usr/include/lz4.h ]; then ln -sf /usr/include/lz4.h {LZ4}; fi"
    assert text.index("install-rosdep-keys --tables") < text.index(link) < text.index("catkin_make -j")


@pytest.mark.parametrize(
    ("page", "headers"),
    [
        ("ROS Melodic\n", ("pcl/kdtree/kdtree_flann.h",)),
        ("ROS Melodic\n", ("rosbag/bag.h",)),
        ("ROS Noetic\n", ("rosbag/bag.h", "pcl/kdtree/kdtree_flann.h")),
    ],
)
def test_without_both_on_that_ubuntu_nothing_is_linked(tmp_path: Path, page: str, headers: tuple[str, ...]) -> None:
    plan = planned(tmp_path, page, *headers)
    assert plan.header_links == ()
    assert LZ4 not in dockerfile(plan)
