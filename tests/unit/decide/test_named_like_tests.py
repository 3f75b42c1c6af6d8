"""Programs of a project that has none but those that are named like tests, and names that a page mistypes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.programs import one_letter_off

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nadd_library(demo a.cpp)\n"
TWO = "add_executable(test_pipeline test/a.cpp)\nadd_executable(test_live test/b.cpp)\n"
CODE = {"a.cpp": "#include <vector>\n", "test/a.cpp": "int main() {}\n", "test/b.cpp": "int main() {}\n"}


@pytest.mark.parametrize(
    ("cmake", "names"),
    [
        (TWO, {"test_pipeline", "test_live"}),
        (TWO + "add_executable(run a.cpp)\n", {"run"}),
        (TWO + "add_test(NAME live COMMAND test_live)\n", set()),
        ("find_package(GTest REQUIRED)\n" + TWO, set()),
        (TWO + "target_link_libraries(test_live gtest)\n", set()),
        (f"option(WITH_TESTS off)\nif(WITH_TESTS)\n{TWO}endif()\n", set()),
    ],
)
def test_a_project_whose_programs_are_all_named_like_tests(tree: Tree, cmake: str, names: set[str]) -> None:
    found = tree({**CODE, "CMakeLists.txt": CMAKE + cmake})
    assert {*found.command, *(word for each in found.command_candidates for word in each)} - {"bash"} == names


@pytest.mark.parametrize(
    ("called", "command"),
    [
        ("./test_pipline data", ("test_pipeline", "data")),
        ("./build/test_pipeline data", ("test_pipeline", "data")),
        ("./test_piplin data", ("bash",)),
        ("./other data", ("bash",)),
    ],
)
def test_a_page_that_mistypes_a_program(tree: Tree, called: str, command: tuple[str, ...]) -> None:
    page = f"# Run\n```\n{called}\n```\n"
    assert tree({**CODE, "CMakeLists.txt": CMAKE + TWO, "README.md": page}).command == command


@pytest.mark.parametrize(
    ("called", "names", "command"),
    [
        (
            "bin/odometry files=XXXX/a.zip mode=0",
            ("convert_a", "odometry_kitti", "odometry_euroc"),
            "odometry_kitti mode=0",
        ),
        ("bin/odometry mode=0", ("odometry", "odometry_kitti", "odometry_euroc"), "bin/odometry mode=0"),
        ("bin/odometry mode=0", ("odometry_kitti", "convert_a"), "bash"),
        ("bin/odo mode=0", ("odo_kitti", "odo_euroc"), "bash"),
    ],
)
def test_the_page_of_what_was_forked_names_what_became_several(
    tree: Tree, called: str, names: tuple[str, ...], command: str
) -> None:
    cmake = CMAKE + "".join(f"add_executable({name} a.cpp)\n" for name in names)
    found = tree({**CODE, "CMakeLists.txt": cmake, "README.md": f"# Run\n```\n{called}\n```\n"})
    assert " ".join(found.command).removeprefix("bin/") == command.removeprefix("bin/")


@pytest.mark.parametrize(
    ("name", "among", "meant"),
    [
        ("test_pipline", ("test_pipeline", "test_live"), "test_pipeline"),
        ("stage_one2", ("stage_one1",), None),
        ("mapping", ("mappings", "mappinx"), None),
        ("run", ("ran",), None),
    ],
)
def test_names_that_differ_by_a_letter(name: str, among: tuple[str, ...], meant: str | None) -> None:
    assert one_letter_off(name, among) == meant
