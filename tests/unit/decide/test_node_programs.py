"""The programs of packages of ROS 2 that can be started where no launch file does: of components, and of Python."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>{}</build_type></export></package>"
)
CMAKE = "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_library(demo SHARED a.cpp)\n{}\nament_package()\n"
MAKES = "rclcpp_components_register_node(demo PLUGIN demo::A {})"
EACH = f"foreach(m ${{ALL}})\n {MAKES.format('EXECUTABLE car_${m}')}\nendforeach()"


@pytest.mark.parametrize(
    ("made", "programs"),
    [
        (MAKES.format("EXECUTABLE talker"), ["talker"]),
        (f"foreach(model small large)\n  {MAKES.format('EXECUTABLE ${model}')}\nendforeach()", ["small", "large"]),
        (
            f"set(ALL small)\nlist(APPEND ALL large)\n{EACH}",
            ["car_small", "car_large"],
        ),
        (MAKES.format("EXECUTABLE ${unknown}"), []),
        (MAKES.format("EXECUTABLE"), []),
        ("rclcpp_components_register_nodes(demo demo::A)", []),
    ],
)
def test_a_component_that_is_started_by_itself(tree: Tree, made: str, programs: list[str]) -> None:
    found = tree({"package.xml": MANIFEST.format("ament_cmake"), "CMakeLists.txt": CMAKE.format(made), "a.cpp": ""})
    assert found.command_candidates == tuple(("ros2", "run", "demo", name) for name in programs)


@pytest.mark.parametrize(
    ("build_type", "files", "there"),
    [
        ("ament_cmake", {"CMakeLists.txt": CMAKE.format("")}, False),
        ("ament_python", {}, True),
        ("ament_python", {"CMakeLists.txt": "project(demo)\nadd_library(demo a.cpp)\n"}, True),
    ],
)
@pytest.mark.parametrize("manifest", ["pyproject.toml", "setup.py"])
def test_programs_that_colcon_installs(
    tree: Tree, build_type: str, files: dict[str, str], there: bool, manifest: str
) -> None:
    written = {
        "pyproject.toml": '[project]\nname = "demo"\nversion = "1"\n[project.scripts]\ndemo-file = "demo.main:run"\n',
        "setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'],\n"
        "    entry_points={'console_scripts': ['demo-file = demo.main:run']})\n",
    }
    code = {"demo/__init__.py": "", "demo/main.py": "import rclpy\ndef run():\n    rclpy.init()\n", "a.cpp": ""}
    found = tree({"package.xml": MANIFEST.format(build_type), manifest: written[manifest], **code, **files})
    assert (("ros2", "run", "demo", "demo-file") in found.command_candidates) is there


def test_ament_reads_the_programs_of_setup_cfg(tree: Tree) -> None:
    files = {
        "package.xml": MANIFEST.format("ament_cmake"),
        "CMakeLists.txt": CMAKE.format("ament_python_install_package(demo)"),
        "setup.cfg": "[metadata]\nname = demo\n[options.entry_points]\nconsole_scripts =\n  tool = demo.main:run\n",
        "demo/__init__.py": "",
        "demo/main.py": "def run():\n    pass\n",
        "a.cpp": "",
    }
    assert ("ros2", "run", "demo", "tool") in tree(files).command_candidates
