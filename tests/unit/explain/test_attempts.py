"""Of a step that builds again without what failed, the cause is why that failed, not what lacks it afterwards."""

from __future__ import annotations

import io

import pytest

from roslab.explain.answer import Explanation, explain

STEP = "#9 [5/5] RUN leave-out-failed src/planning -- catkin build\n"
BEGIN = """\
#9 1.0 Errors     << planning:make /ws/logs/planning/build.make.000.log
#9 1.0 /ws/src/planning/a.cpp:1:10: fatal error: search/heuristic.h: No such file or directory
#9 1.1 make[2]: *** [CMakeFiles/planning.dir/a.cpp.o] Error 1
#9 1.1 Failed     << planning:make           [ Exited with code 2 ]
"""
WITHOUT = """\
#9 1.2 roslab: the workspace does not build: once more without what failed
#9 1.3 roslab: left out: planning other
"""
LACKS = """\
#9 2.0 Errors     << arm:cmake /ws/logs/arm/build.cmake.000.log
#9 2.0 CMake Error at /ws/src/arm/CMakeLists.txt:23 (find_package):
#9 2.0   By not providing "Findplanning.cmake" in CMAKE_MODULE_PATH this project has
#9 2.0   asked CMake to find a package configuration file provided by "planning", but
#9 2.0   CMake did not find one.
#9 2.1 Failed     << arm:cmake               [ Exited with code 1 ]
"""
HEADER = """\
#9 2.0 Errors     << arm:make /ws/logs/arm/build.make.000.log
#9 2.0 /ws/src/arm/arm.cpp:1:10: fatal error: planning/plan.h: No such file or directory
#9 2.1 Failed     << arm:make               [ Exited with code 2 ]
"""
END = '#9 ERROR: process "/bin/sh -c leave-out-failed" did not complete successfully: exit code: 1\n'


def said(log: str) -> Explanation:
    (found,) = explain(io.BytesIO(log.encode())).explanations
    return found


@pytest.mark.parametrize("then", [LACKS, HEADER])
def test_what_was_left_out_is_explained(then: str) -> None:
    found = said(STEP + BEGIN + WITHOUT + then + END)
    assert (found.packages, "search/heuristic.h" in found.error, found.error_line) == (("planning",), True, 3)


def test_so_is_what_was_left_out_before_that() -> None:
    second = BEGIN.replace("planning", "grasping").replace("search/heuristic", "planning/plan")
    log = STEP + BEGIN + WITHOUT + second + WITHOUT.replace("planning", "grasping")
    found = said(log + LACKS.replace("planning", "grasping") + END)
    assert (found.packages, "search/heuristic.h" in found.error) == (("planning",), True)


@pytest.mark.parametrize("left", ["roslab: left out: camera\n", "roslab: left out: apt planning\n", "nothing\n"])
def test_another_failure_is_explained_itself(left: str) -> None:
    after = WITHOUT.splitlines(keepends=True)[0] + f"#9 1.3 {left}"
    found = said(STEP + BEGIN + after + LACKS + END)
    assert (found.packages, found.id) == (("arm",), said(STEP + LACKS + END).id)


def test_a_long_step_keeps_what_was_left_out() -> None:
    many = "".join(f"#9 3.0 [ 50%] Building CXX object {number}\n" for number in range(17_000))
    found = said(STEP + BEGIN + WITHOUT + many + LACKS + END)
    assert found.packages == ("planning",)
