"""Made-up ROS repositories of any size, the same bytes every time."""

from __future__ import annotations

from pathlib import Path

MANIFEST = """\
<?xml version="1.0"?>
<package format="2">
  <name>{name}</name>
  <version>1.0.0</version>
  <description>Package {name} of a made-up repository</description>
  <maintainer email="somebody@example.org">Somebody</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
  <depend>std_msgs</depend>
  <depend>{other}</depend>
  <exec_depend>rospy</exec_depend>
</package>
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.5)
project({name})
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs {other})
find_package(Eigen3 REQUIRED)
find_package(Boost REQUIRED COMPONENTS system thread)
catkin_package()
include_directories(include ${{catkin_INCLUDE_DIRS}} ${{EIGEN3_INCLUDE_DIRS}})
add_executable({name}_node src/file_0.cpp)
target_link_libraries({name}_node ${{catkin_LIBRARIES}})
"""
CPP = """\
#include <cmath>
#include <vector>
#include <Eigen/Core>
#include <boost/thread.hpp>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include "{name}/file_{index}.hpp"

""" + "".join(f"double step_{i}(double x) {{ return std::sqrt(x * {i}.0 + 1.0); }}\n" for i in range(30))
HPP = "#pragma once\n#include <string>\n#include <Eigen/Dense>\nnamespace {name} { class Part{index}; }\n"
PYTHON = """\
#!/usr/bin/env python3
import os
import sys
import numpy as np
import rospy
from std_msgs.msg import String


def main():
    rospy.init_node("{name}_{index}")
    print(np.zeros(3), os.getpid(), sys.argv, String())


if __name__ == "__main__":
    main()
"""
LAUNCH = '<launch>\n  <node pkg="{name}" type="{name}_node" name="node_{index}" output="screen"/>\n</launch>\n'
YAML = "gain: {index}\nframes: [map, odom, base_link]\n"
README = "# A made-up repository\n\nFor ROS Noetic.\n\n```bash\nroslaunch package_0 start_17.launch\n```\n"
KINDS = (
    ("src/file_{index}.cpp", CPP, 12),
    ("include/{name}/file_{index}.hpp", HPP, 9),
    ("scripts/script_{index}.py", PYTHON, 4),
    ("launch/start_{index}.launch", LAUNCH, 2),
    ("config/file_{index}.yaml", YAML, 3),
    ("data/scan_{index}.bin", "\0" * 512, 10),
)
"""Path, text and how many of forty."""


def grow(folder: Path, *, files: int, packages: int) -> None:
    """Write a repository of so many files, of which so many are package.xml, spread evenly over its packages."""
    folder.mkdir(parents=True)
    _write(folder / "README.md", README)
    left = files - 1
    for number in range(packages):
        share = left // (packages - number)
        left -= share
        other = f"package_{number - 1}" if number else "geometry_msgs"
        _package(folder / "src" / f"package_{number}", share, other=other)


def _package(folder: Path, files: int, *, other: str) -> None:
    name = folder.name
    _write(folder / "package.xml", MANIFEST.format(name=name, other=other))
    _write(folder / "CMakeLists.txt", CMAKE.format(name=name, other=other))
    turns = [kind for kind in KINDS for _ in range(kind[2])]
    for index in range(files - 2):
        path, text, _ = turns[index % len(turns)]
        # Not `format`: C++ and YAML have braces of their own
        filled = [part.replace("{name}", name).replace("{index}", str(index)) for part in (path, text)]
        _write(folder / filled[0], filled[1])


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
