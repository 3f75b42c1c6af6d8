"""Which step installed what, by apt's record of its calls."""

from __future__ import annotations

import dataclasses
from pathlib import Path

from roslab.lock.inventory import _history
from roslab.lock.steps import placed, steps
from roslab.pipeline import plan_repository
from roslab.plan.locked import Package
from roslab.plan.plan import Plan

PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>x</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license>
<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>
"""
RECORD = """\
Commandline: apt-get install -y --no-install-recommends ros-noetic-ros-core
Install: ros-noetic-ros-core:amd64 (1.5), libssl3:amd64 (3.0, automatic)
Commandline: apt-get install --yes --no-install-recommends libeigen3-dev
Install: libeigen3-dev:amd64 (3.4.0-4), pkgconf:amd64 (1.8, automatic)
Commandline: apt-get install --yes --no-remove --no-install-recommends git
Install: git:amd64 (2.39, automatic)
Commandline: apt-get install -y ros-noetic-roscpp
Install: ros-noetic-roscpp:amd64 (1.16), libboost1.74:amd64 (1.74, automatic)
Commandline: apt-get install -y cowsay
Install: cowsay:amd64 (3.03)
"""


def plan_of(folder: Path) -> Plan:
    (folder / "package.xml").write_text(PACKAGE)
    (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.0)\nproject(robot)\ncatkin_package()\n")
    (folder / "roslab.yaml").write_text("format: 3\nbase: {ros: noetic}\napt: [libeigen3-dev]\ncustom: [sl]\n")
    return dataclasses.replace(plan_repository(folder).plan, apt_tools=("git",))


def test_a_package_belongs_to_the_step_that_asked_for_it(tmp_path: Path) -> None:
    plan = plan_of(tmp_path)
    assert [name for name, _ in steps(plan)] == ["packages", "tools", "rosdep", "custom"]
    names = ["libssl3", "ros-noetic-ros-core", "libeigen3-dev", "pkgconf", "git", "ros-noetic-roscpp", "libboost1.74"]
    base = {"libssl3", "ros-noetic-ros-core"}
    packages = [
        Package(name=name, version="1", architecture="amd64", source="", origin="", step="base" if name in base else "")
        for name in [*names, "unknown"]
    ]
    found = {p.name: p.step for p in placed(plan, packages, tuple(_history(RECORD.splitlines())))}
    assert found == {
        "libssl3": "base",
        "ros-noetic-ros-core": "base",
        "libeigen3-dev": "packages",
        "pkgconf": "packages",
        "git": "tools",
        "ros-noetic-roscpp": "rosdep",
        "libboost1.74": "rosdep",
        "unknown": "",
    }
