"""Programs of a tree that write the code which CMake compiles."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

_MANIFEST = (
    "<package format='3'><name>mpc</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<depend>rclcpp</depend><export><build_type>ament_cmake</build_type></export></package>"
)
_CMAKE = """\
project(mpc)
find_package(ament_cmake REQUIRED)
set(CODE ${CMAKE_CURRENT_SOURCE_DIR}/c_generated_code)
CHECK
add_library(mpc ${CODE}/solver.c)
ament_package()
"""
_CHECK = """\
if(NOT EXISTS ${CODE}/solver.c)
  message(FATAL_ERROR "No solver.\\n"
    "Please run:\\n  cd ${CMAKE_CURRENT_SOURCE_DIR}/scripts\\n  python3 make_solver.py\\n")
endif()"""
_PAGE = "```\ncd ws/src/demo/mpc/scripts\npython3 make_solver.py\n```\n"
_RUN = [("mpc/scripts", "mpc/scripts/make_solver.py", "python3 make_solver.py")]


def _run(
    tree: Callable[[dict[str, str]], Decision],
    *,
    check: str = "",
    page: str = "",
    code: str = "open('c_generated_code/solver.c', 'w')\n",
    more: dict[str, str] | None = None,
) -> list[tuple[str, str, str]]:
    files = {
        "mpc/package.xml": _MANIFEST,
        "mpc/CMakeLists.txt": _CMAKE.replace("CHECK", check),
        "mpc/scripts/make_solver.py": code,
        "README.md": f"# Demo\n{page}",
    }
    return [(each.folder, each.path, each.command) for each in tree(files | (more or {})).scripts]


@pytest.mark.parametrize("page", ["", _PAGE])
def test_what_an_error_of_cmake_names(tree: Callable[[dict[str, str]], Decision], page: str) -> None:
    """CMake stops without the code, and says how to write it: once, whether a page says so too or not."""
    assert _run(tree, check=_CHECK, page=page) == _RUN


@pytest.mark.parametrize(
    "check",
    [
        _CHECK.replace("FATAL_ERROR", "WARNING"),
        _CHECK.replace("NOT EXISTS ${CODE}/solver.c", "NOT ACADOS_FOUND"),  # something else is missing
        _CHECK.replace("make_solver.py", "other.py"),  # the tree has no such program
    ],
)
def test_other_errors_run_nothing(tree: Callable[[dict[str, str]], Decision], check: str) -> None:
    assert _run(tree, check=check) == []


def test_two_programs_of_that_name(tree: Callable[[dict[str, str]], Decision]) -> None:
    """Which of them is meant is not known; one of another package is none of them."""
    assert _run(tree, check=_CHECK, more={"mpc/old/make_solver.py": ""}) == []
    assert _run(tree, check=_CHECK, more={"mpc/old/make_solver.py": "", "other/make_solver.py": ""}) == []


def test_what_a_page_runs_for_an_absent_folder(tree: Callable[[dict[str, str]], Decision]) -> None:
    """The program names the folder that CMake compiles and the tree does not have."""
    code = "EXPORT_TO = 'c_generated_code'\n"
    assert _run(tree, page=_PAGE, code=code) == _RUN
    assert _run(tree, page="```\npython3 mpc/scripts/make_solver.py\n```\n", code=code) == [
        ("", "mpc/scripts/make_solver.py", "python3 mpc/scripts/make_solver.py")
    ]


def test_a_folder_that_is_there_needs_no_program(tree: Callable[[dict[str, str]], Decision]) -> None:
    there = {"mpc/c_generated_code/solver.c": "int x;\n"}
    assert _run(tree, page=_PAGE, code="EXPORT_TO = 'c_generated_code'\n", more=there) == []


def test_a_program_that_names_no_such_folder(tree: Callable[[dict[str, str]], Decision]) -> None:
    assert _run(tree, page=_PAGE, code="print('plots')\n") == []
