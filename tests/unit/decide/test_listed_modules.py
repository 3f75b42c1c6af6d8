"""Modules and frameworks that only a list of the tree names which is not installed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Base, Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
MACHINE = "catkin==0.7.6\nroslib==1.13.5\nrospy==1.12.7\npkg-resources==0.0.0\n"
MAIN = "import {}\nif __name__ == '__main__':\n    pass\n"


def guessed(decision: Decision) -> list[str]:
    return [each.written for each in decision.python.pip_guessed]


def unknown(decision: Decision) -> bool:
    return any("no table knows it: pip's package of that name is tried" in w.message for w in decision.warnings)


@pytest.mark.parametrize(
    ("more", "packages"),
    [
        ({"requirements.txt": f"{MACHINE}rarely-seen==0.2\n"}, ["rarely-seen==0.2"]),
        ({"environment_real.yml": "name: a\ndependencies:\n  - pip:\n    - Rarely_Seen\n"}, ["rarely-seen"]),
        ({"requirements.txt": MACHINE}, ["rarely_seen"]),
        ({"third_party/a/requirements.txt": "rarely-seen==0.2\n"}, ["rarely_seen"]),
    ],
)
def test_a_module_of_no_table_is_the_package_of_that_name_in_a_list(
    tree: Tree, more: dict[str, str], packages: list[str]
) -> None:
    environment = (
        {"environment.yml": "name: b\ndependencies:\n  - python=3.8\n"} if "requirements.txt" not in more else {}
    )
    decision = tree({"main.py": MAIN.format("rarely_seen"), **environment, **more})
    assert guessed(decision) == packages
    by_name = packages == ["rarely_seen"]  # it is imported under its own name, then
    assert unknown(decision) == by_name
    assert decision.python.by_name == (("rarely-seen",) if by_name else ())


@pytest.mark.parametrize(
    ("asked", "packages"),
    [
        ("tensorflow-gpu==1.13.1", ["tensorflow==1.13.1"]),
        ("tensorflow==1.13.1", ["tensorflow==1.13.1"]),
        ("tensorflow-cpu==1.15.0", ["tensorflow-cpu==1.15.0"]),
        ("tensorflow==0.12.1", ["tensorflow"]),
    ],
)
def test_a_framework_has_the_release_of_the_list(tree: Tree, asked: str, packages: list[str]) -> None:
    decision = tree({"main.py": MAIN.format("tensorflow"), "requirements.txt": f"{MACHINE}{asked}\n"})
    assert guessed(decision) == packages


def test_a_release_without_a_wheel_for_the_python_is_not_taken(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(MAIN.format("tensorflow"), encoding="utf-8")
    (tmp_path / "requirements.txt").write_text(f"{MACHINE}tensorflow==1.13.1\n", encoding="utf-8")
    config = Config(base=Base(python="3.11"))
    assert guessed(decide(gather(Repository.open(tmp_path)), config, folder_name="demo")) == ["tensorflow"]


def test_the_rest_of_the_list_limits_what_the_guesses_need(tree: Tree) -> None:
    listed = f"{MACHINE}protobuf==3.7.0\nnumpy==1.16.2\ntorchvision==0.4.0\nsmach==2.0.1\nopencv-python==4.0.0.21\n"
    files = {"main.py": MAIN.format("numpy, cv2"), "requirements.txt": listed}
    decision = tree(files)
    assert [each.written for each in decision.python.bounds if each.origin == "manifest"] == ["protobuf==3.7.0"]
    declared = tree({**files, "setup.py": "from setuptools import setup\nsetup(name='a', install_requires=['six'])\n"})
    assert not [each for each in declared.python.bounds if each.key == "protobuf"]
