"""Where the author's Dockerfile is built, warnings are about that image."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DOCKER = "FROM python:3.10\nWORKDIR /work\nCOPY . /work\nRUN pip install torch\n{steps}"
FILES = {
    "main.py": "import torch\nimport strange_one\nif __name__ == '__main__':\n    pass\n",
    "requirements.txt": "torch\n",
}
MODULES = '[submodule "sdf"]\n\tpath = third/sdf\n\turl = https://github.com/lab/sdf.git\n'


def test_nothing_is_told_of_what_that_image_does_not_install(tree: Tree) -> None:
    assert [w.file for w in tree(FILES | {"Dockerfile": DOCKER.format(steps="")}).warnings] == []


def test_it_is_told_of_a_generated_image(tree: Tree) -> None:
    found = {w.file for w in tree(FILES).warnings}
    assert found == {"main.py"}


@pytest.mark.parametrize(
    ("steps", "stops"),
    [
        ("RUN cd /code/third/sdf && \\\n  pip install -e .\n", True),
        ("RUN pip install ./third/sdf/\n", True),
        ("RUN pip install sdf\n", False),
        ("RUN ls third/sdf2 my-third/sdf.py\n", False),
    ],
)
def test_a_submodule_that_its_steps_need(tree: Tree, steps: str, *, stops: bool) -> None:
    found = tree({**FILES, "Dockerfile": DOCKER.format(steps=steps), ".gitmodules": MODULES})
    told = [w for w in found.warnings if "stops here" in w.message]
    assert [(w.file, w.line) for w in told] == ([("Dockerfile", 5)] if stops else [])
    assert all("third/sdf" in w.message for w in told)
