"""A plain project of CMake that compiles code which the tree does not have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
OPTION = 'option(SAMPLES "programs" ON)\nif(SAMPLES)\n{}endif()\n'
PROGRAMS = "add_executable(show show.cpp lib/glad.c)\nadd_executable(film film.cpp lib/glad.c)\n"


def decided(tree: Tree, cmake: str, readme: str = "# Demo\n") -> tuple[Decision, list[str]]:
    files = {"CMakeLists.txt": f"project(demo)\nadd_library(core core.cpp)\n{cmake}", "README.md": readme}
    decision = tree(files | dict.fromkeys(("core.cpp", "show.cpp", "film.cpp"), "int main() {}\n"))
    return decision, [each.message for each in decision.warnings if "which the tree does not have" in each.message]


def test_the_option_for_which_it_is_compiled_is_off(tree: Tree) -> None:
    decision, told = decided(tree, OPTION.format(PROGRAMS))
    assert decision.cmake_options == ("-DSAMPLES=OFF",)
    assert decision.command == ("bash",)
    why = "it is configured with -DSAMPLES=OFF where nothing else sets that, and makes nothing of what it is for"
    assert told == [
        f"CMake compiles lib/glad.c, which the tree does not have: {why}; add the file, or correct the path"
    ]


@pytest.mark.parametrize(
    "cmake",
    [
        OPTION.format(PROGRAMS.replace(" lib/glad.c", "")),
        OPTION.format(f"configure_file(glad.c.in lib/glad.c)\n{PROGRAMS}"),
        OPTION.format(PROGRAMS).replace(" ON)", " OFF)"),
        OPTION.format(PROGRAMS.replace("lib/glad.c", "${GLAD}/glad.c")),
        f"if(UNIX)\n{PROGRAMS}endif()\n",
    ],
)
def test_an_option_stays_where_all_is_there_or_may_be(tree: Tree, cmake: str) -> None:
    decision, told = decided(tree, cmake)
    assert "-DSAMPLES=OFF" not in decision.cmake_options
    assert told == []


def test_it_stays_as_a_page_has_it(tree: Tree) -> None:
    decision, _ = decided(tree, OPTION.format(PROGRAMS), "# Demo\n```\ncmake -DSAMPLES=ON .\nmake\n```\n")
    assert decision.cmake_options == ("-DSAMPLES=ON",)


def test_nothing_is_told_of_a_build_that_pip_does_without(tree: Tree) -> None:
    page = "# Demo\n```\npip install demo\n```\n## Usage\n```\npython main.py\n```\n"
    files = {"CMakeLists.txt": f"project(demo)\n{OPTION.format(PROGRAMS)}", "README.md": page}
    code = {f"demo/{name}.py": "import numpy\n" for name in ("__init__", "arm", "hand", "leg", "eye", "ear")}
    files |= {"main.py": "import demo\nprint('a')\n", "pyproject.toml": '[project]\nname = "demo"\nversion = "1"\n'}
    decision = tree(files | code)
    assert decision.kind == "python"
    assert not any("CMake compiles" in each.message for each in decision.warnings)


def test_it_is_told_where_it_is_compiled_in_any_case(tree: Tree) -> None:
    _, told = decided(tree, PROGRAMS)
    assert told == [
        "CMake compiles lib/glad.c, which the tree does not have: cmake will stop; add the file, or correct the path"
    ]


@pytest.mark.parametrize("each", [OPTION.replace("SAMPLES", "S{0}"), "{}"])
def test_any_number_of_them_takes_no_long_time(tree: Tree, each: str) -> None:
    two = "add_executable(p{0} f{0}x.cpp)\nadd_library(q{0} f{0}x.cpp)\n"
    cmake = "".join(each.replace("{}", two).format(number) for number in range(9000))
    with ends():
        _, told = decided(tree, cmake)
    assert told
