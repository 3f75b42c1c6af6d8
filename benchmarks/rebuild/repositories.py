"""The repositories that are built, and the changes that somebody makes to them between two builds."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
PACKAGES = 30

MANIFEST = """\
<?xml version="1.0"?>
<package format="2">
  <name>{name}</name>
  <version>1.0.0</version>
  <description>Package {name} of a made-up workspace</description>
  <maintainer email="somebody@example.org">Somebody</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
  <depend>std_msgs</depend>
  <depend>eigen</depend>
  <depend>yaml-cpp</depend>
  <exec_depend>roslaunch</exec_depend>
  <exec_depend>python3-numpy</exec_depend>
</package>
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.5)
project({name})
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)
catkin_package(CATKIN_DEPENDS roscpp std_msgs)
include_directories(include ${{catkin_INCLUDE_DIRS}})
add_executable({name}_node src/node.cpp src/filter.cpp)
target_link_libraries({name}_node ${{catkin_LIBRARIES}})
install(TARGETS {name}_node RUNTIME DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})
install(DIRECTORY launch DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})
"""
NODE = """\
#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include "{name}/filter.hpp"

int main(int argc, char** argv)
{{
  ros::init(argc, argv, "{name}");
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<std_msgs::Float64>("state", 10);
  ros::Rate rate(10);
  for (int count = 0; ros::ok(); ++count) {{
    std_msgs::Float64 message;
    message.data = {name}::filtered(count);
    publisher.publish(message);
    rate.sleep();
  }}
  return 0;
}}
"""
FILTER = """\
#include "{name}/filter.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace {name}
{{
double filtered(int count)
{{
  static std::map<int, std::vector<double>> history;
  const double gain = {index}.5;
  auto& values = history[count % 7];
  values.push_back(gain * std::sin(count));
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}}
}}
"""
HEADER = "#pragma once\n\nnamespace {name}\n{{\ndouble filtered(int count);\n}}\n"
LAUNCH = '<launch>\n  <node pkg="{name}" type="{name}_node" name="{name}"/>\n</launch>\n'
README = "# A made-up workspace\n\nThirty packages for ROS Noetic, made up, so that one can be changed.\n"
CONFIG = "format: 3\nkind: ros1\ncommand: roslaunch package_00 start.launch\n"


@dataclass(frozen=True, kw_only=True)
class Repository:
    """A repository that can be made, and where its changes go."""

    name: str
    make: Callable[[Path], None]
    cpp: str
    """The file whose line changes, and the text in it that changes at each build."""
    line: str
    launch: str
    manifest: str


def example(folder: Path) -> None:
    """Copy the ROS 1 example."""
    shutil.copytree(EXAMPLES / "ros1_talker", folder)


def package(folder: Path, name: str, index: int, manifest: str = MANIFEST) -> None:
    """Write a ROS 1 package with a node, a library and a launch file, whose code is unlike that of another index."""
    files = {
        "package.xml": manifest,
        "CMakeLists.txt": CMAKE,
        "src/node.cpp": NODE,
        "src/filter.cpp": FILTER,
        f"include/{name}/filter.hpp": HEADER,
        "launch/start.launch": LAUNCH,
    }
    for path, text in files.items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text.format(name=name, index=index))


def workspace(folder: Path) -> None:
    """Write a workspace of thirty packages, the same bytes every time."""
    for index in range(PACKAGES):
        name = f"package_{index:02}"
        package(folder / name, name, index)
    (folder / "README.md").write_text(README)
    (folder / "roslab.yaml").write_text(CONFIG)


REPOSITORIES = (
    Repository(
        name="ros1_talker",
        make=example,
        cpp="src/talker.cpp",
        line="ros::Rate rate(10);",
        launch="launch/chatter.launch",
        manifest="package.xml",
    ),
    Repository(
        name="workspace-30",
        make=workspace,
        cpp="package_17/src/filter.cpp",
        line="const double gain = 17.5;",
        launch="package_17/launch/start.launch",
        manifest="package_17/package.xml",
    ),
)

APT = "libtinyxml2-dev"
"""A package of the distribution that neither repository needs, as ``add-apt`` adds it."""
KEY = "sqlite3"
"""A key of rosdep that neither repository needs, as ``add-package-xml`` adds it."""


@dataclass
class Change:
    """One repository on disk, as it changes between builds."""

    of: Repository
    root: Path
    apt: tuple[str, ...] = ()
    """Packages that a Dockerfile of the author's own names; with ours they are in roslab.yaml."""

    def make(self, case: str) -> None:
        """Make the change of a case; ``cold`` and ``unchanged`` make none."""
        if case == "edit-cpp":
            self._replace(self.of.cpp, self.of.line, f"{self.of.line} // again")
        elif case == "edit-launch":
            self._replace(self.of.launch, "</launch>", "  <!-- again -->\n</launch>")
        elif case == "edit-readme":
            with (self.root / "README.md").open("a") as readme:
                readme.write("\nOne line more.\n")
        elif case == "add-apt":
            self.apt = (APT,)
            with (self.root / "roslab.yaml").open("a") as config:
                config.write(f"apt: [{APT}]\n")
        elif case == "add-package-xml":
            self._replace(self.of.manifest, "</package>", f"  <depend>{KEY}</depend>\n</package>")

    def _replace(self, path: str, old: str, new: str) -> None:
        file = self.root / path
        text = file.read_text()
        assert old in text, f"{path} has no {old!r}"
        file.write_text(text.replace(old, new, 1))
