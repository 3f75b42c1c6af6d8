"""What packages of a workspace link by its file beside them is made before the workspace."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
HERE = "${CMAKE_CURRENT_SOURCE_DIR}"
BY_CMAKE = f"target_link_libraries(node {HERE}/../orca/build/src/liborca.a)\n"
BY_MAKE = f"target_link_libraries(node {HERE}/../core/build/libcore.a)\n"
STEPS = "cd demo/orca\nmkdir build\ncd build\ncmake ..\nmake\n"
PAGE = f"git clone https://github.com/lab/demo.git\n{STEPS}sudo make install\ncd ../../core\nmake\n"
CMAKE = 'mkdir --parents build && cd build && cmake -DCMAKE_BUILD_TYPE=Release .. && make --jobs="$(compile-jobs)"'
INSTALLED = f"{CMAKE} install && ldconfig"


def _files(linked: str, page: str = PAGE, tool: str = "catkin") -> dict[str, str]:
    package = f"<package><name>node</name><buildtool_depend>{tool}</buildtool_depend></package>"
    return {
        "README.md": f"# Demo\nROS {'Noetic' if tool == 'catkin' else '2 Humble'}\n```\n{page}```\n",
        "node/package.xml": package,
        "node/CMakeLists.txt": f"project(node)\nfind_package({tool} REQUIRED)\nadd_executable(node a.cpp)\n{linked}",
        "node/a.cpp": "int main() {}\n",
        "orca/CMakeLists.txt": "project(ORCA)\nadd_subdirectory(src)\n",
        "orca/src/CMakeLists.txt": "add_library(orca a.cpp)\n",
        "orca/src/a.cpp": "",
        "core/Makefile": "all: build/libcore.a\nbuild/libcore.a: a.cpp\n\tg++ -c a.cpp\n\tar rvs $@ a.o\n",
    }


@pytest.mark.parametrize("tool", ["catkin", "ament_cmake"])
@pytest.mark.parametrize(
    ("linked", "page", "made"),
    [
        (BY_CMAKE + BY_MAKE, PAGE, [("orca", INSTALLED, True, False), ("core", "make", False, False)]),
        (BY_CMAKE, PAGE, [("orca", INSTALLED, True, False), ("core", "make", False, True)]),
        (BY_MAKE, PAGE, [("core", "make", False, False)]),
        (BY_CMAKE, STEPS, [("orca", CMAKE, True, False)]),
        (BY_CMAKE, "catkin_make\n", [("orca", CMAKE, True, False)]),
        (BY_CMAKE.replace("build/src", "lib"), "catkin_make\n", []),
        (BY_CMAKE.replace("orca", "node/orca"), "catkin_make\n", []),
        ("", PAGE, [("core", "make", False, True)]),
    ],
)
def test_it_is_made_before(
    tree: Tree, linked: str, page: str, made: list[tuple[str, str, bool, bool]], tool: str
) -> None:
    found = tree(_files(linked, page, tool)).scripts
    assert [(each.folder, each.command, each.required, each.after) for each in found] == made


def test_the_steps_stand_before_the_workspace(tmp_path: Path) -> None:
    for name, text in _files(BY_CMAKE + BY_MAKE).items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    places = [text.index(step) for step in ("make --jobs=", "{ make || ", "catkin_make -j")]
    assert places == sorted(places)


def test_a_folder_with_packages_is_none(tree: Tree) -> None:
    files = _files(BY_CMAKE, "catkin_make\n")
    files["orca/src/package.xml"] = files["node/package.xml"].replace(">node<", ">orca<")
    assert tree(files).scripts == ()
