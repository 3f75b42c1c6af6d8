"""Keys for rosdep that a list of the repository's own defines."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend>"
    "<depend>roscpp</depend><depend>demo-shapes</depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "# For ROS Noetic\n",
}


def unknown(decision: Decision) -> list[str]:
    return [warning.message for warning in decision.warnings if "rosdep has no key" in warning.message]


@pytest.mark.parametrize(
    ("path", "said", "apt"),
    [
        ("ci/rosdep/demo.yaml", "{ubuntu: [python3-shapely, libgeos-dev]}", ["libgeos-dev", "python3-shapely"]),
        ("rosdep.yaml", "{debian: [no], ubuntu: python3-shapely libgeos-dev}", ["libgeos-dev", "python3-shapely"]),
        ("my_rosdep.yml", "{ubuntu: {bionic: [python-shapely], focal: [python3-shapely]}}", ["python3-shapely"]),
        ("rosdep.yaml", "{ubuntu: {18.04: python-shapely, 20.04: python3-shapely}}", ["python3-shapely"]),
        ("rosdep.yaml", "{ubuntu: {bionic: [python-shapely], '*': [python3-shapely]}}", ["python3-shapely"]),
        ("rosdep.yaml", "{ubuntu: {apt: {packages: [python3-shapely]}}}", ["python3-shapely"]),
        ("rosdep.yaml", "{ubuntu: {focal: {apt: {packages: [python3-shapely]}}}}", ["python3-shapely"]),
        ("rosdep.yaml", "{ubuntu: [ros-kinetic-xacro]}", ["ros-noetic-xacro"]),
    ],
)
def test_the_packages_of_a_key_of_the_repositorys_own(tree: Tree, path: str, said: str, apt: list[str]) -> None:
    found = tree({**FILES, path: f"# ours\ndemo-shapes:\n  {said}\nother: {{ubuntu: [curl]}}\n"})
    named = {"libgeos-dev", "python3-shapely", "python-shapely", "ros-noetic-xacro", "curl"}
    assert [name for name in found.apt_guessed if name in named] == apt
    assert "demo-shapes" in found.skip_keys
    assert not unknown(found)


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("config/shapes.yaml", "demo-shapes: {ubuntu: [python3-shapely]}\n"),
        ("third_party/rosdep/demo.yaml", "demo-shapes: {ubuntu: [python3-shapely]}\n"),
        ("rosdep.yaml", "demo-shapes: {ubuntu: {bionic: [python3-shapely]}}\n"),
        ("rosdep.yaml", "demo-shapes: {ubuntu: {pip: {packages: [shapely]}}}\n"),
        ("rosdep.yaml", "demo-shapes:\n  ubuntu: |\n    if true; then\n      python3-shapely\n    fi\n"),
        ("rosdep.yaml", "- demo-shapes\n"),
    ],
)
def test_what_defines_no_key_for_this_ubuntu(tree: Tree, path: str, text: str) -> None:
    found = tree({**FILES, path: text})
    assert "python3-shapely" not in found.apt_guessed
    assert unknown(found)


def test_a_key_of_rosdep_is_left_to_rosdep(tree: Tree) -> None:
    found = tree({**FILES, "rosdep.yaml": "roscpp: {ubuntu: [curl]}\ndemo-shapes: {ubuntu: [libgeos-dev]}\n"})
    assert "curl" not in found.apt_guessed
    assert "roscpp" in found.rosdep


@pytest.mark.parametrize(
    ("key", "tool", "told"),
    [
        ("json", "ament_python", False),
        ("threading", "ament_python", False),
        ("json", "ament_cmake", True),
        ("jsonn", "ament_python", True),
    ],
)
def test_a_module_of_pythons_own_library_needs_no_package(tree: Tree, key: str, tool: str, *, told: bool) -> None:
    said = f"<depend>rclpy</depend><exec_depend>{key}</exec_depend><export><build_type>{tool}</build_type></export>"
    files = {"package.xml": f"<package><name>demo</name>{said}</package>", "README.md": "# For ROS 2 Humble\n"}
    setup = {"setup.py": "from setuptools import setup\nsetup(name='demo')\n"}
    cmake = {"CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n"}
    found = tree(files | (setup if tool == "ament_python" else cmake))
    assert bool(unknown(found)) is told
    assert (key in found.skip_keys) is not told
