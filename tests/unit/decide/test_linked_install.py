"""Programs of ROS 2 that import what lies beside them and is not installed: their authors' builds make links."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]

PACKAGE = (
    '<package format="3"><name>demo</name><version>1.0.0</version><buildtool_depend>ament_cmake</buildtool_depend>'
    "<depend>rclpy</depend><export><build_type>ament_cmake</build_type></export></package>"
)
CMAKE = """\
project(demo)
find_package(ament_cmake REQUIRED)
install(PROGRAMS src/eye.py DESTINATION lib/${{PROJECT_NAME}})
{}
ament_package()
"""
BY_LINKS = "ROS 2 Humble\n```\ncolcon build --symlink-install\nros2 run demo eye.py\n```\n"


def _files(more: str = "", page: str = BY_LINKS, code: str = "from helping.reader import read\n") -> dict[str, str]:
    return {
        "README.md": page,
        "package.xml": PACKAGE,
        "CMakeLists.txt": CMAKE.format(more),
        "src/eye.py": f"#!/usr/bin/env python3\nimport rclpy\n{code}",
        "src/helping/__init__.py": "",
        "src/helping/reader.py": "def read(): ...\n",
        "src/lone.py": "",
    }


@pytest.mark.parametrize(
    "more",
    [
        "",
        "ament_python_install_package(${PROJECT_NAME} PACKAGE_DIR src)",
        "install(DIRECTORY launch DESTINATION share/a)",
    ],
)
def test_links_are_installed_where_only_they_find_a_module(tree: Tree, more: str) -> None:
    assert tree(_files(more)).by_links


@pytest.mark.parametrize(
    ("more", "page", "code"),
    [
        ("", BY_LINKS.replace(" --symlink-install", ""), "import lone\n"),
        ("", BY_LINKS, ""),
        ("", BY_LINKS, "import numpy\n"),
        ("", BY_LINKS, "def run():\n    import lone\n"),
        ("ament_python_install_package(helping PACKAGE_DIR src/helping)", BY_LINKS, "import helping\n"),
        ("install(PROGRAMS src/lone.py DESTINATION lib/${PROJECT_NAME})", BY_LINKS, "import lone\n"),
        ("install(DIRECTORY src/ DESTINATION lib/${PROJECT_NAME})", BY_LINKS, "import lone\n"),
        ('install(DIRECTORY "src/helping" DESTINATION lib/demo)', BY_LINKS, "import helping\n"),
    ],
)
def test_copies_are_installed_elsewhere(tree: Tree, more: str, page: str, code: str) -> None:
    assert not tree(_files(more, page, code)).by_links


def test_a_package_of_catkin_runs_its_programs_where_they_lie(tree: Tree) -> None:
    files = _files(page="ROS Noetic\n```\ncolcon build --symlink-install\n```\n")
    files["package.xml"] = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("ament", "catkin")
    assert not tree(files).by_links


def test_colcon_is_told(tmp_path: Path) -> None:
    for name, text in _files().items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    planned = plan_repository(str(tmp_path))
    assert planned.plan.workspace.ros is not None
    assert planned.plan.workspace.ros.arguments == ("--symlink-install",)
    (tmp_path / "roslab.yaml").write_text("format: 3\nbuild_args: [--symlink-install, --merge-install]\n")
    planned = plan_repository(str(tmp_path))
    assert planned.plan.workspace.ros is not None
    assert planned.plan.workspace.ros.arguments == ("--symlink-install", "--merge-install")


SETUP = """\
from glob import glob
from setuptools import setup
package_name = 'demo'
setup(
    name=package_name,
    packages=[{}],
    data_files=[('share/' + package_name, ['package.xml']), ('share/demo/helping', glob('helping/*.py'))],
    entry_points={{'console_scripts': ['eye = demo.eye:main']}},
)
"""


def in_python(packages: str) -> dict[str, str]:
    """Return a package of Python whose setup.py names these packages."""
    manifest = PACKAGE.replace("ament_cmake", "ament_python")
    return {"package.xml": manifest, "setup.py": SETUP.format(packages), "demo/__init__.py": ""}


@pytest.mark.parametrize(
    ("packages", "code", "page", "found"),
    [
        ("package_name", "from helping import reader\n", BY_LINKS, True),
        ("package_name", "from helping import reader\n", BY_LINKS.replace(" --symlink-install", ""), False),
        ("package_name, 'helping'", "from helping import reader\n", BY_LINKS, False),
        ("package_name", "def main():\n    from helping import reader\n", BY_LINKS, False),
    ],
)
def test_so_are_modules_that_setup_py_installs_as_data(
    tree: Tree, packages: str, code: str, page: str, *, found: bool
) -> None:
    files = {
        "README.md": page,
        **in_python(packages),
        "demo/eye.py": f"import rclpy\n{code}",
        "helping/reader.py": "def read(): ...\n",
    }
    assert tree(files).by_links is found


@pytest.mark.parametrize(
    ("page", "packages", "linked", "told"),
    [
        (BY_LINKS, "package_name", True, False),
        (BY_LINKS.replace(" --symlink-install", ""), "package_name", False, True),
        (BY_LINKS, "package_name, 'demo.parts'", False, False),
    ],
)
def test_so_are_folders_that_setup_py_leaves_out(
    tree: Tree, page: str, packages: str, *, linked: bool, told: bool
) -> None:
    files = {
        "README.md": page,
        **in_python(packages),
        "demo/eye.py": "import rclpy\nfrom demo.parts import arm\n",
        "demo/parts/__init__.py": "",
        "demo/parts/arm.py": "",
    }
    decision = tree(files)
    assert decision.by_links is linked
    assert any("leaves out demo.parts" in warning.message for warning in decision.warnings) is told
