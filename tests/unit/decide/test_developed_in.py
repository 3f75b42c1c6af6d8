"""The Dockerfile of the container that the author works in says what the code needs, where nothing else does."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LINES = "FROM some/simulator\nRUN pip3 install stable-baselines3==1.4.0\nCMD bash\n"
CODE = {"train.py": "import stable_baselines3\n"}


@pytest.mark.parametrize(
    ("path", "files", "asked"),
    [
        (".devcontainer/Dockerfile", {}, "stable-baselines3==1.4.0"),
        (".github/Dockerfile", {}, "stable-baselines3"),
        (".devcontainer/Dockerfile", {"requirements.txt": "numpy\n"}, "stable-baselines3"),
    ],
)
def test_pins_of_a_devcontainer(tree: Tree, path: str, files: dict[str, str], asked: str) -> None:
    found = tree({**CODE, **files, path: LINES}).python
    assert [each.text for each in found.pip_guessed if each.name == "stable-baselines3"] == [asked]
