"""The packages in which a build tool of ROS says that it stopped."""

from __future__ import annotations

import io

import pytest

from roslab.explain import words
from roslab.explain.answer import explain
from roslab.explain.failed_packages import failed_packages

HOME = "/home/jovyan/ws/src"
COLCON = ("Starting >>> arm_demo", "--- stderr: arm_extra", "Failed   <<< arm_extra [1.2s, exited with code 2]")
CATKIN = (
    "Errors     << arm_extra:make /home/jovyan/ws/logs/arm_extra/build.make.000.log",
    "Failed     << arm_extra:make                 [ Exited with code 2 ]",
    "Failed    <<< arm_extra                      [ 1.2 seconds ]",
    "Abandoned <<< arm_demo                       [ Unrelated job failed ]",
)
ISOLATED = (
    "<== Failed to process package 'arm_extra':",
    "  Command '['make', '-j2']' returned non-zero exit status 2.",
)
MAKE = (
    "make[2]: *** [robot/arm_extra/CMakeFiles/arm_node.dir/build.make:76: robot/arm_extra/main.o] Error 1",
    "make[1]: *** [CMakeFiles/Makefile2:400: robot/arm_extra/CMakeFiles/arm_node.dir/all] Error 2",
    "make: *** [Makefile:146: all] Error 2",
)
CONFIGURE = (
    "CMake Warning at robot/arm_demo/CMakeLists.txt:9 (message):",
    "  nothing",
    "CMake Error at /opt/ros/noetic/share/catkin/cmake/catkinConfig.cmake:83 (find_package):",
    '  Could not find a package configuration file provided by "nowhere" with any of',
    "Call Stack (most recent call first):",
    "  robot/arm_extra/CMakeLists.txt:4 (find_package)",
    "-- Configuring incomplete, errors occurred!",
)
ABSOLUTE = (f"CMake Error at {HOME}/robot/arm_extra/CMakeLists.txt:4 (find_package):", "  no")


@pytest.mark.parametrize(
    ("command", "lines", "wanted"),
    [
        ("RUN colcon build", COLCON, ("arm_extra",)),
        ("RUN catkin build --no-status", CATKIN, ("arm_extra",)),
        ("RUN catkin_make_isolated -j2", ISOLATED, ("arm_extra",)),
        ("RUN headers-first catkin_make -j2", MAKE, ("robot/arm_extra",)),
        ("RUN headers-first catkin_make -j2", CONFIGURE, ("robot/arm_extra",)),
        ("RUN catkin_make", ABSOLUTE, ("robot/arm_extra",)),
        ("RUN cmake . && make", MAKE, ()),
        ("RUN colcon build", ("Aborted  <<< arm_demo [1.2s]", "Finished <<< arm_core [1s]", "Failed to find a"), ()),
        ("RUN colcon build", tuple(f"Failed   <<< p{n} [1.2s, exited with code 2]" for n in range(20)), 8),
    ],
)
def test_it_is_what_the_tool_names(command: str, lines: tuple[str, ...], wanted: tuple[str, ...] | int) -> None:
    found = failed_packages(lines, command)
    assert (len(found) if isinstance(wanted, int) else found) == wanted


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (
            "main.cpp:3:1: error: expected ';' before '}' token",
            "the build failed in the package arm_extra in `RUN ",
        ),
        ("main.cpp:1:10: fatal error: glog/logging.h: No such file or directory", "(package arm_extra): `"),
    ],
)
def test_the_answer_names_it(error: str, said: str) -> None:
    lines = "".join(f"#6 1.2 {line}\n" for line in (error, *COLCON))
    log = f'#6 [3/4] RUN colcon build\n{lines}#6 ERROR: process "/bin/sh -c colcon build" did not complete: 1\n'
    answer = explain(io.BytesIO(log.encode()))
    assert "\npackage: arm_extra\n" in words.text(answer)
    assert said in str(words.problems(answer)[0])
    assert '"packages": [\n        "arm_extra"\n      ]' in words.as_json(answer)
