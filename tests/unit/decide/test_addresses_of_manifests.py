"""An address of git that one manifest gives a package holds for the other lines of that package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = "from setuptools import setup\nsetup(name='play', install_requires=['hand_reader @ git+https://github.com/lab/{}'])\n"
URL = "git+https://github.com/lab/hand_reader.git"


def asked(found: Decision, name: str) -> list[str]:
    return [each.url or each.written for each in (*found.python.pip, *found.python.pip_guessed) if each.key == name]


@pytest.mark.parametrize("line", ["hand-reader==1.0.0", "hand_reader", "Hand.Reader>=1"])
@pytest.mark.parametrize("place", ["setup.py", "tools/setup.py", "environment.yml", "requirements/other.txt"])
def test_other_lines_take_it_from_there(tree: Tree, line: str, place: str) -> None:
    text = SETUP.format("hand_reader.git") if place.endswith(".py") else f"hand_reader @ {URL}\n"
    text = f"name: a\ndependencies:\n  - python=3.10\n  - pip:\n    - {text}" if place.endswith("yml") else text
    page = "```\npip install -r requirements.txt\npython play.py\n```\n"
    files = {"README.md": page, "requirements.txt": f"numpy\n{line}\n", "play.py": "import numpy\nimport hand_reader\n"}
    found = tree({**files, place: text})
    assert asked(found, "hand-reader") == [URL]


@pytest.mark.parametrize(
    ("line", "name"),
    [("numpy", "numpy"), ("numpy==1.26.4", "numpy"), ("hand-reader @ git+https://github.com/ann/h.git", "hand-reader")],
)
def test_what_is_of_the_index_or_has_an_address_of_its_own_stays(tree: Tree, line: str, name: str) -> None:
    other = f"numpy @ git+https://github.com/numpy/numpy\nhand_reader @ {URL}\n"
    files = {"requirements.txt": f"{line}\n", "docker/requirements.txt": other, "play.py": "import numpy\n"}
    found = tree({**files, "README.md": "```\npip install -r requirements.txt\npython play.py\n```\n"})
    assert asked(found, name) == []
    assert found.python.requirements == ("requirements.txt",)


def test_a_package_of_no_index_comes_from_its_repository(tree: Tree) -> None:
    found = tree({"requirements.txt": "oculus-reader==1.0.0\n", "play.py": "import oculus_reader\n"})
    assert asked(found, "oculus-reader") == ["git+https://github.com/rail-berkeley/oculus_reader"]
    guessed = tree({"requirements.txt": "numpy\n", "play.py": "import oculus_reader\n"})
    assert asked(guessed, "oculus-reader") == ["git+https://github.com/rail-berkeley/oculus_reader"]
