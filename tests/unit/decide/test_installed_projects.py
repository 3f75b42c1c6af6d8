"""A page that installs the project of C++ after it compiled it has it installed in the image, too."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
CODE = {
    "CMakeLists.txt": "project(arm CXX)\nadd_library(arm arm.cpp)\ninstall(TARGETS arm DESTINATION lib)\n",
    "arm.cpp": "#include <vector>\nint arm() { return 1; }\n",
    ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/arm\n',
    ".git/HEAD": "ref: refs/heads/main\n",
}
CLONED = "```\ngit clone https://github.com/lab/arm\ncd arm\nmkdir build && cd build\ncmake ..\n{}\n```\n"
OTHER = "```\ngit clone https://github.com/lab/leg\ncd leg\nmkdir build && cd build\ncmake ..\nmake install\n```\n"


@pytest.mark.parametrize(
    ("page", "installed"),
    [
        (CLONED.format("make install -j4"), True),
        (CLONED.format("make\nsudo make install"), True),
        (CLONED.format("cmake --build .\n[sudo] cmake --build . --target install"), True),
        (CLONED.format("make"), False),
        (OTHER, False),
    ],
)
def test_a_project_that_a_page_installs(tree: Tree, page: str, installed: bool) -> None:
    assert tree({**CODE, "README.md": page}).installed == installed


def test_it_is_installed_by_root_after_it_was_compiled(tmp_path: Path) -> None:
    tree_of(tmp_path, {**CODE, "README.md": CLONED.format("make install")})
    lines = dockerfile(plan_repository(tmp_path).plan).splitlines()
    at = next(number for number, line in enumerate(lines) if line.startswith("RUN install-program "))
    assert any("make --jobs" in line for line in lines[:at])
    assert at > max(number for number, line in enumerate(lines) if line.startswith("FROM ")), "in the image itself"
    assert "USER root" in lines[at - 4 : at]
    assert lines[at + 1] == "USER ${NB_USER}"


@pytest.mark.parametrize(
    ("made", "page", "on_path"),
    [
        ("add_library(arm arm.cpp)\n", "make install", False),
        ("add_library(arm arm.cpp)\n", "make", True),
        ("add_executable(arm arm.cpp)\n", "make install", True),
    ],
    ids=["library", "not installed", "program"],
)
def test_where_no_program_is_compiled_its_folder_is_not_on_the_path(
    tmp_path: Path, made: str, page: str, *, on_path: bool
) -> None:
    cmake = f"project(arm CXX)\n{made}install(TARGETS arm DESTINATION lib)\n"
    tree_of(tmp_path, {**CODE, "CMakeLists.txt": cmake, "README.md": CLONED.format(page)})
    program = plan_repository(tmp_path).plan.workspace.program
    assert program is not None
    assert program.on_path is on_path
