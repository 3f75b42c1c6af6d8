"""Requirement files that a page puts into different environments."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "main.py": "import numpy\nif __name__ == '__main__':\n    pass\n",
    "requirements.txt": "numpy\nclip @ git+https://github.com/openai/CLIP.git\n",
    "requirements_static.txt": "numpy==1.24.3\ntorch==1.8.0\n",
}
VENV = "python3 -m venv ./{0}\nsource ./{0}/bin/activate\npip install -r ./{1}\n"
CONDA = "conda create -n {0} python=3.8\nconda activate {0}\npip install -r {1}\n"


def page(*blocks: str) -> dict[str, str]:
    return {**FILES, "README.md": "# Install\n" + "".join(f"```\n{block}```\n\nOr\n\n" for block in blocks)}


@pytest.mark.parametrize("form", [VENV, CONDA])
@pytest.mark.parametrize("turned", [False, True])
def test_the_list_of_another_environment_is_left_out(tree: Tree, form: str, turned: bool) -> None:
    blocks = [form.format("env", "requirements.txt"), form.format("train", "requirements_static.txt")]
    decision = tree(page(*(reversed(blocks) if turned else blocks)))
    assert decision.python.requirements == ("requirements.txt",)
    assert decision.kind == "python"  # its torch is not there
    told = [w.message for w in decision.warnings if w.file == "requirements_static.txt"]
    assert any("an environment of its own" in message for message in told)


@pytest.mark.parametrize(
    "blocks",
    [
        (VENV.format("env", "requirements.txt") + "pip install -r requirements_static.txt\n",),
        (VENV.format("env", "requirements.txt"), "source env/bin/activate\npip install -r requirements_static.txt\n"),
        ("pip install -r requirements.txt\npip install -r requirements_static.txt\n",),
    ],
)
def test_two_lists_of_one_environment_are_both_installed(tree: Tree, blocks: tuple[str, ...]) -> None:
    decision = tree(page(*blocks))
    files = {*decision.python.requirements, *(w.file for w in decision.warnings)}
    assert {"requirements.txt", "requirements_static.txt"} <= files
    assert not any("an environment of its own" in w.message for w in decision.warnings)
