"""A distribution of tomorrow is one row of the table: nothing else of the program names distributions."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import roslab

ROW = "zany,2,resolute,resolute,3.14,2027-05-23,2032-05-31,,yes,8,yes,yes,https://docs.ros.org/en/zany/,2027-05-23\n"
PACKAGE = """<package format="3"><name>arm</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license>
<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend><export><build_type>ament_cmake</build_type></export>
</package>
"""


def test_a_row_is_a_distribution(tmp_path: Path) -> None:
    program = tmp_path / "scripts"
    shutil.copytree(Path(roslab.__file__).parents[1], program, ignore=shutil.ignore_patterns("__pycache__"))
    with (program / "roslab" / "knowledge" / "distros.csv").open("a", encoding="utf-8") as table:
        table.write(ROW)
    tree = tmp_path / "arm"
    tree.mkdir()
    (tree / "package.xml").write_text(PACKAGE)
    (tree / "CMakeLists.txt").write_text("project(arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n")
    (tree / "README.md").write_text("Tested on ROS 2 Zany. `sudo apt install ros-zany-tf2-ros`\n")
    argv = [sys.executable, "-I", str(program), "inspect", "--format", "json", str(tree)]
    found = json.loads(subprocess.run(argv, check=True, capture_output=True, text=True).stdout)
    assert (found["ros_distro"], found["ubuntu"], found["base_image"]) == ("zany", "resolute", "ros:zany-ros-base")
    assert "ros-zany-tf2-ros" in found["dependencies"]["apt"]
    assert found["warnings"] == []
