"""A folder that a package always adds is built with it, whatever it is called, and so is what it needs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.layers.workspace import rosdep_folders

Tree = Callable[[dict[str, str]], Decision]
FOLDER = "third_party/maps"
INNER = {
    f"{FOLDER}/package.xml": (
        "<package><name>maps</name><buildtool_depend>catkin</buildtool_depend><build_depend>pcl_ros</build_depend></package>"
    ),
    f"{FOLDER}/CMakeLists.txt": (
        "project(maps)\nfind_package(catkin REQUIRED COMPONENTS cv_bridge)\n"
        "find_package(Ceres REQUIRED)\nfind_package(SDL)\n"
    ),
}
XML = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def files(adds: str, *, inner: dict[str, str] = INNER) -> dict[str, str]:
    return {
        "README.md": "ROS Melodic\n",
        "demo/package.xml": XML,
        "demo/CMakeLists.txt": f"project(demo)\nfind_package(catkin REQUIRED)\n{adds}",
        **{f"demo/{path}": text for path, text in inner.items()},
    }


ADDED = f"add_subdirectory(${{PROJECT_SOURCE_DIR}}/{FOLDER})\n"


def test_what_it_requires_is_needed(tree: Tree) -> None:
    decision = tree(files(ADDED))
    assert {"pcl_ros"} <= set(decision.rosdep)
    assert {"ros-melodic-cv-bridge", "libceres-dev"} <= set(decision.apt_guessed) | set(decision.apt)
    assert not any("sdl" in name for name in (*decision.apt, *decision.apt_guessed))
    assert decision.packages == ("demo/package.xml", f"demo/{FOLDER}/package.xml")
    assert decision.package_names == ("demo",)


@pytest.mark.parametrize(
    "adds",
    ["", f"if(WITH_MAPS)\n{ADDED}endif()\n", f"function(later)\n{ADDED}endfunction()\n"],
)
def test_what_is_not_always_added_is_not(tree: Tree, adds: str) -> None:
    decision = tree(files(adds))
    assert "pcl_ros" not in decision.rosdep
    assert "libceres-dev" not in (*decision.apt, *decision.apt_guessed)
    assert decision.packages == ("demo/package.xml",)


def test_what_is_added_below_a_condition_is_not_always_added(tree: Tree) -> None:
    inner = {
        "parts/CMakeLists.txt": "add_subdirectory(deep)\n",
        "parts/deep/CMakeLists.txt": "project(deep)\nfind_package(acme_sdk REQUIRED)\n",
    }
    for adds, told in (("add_subdirectory(parts)\n", True), ("if(X)\nadd_subdirectory(parts)\nendif()\n", False)):
        warnings = tree(files(adds, inner=inner)).warnings
        assert any("brings acme_sdk" in warning.message for warning in warnings) == told


def test_rosdep_looks_into_the_folder_too(tmp_path: Path) -> None:
    for path, text in files(ADDED).items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    assert rosdep_folders(plan_repository(tmp_path).plan) == ["/tmp/manifests", f"/tmp/manifests/demo/{FOLDER}"]
