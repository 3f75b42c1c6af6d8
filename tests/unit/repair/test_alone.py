"""A target of plain CMake that does not compile: the default command's program is built without it."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.config.addition import added
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.leaving import Left, left_out, told
from trees import tree_of

FILES = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(arm CXX)\n"
    "add_subdirectory(app)\nadd_subdirectory(extra)\n",
    "app/CMakeLists.txt": "add_executable(arm_app main.cpp)\n",
    "extra/CMakeLists.txt": "add_executable(arm_extra main.cpp)\n",
    "app/main.cpp": "int main() { return 0; }\n",
    "extra/main.cpp": "int main() { return grip(); }\n",
    "README.md": "# Arm\n\n```\nmkdir build && cd build && cmake .. && make\n./app/arm_app\n```\n",
}
LIBRARY = {
    "extra/CMakeLists.txt": "add_library(arm_${PROJECT_NAME} grip.cpp)\n"
    "set(OURS arm_extra)\nadd_library(arm_extra main.cpp)\ntarget_link_libraries(arm_arm PUBLIC ${OURS})\n",
    "app/CMakeLists.txt": "add_executable(arm_app main.cpp)\n"
    "target_link_libraries(arm_app PRIVATE arm_${PROJECT_NAME})\n",
}
"""The program links a library that links the one which does not compile."""
BY_ALIAS = (
    "add_library(arm::extra ALIAS arm_extra)\nadd_executable(arm_app main.cpp)\n"
    "target_link_libraries(arm_app arm::extra)\n"
)
WAITS = "add_executable(arm_app main.cpp)\nadd_dependencies(arm_app arm_extra)\n"
NEW = "make[1]: *** [CMakeFiles/Makefile2:148: {}/CMakeFiles/arm_{}.dir/all] Error 2"
OLD = "make[1]: *** [{}/CMakeFiles/arm_{}.dir/all] Error 2"
ERROR = "/home/jovyan/arm/extra/main.cpp:1:21: error: 'grip' was not declared in this scope"


def left(folder: Path, files: dict[str, str], *lines: str) -> Left:
    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    command = "cmake ../arm && make --jobs=2"
    log = f'#6 [3/4] RUN {command}\n{said}#6 ERROR: process "/bin/sh -c {command}" did not complete: exit code: 2\n'
    tree_of(folder / "arm", {**FILES, **files})
    return left_out(explain(io.BytesIO(log.encode())), given(plan_repository(folder / "arm")))


@pytest.mark.parametrize("made", [NEW, OLD])
def test_the_program_of_the_command_is_built_alone(tmp_path: Path, made: str) -> None:
    found = left(tmp_path, {}, ERROR, made.format("extra", "extra"))
    why = "for arm_extra does not compile: 'grip' was not declared in this scope at extra/main.cpp:1; "
    why += "the command does not need it"
    assert list(told(found.changes)) == [f"adds build_args: [arm_app], {why}"]
    text = added("format: 3\n", [change.entry for change in found.changes])
    assert text == f"format: 3\nbuild_args:\n  - arm_app  # {why}\n"
    tree_of(tmp_path / "arm", {"roslab.yaml": text})
    program = plan_repository(tmp_path / "arm").plan.workspace.program
    assert program
    assert program.arguments == ("arm_app",)


@pytest.mark.parametrize(
    ("files", "lines"),
    [
        ({}, (ERROR, NEW.format("app", "app"))),
        ({}, (ERROR, NEW.format("extra", "extra"), NEW.format("app", "app"))),
        ({}, ("CMake Error at extra/CMakeLists.txt:1 (find_package):", "  none")),
        ({}, ("c++: fatal error: Killed signal terminated program cc1plus", NEW.format("extra", "extra"))),
        ({"README.md": "# Arm\n"}, (ERROR, NEW.format("extra", "extra"))),
        (LIBRARY, (ERROR, NEW.format("extra", "extra"))),
        ({**LIBRARY, "app/CMakeLists.txt": BY_ALIAS}, (ERROR, NEW.format("extra", "extra"))),
        ({**LIBRARY, "app/CMakeLists.txt": WAITS}, (ERROR, NEW.format("extra", "extra"))),
        ({"roslab.yaml": "format: 3\nbuild_args: [VERBOSE=1]\n"}, (ERROR, NEW.format("extra", "extra"))),
        ({"roslab.yaml": "format: 3\ntest: arm_extra --check\n"}, (ERROR, NEW.format("extra", "extra"))),
        (
            {"data/CMakeLists.txt": "add_custom_target(data ALL COMMAND cp a b)\n"},
            (ERROR, NEW.format("extra", "extra")),
        ),
        (
            {"app/CMakeLists.txt": "add_executable(arm_app main.cpp)\ninstall(TARGETS arm_app DESTINATION bin)\n"},
            (ERROR, NEW.format("app", "app")),
        ),
    ],
)
def test_what_is_needed_or_not_known_is_built_whole(
    tmp_path: Path, files: dict[str, str], lines: tuple[str, ...]
) -> None:
    assert left(tmp_path, files, *lines).changes == ()
