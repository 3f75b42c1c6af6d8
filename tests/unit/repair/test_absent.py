"""What a failed build has left out itself, for its apt does not have it, is not added once more."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.absent import without_absent
from roslab.repair.repair import repair

MANIFEST = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>image_transport</depend></package>
"""
CMAKE = (
    "cmake_minimum_required(VERSION 3.0)\nproject(robot)\nfind_package(catkin REQUIRED COMPONENTS image_transport)\n"
)
LOG = """\
#5 [2/4] RUN install-rosdep-keys /tmp/manifests
#5 33.6 {said}
#5 DONE 34.0s

#6 [3/4] RUN catkin_make
#6 9.0 -- Could not find the required component 'image_transport'. The following CMake error indicates that you need it
#6 9.0 CMake Error at /opt/ros/noetic/share/catkin/cmake/catkinConfig.cmake:82 (find_package):
#6 9.0   Could not find a package configuration file provided by
#6 9.0   "image_transport" with any of the following names:
#6 ERROR: process "/bin/sh -c catkin_make" did not complete successfully: exit code: 1
"""
PACKAGE = "ros-noetic-image-transport"


@pytest.mark.parametrize(
    ("said", "values"),
    [
        ("roslab: left out: rosdep image_transport", []),
        (f"roslab: left out: apt {PACKAGE}", []),
        ("roslab: left out: rosdep image_transport_plugins", [PACKAGE]),
        ("roslab: left out: https://example.org/image_transport cannot be cloned", [PACKAGE]),
        ("#All required rosdeps installed successfully", [PACKAGE]),
    ],
)
def test_what_apt_did_not_have_is_not_added(tmp_path: Path, said: str, values: list[str]) -> None:
    for name, text in {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE}.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "roslab.yaml").write_text("format: 3\nbase: {ros: noetic}\n")
    log = LOG.format(said=said)
    answer = explain(io.BytesIO(log.encode()))
    first = repair(answer, given(plan_repository(tmp_path)))
    found = without_absent(first, answer.left_out)
    assert [change.value for change in first.certain.changes] == [PACKAGE]
    assert [change.value for change in found.changes] == values
    whys = [why for _, why in found.refused]
    assert whys == [f"the package image_transport (CMakeLists.txt:3) is missing, and apt has no {PACKAGE} here"] * (
        not values
    )
