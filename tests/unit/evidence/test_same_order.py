"""What is read is told in one order, whatever the hashes of its names are."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import roslab

READ = """
import sys
from pathlib import Path
from roslab.pipeline import plan_repository
for each in plan_repository(Path(sys.argv[1])).plan.reasons:
    print(each.answer, each.file)
"""
NAMES = "cv2 rospy yaml numpy scipy serial matplotlib requests"


def test_packages_of_one_program_come_in_one_order(tmp_path: Path) -> None:
    """A program of a workspace of Python 2 whose first line asks for Python 3 needs Ubuntu's own packages."""
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n")
    (tmp_path / "README.md").write_text("For ROS melodic.\n")
    program = "".join(f"import {name}\n" for name in NAMES.split())
    (tmp_path / "scripts").mkdir()
    (tmp_path / "scripts" / "node.py").write_text(f"#!/usr/bin/env python3\n{program}")
    told = set()
    for seed in range(4):
        environment = {**os.environ, "PYTHONHASHSEED": str(seed), "PYTHONPATH": str(Path(roslab.__file__).parents[1])}
        call = [sys.executable, "-c", READ, str(tmp_path)]
        told.add(subprocess.run(call, env=environment, capture_output=True, text=True, check=True).stdout)
    (text,) = told
    assert "python3-opencv" in text
