"""Code of MATLAB beside other code is told: the image has nothing to run it with."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.errors import NothingToBuildError
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
CODE = {f"sim/step_{name}.m": "x = 1;\n" for name in "abc"} | {"bridge.py": "import numpy\n"}
MODULE = '[submodule "a"]\n\tpath = a\n\turl = https://github.com/lab/a.git\n'
PAGE = {"README.md": "# Rotors\n\nSimulated\nin MATLAB.\n"}


def told(decision: Decision) -> list[tuple[str | None, int | None]]:
    return [(each.file, each.line) for each in decision.warnings if "MATLAB's (" in each.message]


@pytest.mark.parametrize(
    ("files", "place"),
    [
        (PAGE, [("README.md", 4)]),
        ({"sim/rotor.slx": "PK", "README.md": "# Rotors\n"}, [("sim/rotor.slx", 1)]),
        ({"README.md": "# Rotors\n"}, []),
        (PAGE | {".gitmodules": MODULE}, []),
        (PAGE | {f"{name}.py": "import os\n" for name in "klmn"}, []),
        (PAGE | {"README.md": "# MATLAB\n```\noctave sim/step_a.m\n```\n"}, []),
    ],
)
def test_it_is_told_where_it_is_most_of_the_code(
    tree: Tree, files: dict[str, str], place: list[tuple[str, int]]
) -> None:
    assert told(tree(CODE | files)) == place


def test_not_where_roslab_yaml_has_the_one_of_the_host(tmp_path: Path) -> None:
    given = {"roslab.yaml": "format: 3\nmatlab: {host_path: /usr/local/MATLAB/R2020b}\n"}
    for path, text in (CODE | PAGE | given).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    assert told(plan_repository(tmp_path).decision) == []


def test_a_project_of_node_alone_is_called_so(tmp_path: Path) -> None:
    (tmp_path / "package.json").write_text("{}")
    (tmp_path / "main.ts").write_text("let a = 1\n")
    with pytest.raises(NothingToBuildError) as error:
        plan_repository(tmp_path)
    (problem,) = error.value.problems
    assert "but a Node.js project (package.json)" in problem.message
    assert "branch" not in (problem.hint or "")
