"""The first line of a program that a page runs may name one that no image has: a terminal, expect."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.decide.decision import Decision
from roslab.evidence.prose.first_lines import FIRST_LINE

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "arm/package.xml": "<package format='2'><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
    "arm/CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
}
RUNS = "# Running\n\n    rosrun arm start_all\n"


@pytest.mark.parametrize(
    ("page", "file", "line", "brought"),
    [
        (RUNS, "arm/scripts/start_all", "#!/usr/bin/screen -c", {"screen"}),
        (RUNS, "arm/start_all", "#!/usr/bin/env expect", {"expect"}),
        (RUNS, "arm/scripts/start_all", "#!/bin/bash", set[str]()),
        (RUNS, "arm/scripts/start_all", "#!/usr/bin/perl", set[str]()),
        (RUNS, "arm/scripts/start_all", "screen -c", set[str]()),
        (RUNS, "leg/scripts/start_all", "#!/usr/bin/screen -c", set[str]()),  # of no package of that name
        (RUNS, "arm/scripts/other", "#!/usr/bin/screen -c", set[str]()),  # no page runs it
        ("# Usage\n\n    ./start.sh\n", "start.sh", "#!/usr/bin/expect -f", {"expect"}),
        ("# Usage\n\n    bash start.sh\n", "start.sh", "#!/usr/bin/expect -f", set[str]()),  # it starts by bash
    ],
)
def test_what_a_first_line_names_is_installed(tree: Tree, page: str, file: str, line: str, brought: set[str]) -> None:
    decision = tree({**PACKAGE, "README.md": page, file: f"{line}\ntext\n"})
    assert {"screen", "expect", "perl"} & {*decision.apt_guessed} == brought
    said = [reason for reason in decision.reasons if reason.answer in brought]
    assert [(reason.file, reason.line) for reason in said] == [(file, 1)] * len(brought)


def test_which_of_two_files_is_meant_is_not_guessed(tree: Tree) -> None:
    lines = {f"arm/{folder}/start_all": f"#!/usr/bin/{name}\n" for folder, name in (("a", "screen"), ("b", "expect"))}
    assert not {"screen", "expect"} & {*tree({**PACKAGE, "README.md": RUNS, **lines}).apt_guessed}


@pytest.mark.parametrize(
    ("line", "program"),
    [
        ("#!/usr/bin/env -S /opt/bin/expect -f", "expect"),
        ("#! /bin/zsh", "zsh"),
        ("#!\n/opt/x", None),  # the line names none
        ("#!" + "/" * 60_000 + "\0", None),
        ("#!" + "/env " * 12_000 + "\0", "env"),
    ],
)
def test_a_first_line_of_any_length_is_read_once(line: str, program: str | None) -> None:
    with ends():
        match = FIRST_LINE.match(line)
    assert (match[1] if match else None) == program
