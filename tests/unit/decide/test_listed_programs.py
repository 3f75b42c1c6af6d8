"""A section on running may list programs in code, each with what it does: the first is the default command."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LISTS = "cmake_minimum_required(VERSION 3.10)\nproject(arm CXX)\n" + "".join(
    f"add_executable({name} {name}.cpp)\n" for name in ("reach", "grasp", "wave")
)
FILES = {"CMakeLists.txt": LISTS, **{f"{name}.cpp": "int main() {}\n" for name in ("reach", "grasp", "wave")}}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("## Running the code\n\n* ``grasp``: takes a cup\n* ``wave``: waves\n", ("grasp",)),
        ("## Usage\n\n- `other`: is not compiled\n- `wave` - waves\n", ("wave",)),
        ("## Parameters\n\n- `wave`: how often\n", ("bash",)),
        ("## Running\n\n`wave` waves.\n", ("bash",)),
        ("## Running\n\n- `wave`\n- `grasp` the cup\n", ("bash",)),
        ("## Running\n\n```\n./reach\n```\n\n- `wave`: waves\n", ("reach",)),
        ("## Usage\n\n- `wave`: waves\n\n## Running\n\n```\n./reach --cup\n```\n", ("reach", "--cup")),
    ],
)
def test_the_first_of_a_list_of_programs(tree: Tree, page: str, command: tuple[str, ...]) -> None:
    assert tree({**FILES, "README.md": f"# Arm\n\n{page}"}).command == command


def test_a_hostile_list_takes_no_long_time(tree: Tree) -> None:
    with ends():
        tree({**FILES, "README.md": "## Running\n\n" + "- `" + "a-" * 30_000 + "\n"})
