"""What a page gives as a repository with a branch, or clones for CMake, is no package of pip's index."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"plan.py": "import gtsam\nimport numpy\n"}
LINK = "[GTSAM](https://github.com/borglab/gtsam/tree/wrap-export)"
BUILD = "git clone https://github.com/borglab/gtsam.git\ncd gtsam\nmkdir build && cd build\ncmake ..\nmake install\n"
CLONE = f"# Install\n```\n{BUILD}```\n"
FOUND = {"CMakeLists.txt": "project(demo)\nfind_package(GTSAM REQUIRED)\nadd_executable(a a.cpp)\n", "a.cpp": ""}


@pytest.mark.parametrize(
    ("item", "reason"),
    [
        (f"{LINK} == `wrap_export`, a library", "imported, declared nowhere"),
        (f"{LINK} = develop", "imported, declared nowhere"),
        (f"{LINK} == 4.1.1", "a page lists it"),
        ("GTSAM 4.1.1", "a page lists it"),
    ],
)
def test_a_link_with_a_branch_names_no_package(tree: Tree, item: str, reason: str) -> None:
    found = tree({**CODE, "README.md": f"# Prerequisites\n\n- {item}\n"})
    assert [each.reason for each in found.reasons if each.answer.startswith("gtsam")] == [reason]


@pytest.mark.parametrize(
    ("page", "cmake", "guessed"),
    [
        ("", FOUND, True),
        (CLONE, FOUND, False),
        (f"# Prerequisites\n\n- GTSAM 4.1.1\n\n{CLONE}", FOUND, False),
        (f"{CLONE}\n```\npip install gtsam\n```\n", FOUND, True),
        (CLONE, {**FOUND, "CMakeLists.txt": FOUND["CMakeLists.txt"].replace("REQUIRED", "QUIET")}, True),
    ],
)
def test_what_cmake_finds_and_a_page_clones(tree: Tree, page: str, cmake: dict[str, str], *, guessed: bool) -> None:
    found = tree({**CODE, **cmake, "README.md": f"Python 3\n\n{page}"})
    assert any(each.key == "gtsam" for each in found.python.pip_guessed) is guessed
