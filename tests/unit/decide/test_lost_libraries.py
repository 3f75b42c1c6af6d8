"""A library of the tree that a package links by its file, and that is not there, stops that package alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
SOLVER = 'set(SOLVER "${PROJECT_SOURCE_DIR}/../solver/lib")\n'
LINKS = "target_link_libraries(a ${SOLVER}/libsolver.so ${catkin_LIBRARIES})\n"


def _files(lines: str, **more: str) -> dict[str, str]:
    files = {"README.md": "ROS Noetic\n", **more}
    for name, said in (("mine", lines), ("other", "")):
        start = f"project({name})\nfind_package(catkin REQUIRED roscpp)\ncatkin_package()\nadd_executable(a a.cpp)\n"
        manifest = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
        files |= {f"{name}/package.xml": manifest, f"{name}/CMakeLists.txt": start + said}
        files |= {f"{name}/a.cpp": "int main() {}\n"}
    return files


def _told(decision: Decision) -> list[str]:
    return [each.message for each in decision.warnings if "its build does not make" in each.message]


@pytest.mark.parametrize(
    "lines", [SOLVER + LINKS, "target_link_libraries(a ${CMAKE_CURRENT_SOURCE_DIR}/../solver/lib/libsolver.so)\n"]
)
def test_what_nothing_makes_is_told(tree: Tree, lines: str) -> None:
    decision = tree(_files(lines))
    (told,) = _told(decision)
    assert told.startswith("mine links solver/lib/libsolver.so, ")
    assert decision.may_fail == ("mine",)


def test_a_submodule_without_a_manifest_is_not_compiled(tree: Tree) -> None:
    modules = '[submodule "solver"]\n\tpath = solver\n\turl = https://github.com/lab/solver\n'
    decision = tree(_files(SOLVER + LINKS, **{".gitmodules": modules}))
    (told,) = _told(decision)
    assert "which the repository may not have" in told
    assert decision.may_fail == ()  # it may have it compiled
    assert "solver: a submodule without package.xml is not compiled" in told


@pytest.mark.parametrize(
    ("lines", "more"),
    [
        (SOLVER + LINKS, {"solver/lib/libsolver.so": "binary"}),
        (SOLVER + LINKS, {"solver/CMakeLists.txt": "project(solver)\nadd_library(solver b.cpp)\n"}),
        (SOLVER + LINKS, {"solver/Makefile": "all:\n\tg++ -shared b.cpp -o lib/libsolver.so -lz\n"}),
        (f"{SOLVER}if(WITH)\n{LINKS}endif()\n", {}),
        (f"{SOLVER}execute_process(COMMAND make_it)\n{LINKS}", {}),
        (SOLVER, {}),
        (LINKS, {}),
        ("add_library(s SHARED b.cpp)\nset_target_properties(s PROPERTIES OUTPUT_NAME solver)\n" + SOLVER + LINKS, {}),
        (
            SOLVER + LINKS,
            {"README.md": "ROS Noetic\n```\n./deps.sh\n```\n", "deps.sh": "cd solver\ng++ -shared b.cpp\n"},
        ),
        (SOLVER + LINKS, {"README.md": "ROS Noetic\n```\nwget https://x.org/libsolver.so\n```\n"}),
        ("add_library(solver b.cpp)\n" + SOLVER + LINKS, {}),
        ("target_link_libraries(a ${CMAKE_BINARY_DIR}/lib/libsolver.so)\n", {}),
    ],
)
def test_what_may_be_made_or_is_there_is_not(tree: Tree, lines: str, more: dict[str, str]) -> None:
    assert _told(tree(_files(lines, **more))) == []


def test_the_commands_of_roslab_yaml_may_make_it(tmp_path: Path) -> None:
    files = _files(SOLVER + LINKS, **{"roslab.yaml": "format: 3\ncustom:\n  - cd solver && ./make_it\n"})
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    assert _told(plan_repository(tmp_path).decision) == []


def test_a_page_about_the_folder_is_no_command(tree: Tree) -> None:
    assert len(_told(tree(_files(SOLVER + LINKS, **{"README.md": "ROS Noetic. The solver is quick.\n"})))) == 1
