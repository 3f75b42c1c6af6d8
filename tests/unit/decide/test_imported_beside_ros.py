"""A submodule that nobody has seen and that nodes import: pip installs it and what it needs, unless it is a package."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render.layers.python_projects import projects
from trees import linked

BUILDS = "<buildtool_depend>{0}</buildtool_depend><export><build_type>{0}</build_type></export>"
COMMIT = "0123456789012345678901234567890123456789"


def planned(folder: Path, submodule: str, node: str, *, depends: str = "", ros: str = "ament_cmake") -> Plan:
    files = {
        "package.xml": f"<package><name>demo</name>{depends}{BUILDS.format(ros)}</package>",
        "CMakeLists.txt": f"project(demo)\nfind_package({ros} REQUIRED)\n",
        "scripts/node.py": node,
        ".gitmodules": f'[submodule "a"]\n\tpath = {submodule}\n\turl = https://github.com/lab/{submodule}.git\n',
    }
    linked(folder, files, COMMIT, submodule)
    return plan_repository(folder).plan


@pytest.mark.parametrize(
    ("submodule", "node", "depends", "ros", "found"),
    [
        ("brumby_sdk", "import rclpy\nfrom brumby_sdk import *\n", "", "ament_cmake", True),
        ("brumby_sdk", "import rospy\nfrom brumby_sdk.arm import Arm\n", "", "catkin", True),
        ("brumby_sdk", "import rclpy\n", "", "ament_cmake", False),
        ("brumby_msgs", "from brumby_msgs.msg import A\n", "<depend>brumby_msgs</depend>", "ament_cmake", False),
        ("rosbridge_library", "import rosbridge_library\n", "", "ament_cmake", False),
    ],
)
def test_what_nodes_import(tmp_path: Path, submodule: str, node: str, depends: str, ros: str, *, found: bool) -> None:
    plan = planned(tmp_path, submodule, node, depends=depends, ros=ros)
    assert (submodule in plan.python.imported) == found
    assert (submodule in plan.workspace.python_projects) == found
    assert any("is called like it: pip installs it" in each.message for each in plan.warnings) == found


@pytest.mark.parametrize(
    ("there", "said"),
    [
        (("setup.py",), "pip: -m pip install"),
        (("setup.py", "package.xml"), "roslab: brumby_sdk is built with the workspace"),
        (("package.xml",), "roslab: brumby_sdk is built with the workspace"),
        ((), "roslab: left out: brumby_sdk has neither setup.py nor pyproject.toml"),
    ],
)
def test_a_package_of_ros_is_left_to_the_workspace(tmp_path: Path, there: tuple[str, ...], said: str) -> None:
    block = projects(planned(tmp_path / "tree", "brumby_sdk", "import rclpy\nimport brumby_sdk\n"))
    command = "if " + block[block.index("source ask-pip-again") :].partition("if ")[2]
    python = tmp_path / "bin/python3"
    python.parent.mkdir()
    python.write_text('#!/bin/sh\necho "pip: $*"\n', encoding="utf-8")
    python.chmod(0o755)
    (tmp_path / "brumby_sdk").mkdir()
    for name in there:
        (tmp_path / "brumby_sdk" / name).touch()
    path = f"{python.parent}:{os.environ['PATH']}"
    run = subprocess.run(
        ["bash", "-euc", f"pip-cache() {{ :; }}\n{command}"],
        cwd=tmp_path,
        env={"PATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    assert run.stdout.splitlines()[0].startswith(said)
