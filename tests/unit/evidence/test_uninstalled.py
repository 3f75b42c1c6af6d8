"""Launch files that no build of their package installs."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.ros import launch
from roslab.evidence.ros.launch_globs import left_by_globs
from roslab.repository.checkout import Repository
from trees import tree_of

LAUNCH = (
    "from launch import LaunchDescription\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"
)
SETUP = "from setuptools import setup\nname = 'eye'\nsetup(name=name, packages=[name], data_files=[{}])\n"
COMMENTED = "find_package(launch_testing)\n# install(DIRECTORY launch DESTINATION share)\n"
GLOB = "(os.path.join('share', name, 'launch'), glob('launch/*.launch.py'))"


@pytest.mark.parametrize(
    ("place", "build", "text", "installed"),
    [
        ("launch/a.launch.py", "setup.py", SETUP.format(GLOB), True),
        ("eye/a.launch.py", "setup.py", SETUP.format(GLOB), False),
        ("eye/a.launch.py", "setup.py", SETUP.format("('share/eye', glob('eye/*.launch.py'))"), True),
        ("eye/a.launch.py", "setup.py", SETUP.format("('share/eye', ['eye/a.launch.py'])"), True),
        ("eye/launch/a.launch.py", "setup.py", SETUP.format(GLOB), False),
        ("eye/launch/a.launch.py", "setup.py", SETUP.format('(f"share/{name}/launch", glob("launch/*"))'), False),
        ("eye/launch/a.launch.py", "setup.py", SETUP.format('("share", glob(join(name, "launch", "*.py")))'), True),
        ("eye/launch/a.launch.py", "setup.py", SETUP.format('("share", glob(f"{name}/launch/*.py"))'), True),
        ("eye/launch/a.launch.py", "setup.py", SETUP.format('("share", glob(name + "/launch/*.py"))'), True),
        ("eye/launch/a.launch.py", "setup.py", SETUP.format('("share", glob(join("eye", "launch", "*")))'), True),
        ("eye/a.launch.py", "setup.py", SETUP.format('("share", glob(join(name, "*.launch.py")))'), True),
        ("more/a.launch.py", "setup.py", SETUP.format(GLOB), False),
        ("more/a.launch.py", "setup.py", SETUP.format("*(f for d in os.listdir('.') for f in files(d))"), True),
        ("more/a.launch.py", "setup.py", "import os\nfor each in os.walk('.'): pass\n", True),
        ("launch/a_launch.py", "setup.py", SETUP.format(GLOB), False),
        ("launch/a_launch.py", "setup.py", SETUP.format(f"{GLOB}, ('share', ['launch/a_launch.py'])"), True),
        ("launch/a_launch.py", "setup.py", SETUP.format(f"{GLOB}, ('share', glob('launch/*_launch.py'))"), True),
        ("launch/a_launch.py", "setup.py", SETUP.format(f"{GLOB}, *more(glob(each))"), True),
        ("launch/a_launch.py", "setup.py", SETUP.format(f"{GLOB}, *Path('launch').glob('*.py')"), True),
        ("launch/a_launch.py", "setup.py", SETUP.format("('share', glob.glob('launch/' + '*.launch.py'))"), False),
        ("launch/a_launch.py", "setup.py", SETUP.format("('share', glob(os.path.join('launch', '*.xml')))"), False),
        (
            "launch/a_launch.py",
            "setup.py",
            SETUP.format("('share', glob(join('launch', '*launch.[pxy][yma]*')))"),
            True,
        ),
        ("launch/a_launch.py", "setup.py", SETUP.format("('share/eye/launch', glob('config/*.yaml'))"), True),
        ("launch/a.launch.py", "setup.py", SETUP.format(f"\n    # {GLOB}\n    ('share', ['package.xml'])"), False),
        ("launch/a.launch.py", "CMakeLists.txt", "install(DIRECTORY launch DESTINATION share)\n", True),
        (
            "launch/a.launch.py",
            "CMakeLists.txt",
            f"{COMMENTED}install(DIRECTORY config DESTINATION share)\n",
            False,
        ),
        ("more/a.launch.py", "CMakeLists.txt", "install(DIRECTORY launch DESTINATION share)\n", False),
        ("more/a.launch.py", "CMakeLists.txt", "install(DIRECTORY . DESTINATION share)\n", True),
        ("more/a.launch.py", "CMakeLists.txt", 'install(DIRECTORY "${PROJECT_SOURCE_DIR}/" DESTINATION x)\n', True),
        ("more/a.launch.py", "CMakeLists.txt", 'install(DIRECTORY "${CMAKE_SOURCE_DIR}" DESTINATION x)\n', True),
        ("more/a.launch.py", "CMakeLists.txt", "install(DIRECTORY ${folder} DESTINATION x)\n", True),
        (
            "more/a.launch.py",
            "CMakeLists.txt",
            'install(DIRECTORY "${PROJECT_SOURCE_DIR}/launch" DESTINATION x)\n',
            False,
        ),
        ("more/a.launch.py", "CMakeLists.txt", "project(eye)\n", True),
        ("a.launch.py", "CMakeLists.txt", "install(DIRECTORY launch DESTINATION share)\n", True),
    ],
)
@pytest.mark.parametrize("folder", ["", "src/eye/"])
def test_what_a_build_names(tmp_path: Path, folder: str, place: str, build: str, *, text: str, installed: bool) -> None:
    files = {"package.xml": "<package><name>eye</name></package>", "eye/__init__.py": ""}
    files |= {build: text, place: LAUNCH}
    tree_of(tmp_path / folder, files)
    (found,) = launch.read(Repository.open(tmp_path))
    assert found.installed is installed


CMAKE = "project(eye)\nfind_package(ament_cmake REQUIRED)\n{}\nament_package()\n"
TARGETS = "add_executable(node a.cpp)\ninstall(TARGETS node DESTINATION lib/eye)"


@pytest.mark.parametrize(
    ("place", "build", "text", "by_path"),
    [
        ("launch/a.launch.py", TARGETS, LAUNCH, True),
        ("launch/a.launch.py", f"include(GNUInstallDirs)\n{TARGETS}\n# install(DIRECTORY launch", LAUNCH, True),
        ("launch/a.launch.py", "ament_python_install_package(eye)", LAUNCH, True),
        ("launch/a.launch.py", f"{TARGETS}\ninstall(DIRECTORY include DESTINATION include)", LAUNCH, False),
        ("launch/a.launch.py", f"{TARGETS}\ninstall(DIRECTORY launch DESTINATION share/eye)", LAUNCH, False),
        ("launch/a.launch.py", f"{TARGETS}\ninstall(FILES ${{all}} DESTINATION share/eye)", LAUNCH, False),
        ("launch/a.launch.py", f"{TARGETS}\ninclude(cmake/all.cmake)", LAUNCH, False),
        ("launch/a.launch.py", f"{TARGETS}\nadd_subdirectory(src)", LAUNCH, False),
        ("launch/a.launch.py", f"{TARGETS}\neye_install(all)", LAUNCH, False),
        ("launch/a.launch.py", f"{TARGETS}\nament_auto_package(INSTALL_TO_SHARE config)", LAUNCH, False),
        ("launch/a.launch.py", TARGETS, f"{LAUNCH}# FindPackageShare('eye')\n", False),
        ("launch/a.launch.py", TARGETS, f"{LAUNCH}get_package_share_directory('eye')\n", False),
        ("a.launch.py", TARGETS, LAUNCH, False),
    ],
)
@pytest.mark.parametrize("folder", ["", "src/eye/"])
def test_a_build_that_installs_programs_alone(
    tmp_path: Path, folder: str, place: str, build: str, *, text: str, by_path: bool
) -> None:
    files = {"package.xml": "<package><name>eye</name></package>", "CMakeLists.txt": CMAKE.format(build), place: text}
    tree_of(tmp_path / folder, files)
    (found,) = launch.read(Repository.open(tmp_path))
    assert found.by_path is by_path


def test_no_build_of_ament_tells_nothing(tmp_path: Path) -> None:
    cmake = "project(eye)\ninstall(TARGETS node DESTINATION lib/eye)\n"
    files = {"package.xml": "<package><name>eye</name></package>", "CMakeLists.txt": cmake}
    (found,) = launch.read(tree_of(tmp_path, {**files, "launch/a.launch.py": LAUNCH}))
    assert not found.by_path


def test_blanks_without_end_take_no_time() -> None:
    with ends():
        assert not left_by_globs("launch", "a_launch.py", f"glob('launch/*.launch.py'{' ' * 200_000}")


@pytest.mark.parametrize(("calls", "left"), [(64, True), (65, False)])
def test_more_patterns_than_are_looked_at_may_take_any(calls: int, *, left: bool) -> None:
    setup = "".join(f"glob('launch/{number}*.launch.py')\n" for number in range(calls))
    assert left_by_globs("launch", "a_launch.py", setup) is left
