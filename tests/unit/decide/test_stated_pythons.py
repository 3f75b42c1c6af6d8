"""Pages that install a Python by apt, or recommend one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"main.py": "import numpy\nif __name__ == '__main__':\n    pass\n", "requirements.txt": "numpy\n"}
PPA = "sudo apt install software-properties-common\nsudo add-apt-repository ppa:deadsnakes/ppa\n"
INSTALL = "sudo apt install python3.8 python3.8-dev python3.8-venv libusb-1.0-0\n"


def page(*lines: str) -> dict[str, str]:
    return {**CODE, "README.md": "# Install\n```\n" + "".join(lines) + "```\n"}


def test_it_states_a_version_and_nothing_else(tree: Tree) -> None:
    decision = tree(page(PPA, INSTALL))
    assert decision.python.version == "3.8"
    assert [name for name in decision.apt_guessed if name.startswith(("python3.", "software"))] == []
    assert "libusb-1.0-0" in decision.apt_guessed
    assert not decision.repositories
    assert not [each for each in decision.warnings if "ppa" in each.message]


def test_another_source_of_the_page_is_told(tree: Tree) -> None:
    decision = tree(page(PPA, "sudo add-apt-repository ppa:them/odd\n", INSTALL))
    assert "software-properties-common" not in decision.apt_guessed  # the image adds the source by itself
    assert decision.repositories == ("ppa:them/odd",)


@pytest.mark.parametrize(
    ("sentence", "version"),
    [
        ("Tested for Python 3.8 - 3.10 (recommended Python 3.8).", "3.8"),
        ("Tested for Python 3.8 - 3.10, Python 3.9 is recommended", "3.9"),
        ("Tested for Python 3.8 - 3.10", "3.10"),
        ("Tested for Python 3.8 - 3.10, pip is recommended.", "3.10"),
    ],
)
def test_the_recommended_one_of_several(tree: Tree, sentence: str, version: str) -> None:
    assert tree({**CODE, "README.md": f"# Demo\n{sentence}\n"}).python.version == version


def test_a_range_of_setup_cfg_on_a_line_of_its_own(tree: Tree) -> None:
    setup = "[metadata]\nname = demo\n[options]\npython_requires =\n    >=3.8, <3.11\n"
    decision = tree({**CODE, "setup.cfg": setup, "setup.py": "from setuptools import setup\nsetup()\n"})
    assert ">=3.8, <3.11" in {each.answer for each in decision.reasons if each.question == "python"}
