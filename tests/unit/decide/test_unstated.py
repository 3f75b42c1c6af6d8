"""What packages need and do not ask pip for is installed, and decides on the Python."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"train.py": "import stable_baselines\n", "README.md": "```\npython train.py\n```\n"}


@pytest.mark.parametrize(
    ("listed", "guessed", "python"),
    [
        ("stable-baselines>=2.10\n", ["tensorflow<2"], "3.7"),
        ("stable-baselines\ntensorflow-gpu==1.15.0\n", [], "3.7"),
        ("stable-baselines3\n", [], "3.10"),
        ("numpy\n", [], "3.10"),
    ],
)
def test_the_framework_behind_a_library(tree: Tree, listed: str, guessed: list[str], python: str) -> None:
    found = tree({**CODE, "train.py": "import numpy\n", "requirements.txt": listed}).python
    assert [each.written for each in found.pip_guessed if each.key.startswith("tensorflow")] == guessed
    assert found.version == python


@pytest.mark.parametrize(
    ("files", "gym"),
    [
        ({"README.md": "```\npip install atari-py gym\n```\n"}, ["gym<0.20"]),
        ({"README.md": "```\npip install gym atari-py==0.2.6\n```\n"}, ["gym<0.20"]),
        ({"README.md": "```\npip install gym==0.21 atari-py\n```\n"}, ["gym==0.21"]),
        ({"README.md": "```\npip install gym\n```\n"}, ["gym"]),
        ({"requirements.txt": "gym\natari-py\n"}, ["gym<0.20"]),
        ({"requirements.txt": "gym<0.25\natari-py\n"}, []),
    ],
)
def test_an_emulator_that_newer_versions_of_its_user_do_not_take(
    tree: Tree, files: dict[str, str], gym: list[str]
) -> None:
    found = tree({"play.py": "import gym\n", **files}).python
    assert [each.written for each in found.pip_guessed if each.name == "gym"] == gym


def test_the_repository_itself_is_no_package_to_fetch(tree: Tree) -> None:
    own = "[project]\nname = 'high-way'\nversion = '1'\ndependencies = ['numpy']\n"
    page = "```\npip install git+https://github.com/lab/HighWay\npip install git+https://github.com/lab/other\n```\n"
    found = tree({"pyproject.toml": own, "high_way.py": "import numpy\n", "README.md": page}).python
    assert [each.name for each in found.pip_guessed] == ["other"]


@pytest.mark.parametrize(("pip", "old"), [("pip=9.0.1=py35_4", "9.0.1"), ("pip=21.2", ""), ("pip", ""), ("pip>=9", "")])
def test_a_pip_that_knows_no_wheels_of_later_days(tree: Tree, pip: str, old: str) -> None:
    environment = f"name: a\ndependencies:\n  - python=3.5\n  - {pip}\n  - pip:\n    - numpy\n"
    assert tree({"environment.yml": environment, "a.py": "import numpy\n"}).python.conda_old_pip == old


FROM_GIT = "git+https://github.com/lab/rasterizer.git"


@pytest.mark.parametrize(
    ("torch", "pip", "built", "below"),
    [
        ("pytorch=2.1.2", "pip", FROM_GIT, "25.3"),
        ("pytorch=2.1.2", "pip", "torch-scatter", "25.3"),
        ("pytorch=2.1.2", "pip", "numpy", ""),  # a wheel
        ("pytorch=2.1.2", "pip=23.3", FROM_GIT, ""),
        ("scipy", "pip", FROM_GIT, ""),
    ],
)
def test_a_pip_that_lets_a_setup_py_see_condas_torch(tree: Tree, torch: str, pip: str, built: str, below: str) -> None:
    environment = f"name: a\ndependencies:\n  - python=3.10\n  - {torch}\n  - {pip}\n  - pip:\n    - {built}\n"
    decision = tree({"environment.yml": environment, "a.py": "import numpy\n"})
    assert decision.python.conda_pip_below == below
    assert any(each.answer == f"pip<{below}" for each in decision.reasons) is bool(below)


@pytest.mark.parametrize(
    ("listed", "code", "guessed"),
    [
        ("tensorflow-probability==0.25.0\n", "import numpy\n", ["tensorflow"]),
        ("tensorflow-probability==0.25.0\njax==0.4.30\n", "import distrax\n", []),
        ("tensorflow-probability==0.25.0\njax==0.4.30\n", "import tensorflow as tf\n", ["tensorflow"]),
    ],
)
def test_a_library_that_works_with_another_framework(tree: Tree, listed: str, code: str, guessed: list[str]) -> None:
    found = tree({**CODE, "train.py": code, "requirements.txt": listed}).python
    assert [each.written for each in found.pip_guessed if each.key == "tensorflow"] == guessed
