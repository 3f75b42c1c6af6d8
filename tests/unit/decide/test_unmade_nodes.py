"""A node that the default command starts and that its package does not install is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
MADE = "project(demo)\nfind_package(ament_cmake REQUIRED)\n{}\ninstall(DIRECTORY launch DESTINATION share/demo)\n"
LAUNCH = "def generate_launch_description():\n    return LaunchDescription([Node(package='demo', executable='{}')])\n"


@pytest.mark.parametrize(
    ("program", "made", "told"),
    [
        ("panel.py", "install(PROGRAMS scripts/panel_dev.py DESTINATION lib/demo)", "(it has panel_dev.py)"),
        ("panel", "add_executable(panels a.cpp)\ninstall(TARGETS panels DESTINATION lib/demo)", "(it has panels)"),
        ("panel", "add_executable(other a.cpp)", "no such program:"),
        ("panel.py", "install(PROGRAMS scripts/panel.py DESTINATION lib/demo)", ""),
        ("panel", "install(PROGRAMS scripts/panel.py DESTINATION lib/demo)", "(it has panel.py)"),
        ("panel", "install(PROGRAMS scripts/panel.py DESTINATION lib/demo RENAME panel)", ""),
        ("panel.py", "install(DIRECTORY scripts/ DESTINATION lib/${PROJECT_NAME})", ""),
        ("panel.py", "file(GLOB ALL scripts/*.py)\ninstall(PROGRAMS ${ALL} DESTINATION lib/demo)", ""),
        ("demo_node", "add_executable(${PROJECT_NAME}_node a.cpp)", ""),
        ("panel", "add_subdirectory(src)", ""),
        ("a_panel", "macro(node n)\n add_executable(a_${n} a.cpp)\nendmacro()\nnode(panel)", ""),
        ("panel", "install(DIRECTORY scripts DESTINATION ${CMAKE_INSTALL_LIBDIR}/demo)", ""),
        ("panel", "install(DIRECTORY scripts/ # all (nodes)\n DESTINATION lib/${PROJECT_NAME})", ""),
        ("panel", "install(DIRECTORY maps DESTINATION ${CMAKE_INSTALL_DATADIR}/demo)", "no such program:"),
    ],
)
def test_by_cmake(tree: Tree, program: str, made: str, told: str) -> None:
    files = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": MADE.format(made),
        "launch/demo.launch.py": LAUNCH.format(program),
    }
    decision = tree({**files, "src/CMakeLists.txt": "add_executable(panel a.cpp)\n" if "add_sub" in made else ""})
    assert decision.command == ("ros2", "launch", "demo", "demo.launch.py")
    found = [w.message for w in decision.warnings if "the default command starts" in w.message]
    assert len(found) == bool(told)
    assert all(f"starts {program} of the package demo" in message and told in message for message in found)


@pytest.mark.parametrize(("program", "told"), [("panel", 0), ("board", 1)])
def test_by_python(tree: Tree, program: str, told: int) -> None:
    setup = "from setuptools import setup\nsetup(name='demo', packages=['demo'], data_files=[('share/demo/launch', "
    setup += "['launch/demo.launch.py'])], entry_points={'console_scripts': ['panel = demo.panel:main']})\n"
    files = {"package.xml": MANIFEST.replace("_cmake", "_python"), "setup.py": setup, "demo/__init__.py": ""}
    files["package.xml"] = files["package.xml"].replace(
        "</package>", "<export><build_type>ament_python</build_type></export></package>"
    )
    decision = tree({**files, "launch/demo.launch.py": LAUNCH.format(program)})
    assert len([w for w in decision.warnings if "installs no such program" in w.message]) == told
    listing = setup.replace(
        "setup(name", "import os\nNODES = [each[:-3] for each in os.listdir('demo')]\nsetup(name", 1
    )
    decision = tree({**files, "setup.py": listing, "launch/demo.launch.py": LAUNCH.format(program)})
    assert not [w for w in decision.warnings if "installs no such program" in w.message]


BOTH = "# demo\n## Usage\n```\nros2 launch demo broken.launch.py\nros2 launch demo whole.launch.py{}\n```\n"


@pytest.mark.parametrize(
    ("page", "second", "taken"),
    [
        (BOTH.format(""), "panel", "whole.launch.py"),
        (BOTH.format(""), "lost", "broken.launch.py"),  # none is whole
        (BOTH.format(""), "panel'), DeclareLaunchArgument('map", "broken.launch.py"),  # the other lacks an argument
        ("# demo\n", "panel", "whole.launch.py"),
    ],
)
def test_another_is_taken(tree: Tree, page: str, second: str, taken: str) -> None:
    made = "add_executable(panel a.cpp)\ninstall(TARGETS panel DESTINATION lib/demo)"
    files = {"package.xml": MANIFEST, "CMakeLists.txt": MADE.format(made), "README.md": page}
    files["launch/broken.launch.py"] = LAUNCH.format("gone")
    files["launch/whole.launch.py"] = LAUNCH.format(second)
    assert tree(files).command == ("ros2", "launch", "demo", taken)
