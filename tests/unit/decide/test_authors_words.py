"""A path of the author's machine in a page's command is that of the tree, where the tree has its last parts."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {"train.py": "import numpy\n", "cfg/a.yaml": "a: 1\n"}


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("--config /data/me/code/thesis/cfg/a.yaml", ("--config", "cfg/a.yaml")),
        (
            "--config=/data/me/code/cfg/a.yaml --out /data/me/code/exp --data /data/me/sets",
            ("--config=cfg/a.yaml", "--out", "exp", "--data", "/data/me/sets"),
        ),
        (
            "--config /data/me/code/cfg/a.yaml --root /data/me/code --out=/data/me/code/ --data /data/me/codes",
            ("--config", "cfg/a.yaml", "--root", ".", "--out=.", "--data", "/data/me/codes"),
        ),
        ("--config /data/me/code/a.yaml", ("--config", "/data/me/code/a.yaml")),
        ("--config /usr/share/cfg/a.yaml", ("--config", "/usr/share/cfg/a.yaml")),
    ],
)
def test_a_path_of_the_author(tree: Tree, said: str, command: tuple[str, ...]) -> None:
    found = tree({**FILES, "README.md": f"# Demo\n```\npython train.py {said}\n```\n"})
    assert found.command == ("python", "train.py", *command)
