"""A pin of a release that there never was becomes the newest one before it, and is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "import numpy\nimport torch\n\nif __name__ == '__main__':\n    print(torch, numpy)\n"


def said(decision: Decision) -> list[tuple[str, int]]:
    return [(each.file or "", each.line or 0) for each in decision.warnings if "there never was" in each.message]


@pytest.mark.parametrize(
    ("line", "taken", "cuda"), [("torch==1.14.0", "torch<1.14.0", "11.7"), ("torch==0.5.0", "torch<0.5.0", None)]
)
def test_the_newest_before_it_is_taken(tree: Tree, line: str, taken: str, cuda: str | None) -> None:
    decision = tree({"requirements.txt": f"numpy\n{line}\n", "main.py": MAIN})
    asked = [*decision.python.pip, *decision.python.pip_guessed]
    assert [each.written for each in asked if each.key == "torch"] == [taken]
    assert said(decision) == [("requirements.txt", 2)]
    assert cuda is None or (decision.cuda, decision.python.version) == (cuda, "3.10")


def test_one_that_there_was_stays(tree: Tree) -> None:
    decision = tree({"requirements.txt": "numpy\ntorch==1.13.1\n", "main.py": MAIN})
    assert said(decision) == []


@pytest.mark.parametrize("line", ["numpy==1.20.3/1.21.0", "numpy == 1.20.3 or 1.21.0", "numpy==1.20.3 / ==1.21"])
def test_of_two_versions_the_first_is_taken(tree: Tree, line: str) -> None:
    decision = tree({"requirements.txt": f"{line}\nscipy\n", "main.py": "import numpy\nprint(numpy)\n"})
    asked = [*decision.python.pip, *decision.python.pip_guessed]
    assert [each.written for each in asked if each.key == "numpy"] == ["numpy==1.20.3"]
    assert [each.line for each in decision.warnings if "pip would refuse this line" in each.message] == [1]
