"""Tools that check or format code, which a page has contributors install, are of no use in an image."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CPP = {"CMakeLists.txt": "project(demo)\nadd_executable(demo demo.cpp)\n", "demo.cpp": "int main() {}\n"}


@pytest.mark.parametrize(
    ("line", "asked"),
    [
        ("pip3 install pre-commit", []),
        ("pip install black yapf flake8 pytest", ["pytest"]),
        ("pip install yapf==0.40.1", ["yapf"]),
        ("pip install black==22.3", ["black"]),
    ],
)
def test_what_checks_code_is_not_installed_for_a_page(tree: Tree, line: str, asked: list[str]) -> None:
    found = tree({**CPP, "README.md": f"# Contributing\n```\n{line}\n```\n"}).python
    assert [each.name for each in (*found.pip, *found.pip_guessed)] == asked


def test_what_the_authors_own_image_has_stays(tree: Tree) -> None:
    recipe = "FROM ubuntu:22.04\nRUN pip3 install black\n"
    found = tree({**CPP, "docker/builder/Dockerfile": recipe}).python
    assert [each.name for each in (*found.pip, *found.pip_guessed)] == ["black"]
