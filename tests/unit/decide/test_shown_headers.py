"""A library that nobody packages and that is linked by its name is compiled where the code includes its header."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.recipes import recipe

Tree = Callable[[dict[str, str]], Decision]
LISTS = "cmake_minimum_required(VERSION 3.11)\nproject(arm C)\nadd_executable(arm arm.c)\n"
CODE = '#include "raylib.h"\nint main(void) { return 0; }\n'
MAKEFILE = "LIBS = -lraylib -lm\narm: arm.c\n\tgcc arm.c -o arm $(LIBS)\n"


@pytest.mark.parametrize(
    ("files", "brought"),
    [
        ({"CMakeLists.txt": f"{LISTS}target_link_libraries(arm raylib)\n", "arm.c": CODE}, True),
        ({"CMakeLists.txt": f"{LISTS}find_package(raylib REQUIRED)\n", "arm.c": "int main(void) {}\n"}, True),
        ({"Makefile": MAKEFILE, "arm.c": CODE}, True),
        ({"CMakeLists.txt": f"{LISTS}target_link_libraries(arm raylib)\n", "arm.c": "int main(void) {}\n"}, False),
        ({"CMakeLists.txt": f"{LISTS}target_link_libraries(arm raylib)\n", "arm.c": CODE, "raylib.h": ""}, False),
        (
            {
                "CMakeLists.txt": f"{LISTS}add_library(raylib lib.c)\ntarget_link_libraries(arm raylib)\n",
                "arm.c": CODE,
                "lib.c": "int a;\n",
            },
            False,
        ),
        ({"Makefile": MAKEFILE.replace("-lraylib ", ""), "arm.c": CODE}, False),
    ],
)
def test_what_is_linked_and_included_is_compiled(tree: Tree, files: dict[str, str], *, brought: bool) -> None:
    decision = tree(files)
    assert ("raylib" in [source.name for source in decision.source]) == brought
    assert not any("raylib" in warning.message for warning in decision.warnings) or not brought


@pytest.mark.parametrize(("day", "ref"), [("2022-01-10", "4.0.0"), ("2024-06-01", "5.0"), (None, "5.5")])
def test_the_release_is_of_the_day_of_the_work(day: str | None, ref: str) -> None:
    assert [built.ref for built in recipe("raylib", "jammy", day=day)] == [ref]
