"""What CMake writes outside of its build folder is kept in the image."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import written_beside
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from roslab.repository.checkout import Repository

TOP = "cmake_minimum_required(VERSION 3.5)\nproject(a)\n{}\nadd_library(b SHARED b.cpp)\nadd_executable(a a.cpp)\n"


@pytest.mark.parametrize(
    ("text", "beside"),
    [
        ("set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_SOURCE_DIR}/lib)", True),
        ('set(OUT "${CMAKE_CURRENT_SOURCE_DIR}/lib")\nset(LIBRARY_OUTPUT_PATH ${OUT})', True),
        ("set_target_properties(b PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_SOURCE_DIR}/lib)", True),
        ("install(TARGETS a b\n  DESTINATION $ENV{HOME}/.gazebo/plugins)", True),
        ("file(DOWNLOAD https://example.org/net.onnx ${CMAKE_CURRENT_SOURCE_DIR}/models/net.onnx)", True),
        ("set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)", False),
        ("set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_SOURCE_DIR}/lib)", False),
        ("set(LIBRARY_OUTPUT_PATH ${PROJECT_SOURCE_DIR}/../../devel/lib)", False),
        ("install(TARGETS a b DESTINATION ${CMAKE_INSTALL_PREFIX}/lib)", False),
        ("install(FILES ${PROJECT_SOURCE_DIR}/a.h DESTINATION include)", False),
        ("# set(LIBRARY_OUTPUT_PATH ${PROJECT_SOURCE_DIR}/lib)", False),
    ],
)
def test_what_is_written_beside(tmp_path: Path, text: str, beside: bool) -> None:
    (tmp_path / "CMakeLists.txt").write_text(TOP.format(text))
    assert written_beside.found(Repository.open(tmp_path)) == beside
    assert plan_repository(tmp_path).plan.compiled_apart != beside


def test_an_example_tells_nothing(tmp_path: Path) -> None:
    (tmp_path / "examples").mkdir()
    (tmp_path / "examples/CMakeLists.txt").write_text("set(LIBRARY_OUTPUT_PATH ${PROJECT_SOURCE_DIR}/lib)\n")
    assert not written_beside.found(Repository.open(tmp_path))


def test_a_workspace_keeps_a_library_in_its_source(tmp_path: Path) -> None:
    manifest = "<package format='2'><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(manifest)
    found = "find_package(catkin REQUIRED)\ncatkin_package()\n{}"
    (tmp_path / "CMakeLists.txt").write_text(TOP.format(found.format("")))
    assert " AS compiled" in dockerfile(plan_repository(tmp_path).plan)
    own = "set({} ${{PROJECT_SOURCE_DIR}}/lib)"
    yields = own.format("CMAKE_LIBRARY_OUTPUT_DIRECTORY") + "\n" + found.format(own.format("LIBRARY_OUTPUT_PATH"))
    (tmp_path / "CMakeLists.txt").write_text(TOP.format(yields))
    assert " AS compiled" in dockerfile(plan_repository(tmp_path).plan)
    kept = found.format(own.format("CMAKE_LIBRARY_OUTPUT_DIRECTORY"))
    (tmp_path / "CMakeLists.txt").write_text(TOP.format(kept))
    assert " AS compiled" not in dockerfile(plan_repository(tmp_path).plan)
