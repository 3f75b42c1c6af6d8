"""An author's Dockerfile that builds a workspace without an option which CMake demands."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.prose import author_dockerfile
from roslab.repository.checkout import Repository

DEMAND = 'if(NOT DEFINED SDK_ROOT)\n  message(FATAL_ERROR "set SDK_ROOT")\nendif()\n'
COLCON = "RUN . /opt/ros/humble/setup.sh && colcon build"


def problem(tmp_path: Path, step: str, cmake: str, **files: str) -> str | None:
    tree = {
        "Dockerfile": f"FROM ros:humble\nCOPY . /ws/src/demo\nWORKDIR /ws\n{step}\n",
        "package.xml": "<package><name>demo</name></package>",
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.5)\nproject(demo)\n{cmake}",
        **{name.replace("__", "/").replace("_", "."): text for name, text in files.items()},
    }
    for path, text in tree.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    return author_dockerfile.read(Repository.open(tmp_path))[0].problem


@pytest.mark.parametrize("step", [COLCON, "RUN colcon build --symlink-install", "RUN catkin_make", "RUN catkin build"])
def test_cmake_stops_without_it(tmp_path: Path, step: str) -> None:
    said = "it builds the workspace without -DSDK_ROOT, without which CMakeLists.txt stops (line 4)"
    assert problem(tmp_path, step, DEMAND) == said


@pytest.mark.parametrize(
    "step",
    [
        f"{COLCON} --cmake-args -DSDK_ROOT=/opt/sdk",
        "RUN colcon build --packages-select other",
        "RUN colcon build || true",
        'CMD ["bash"]',
        "RUN bash build.sh",
    ],
)
def test_it_is_given_or_may_be(tmp_path: Path, step: str) -> None:
    found = problem(tmp_path, step, DEMAND, build_sh="colcon build --cmake-args -DSDK_ROOT=/opt/sdk\n")
    assert "SDK_ROOT" not in (found or "")


@pytest.mark.parametrize(
    "cmake",
    [
        f'set(SDK_ROOT "/opt/sdk")\n{DEMAND}',
        f'option(SDK_ROOT "where" ON)\n{DEMAND}',
        f"find_path(SDK_ROOT sdk.h)\n{DEMAND}",
        f"find_package(SDK)\n{DEMAND}",
        f"get_filename_component(ROOT sdk ABSOLUTE)\nfile(TO_CMAKE_PATH /opt SDK_ROOT)\n{DEMAND}",
        f"if(WITH_SDK)\n{DEMAND}endif()\n",
        DEMAND.replace("FATAL_ERROR", "STATUS"),
    ],
)
def test_cmake_may_go_on(tmp_path: Path, cmake: str) -> None:
    assert problem(tmp_path, COLCON, cmake) is None


def test_settings_of_colcon_give_it(tmp_path: Path) -> None:
    meta = '{"names": {"demo": {"cmake-args": ["-DSDK_ROOT=/opt/sdk"]}}}'
    assert problem(tmp_path, COLCON, DEMAND, colcon_meta=meta) is None
    included = 'if(NOT SDK_ROOT)\n  set(SDK_ROOT "/opt/sdk")\nendif()\n'
    assert problem(tmp_path, COLCON, f"include(cmake/sdk.cmake)\n{DEMAND}", cmake__sdk_cmake=included) is None


@pytest.mark.parametrize("text", ["colcon x ", "catkin x ", "catkin_make ", "pip install x ", "a", "a/", "a.sha"])
@pytest.mark.parametrize("demand", [DEMAND, ""])
def test_a_hostile_script_takes_no_long_time(tmp_path: Path, text: str, demand: str) -> None:
    with ends():
        problem(tmp_path, "RUN bash build.sh", demand, build_sh=(text * (60_000 // len(text))))
        problem(tmp_path, f"RUN {text * (200_000 // len(text))}", demand)
