"""A pin to a nightly build that the index has dropped takes the stable release of that number."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"run.py": "import tensorflow\n"}


@pytest.mark.parametrize(
    ("asked", "taken"),
    [
        ("tf-nightly==2.12.0.dev20230203", "tensorflow==2.12.*"),
        ("tf_nightly == 2.9.0.dev2022020508", "tensorflow==2.9.*"),
        ("tensorflow-text-nightly==2.12.0.dev20230203", "tensorflow-text==2.12.*"),
    ],
)
def test_the_stable_release_is_installed(tree: Tree, asked: str, taken: str) -> None:
    decision = tree({**CODE, "requirements.txt": f"absl-py\n{asked}\n"})
    assert [each.written for each in decision.python.pip if each.origin == "manifest"] == ["absl-py", taken]
    assert decision.python.requirements == ()
    assert [w.line for w in decision.warnings if f"{taken} is installed" in w.message] == [2]


@pytest.mark.parametrize(
    "asked",
    [
        "tf-nightly",
        "tf-nightly>=2.12.0.dev20230203",
        "tf-nightly==2.30.0.dev20270101",
        "keras-nightly==2.5.0.dev2021020510",
    ],
)
def test_what_the_index_may_have_stays(tree: Tree, asked: str) -> None:
    decision = tree({**CODE, "requirements.txt": f"{asked}\n"})
    assert decision.python.requirements == ("requirements.txt",)
