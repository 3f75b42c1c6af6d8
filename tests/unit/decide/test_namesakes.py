"""A name that the index gives another project stands for the library that the code imports."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import setup, find_packages\nsetup(name='m', packages=find_packages(), install_requires=[{}])\n"
)


@pytest.mark.parametrize(
    ("asked", "installed", "warned"),
    [("'pinocchio'", "pin", True), ("'pinocchio>=2.6'", "pin", True), ("'pin>=2.6'", "", False)],
)
def test_the_library_is_installed(tree: Tree, asked: str, installed: str, warned: bool) -> None:
    found = tree({"setup.py": SETUP.format(asked), "m/__init__.py": "import pinocchio\n"})
    assert [each.written for each in found.python.pip] == ([installed] if installed else [])
    assert not found.python.pip_guessed
    assert any("pinocchio" in each.message for each in found.warnings) is warned


def test_conda_has_it_by_its_name(tree: Tree) -> None:
    environment = "name: x\nchannels: [conda-forge]\ndependencies:\n- python=3.9\n- pinocchio=2.6\n"
    found = tree({"environment.yml": environment, "main.py": "import pinocchio\n"})
    assert (found.python.conda_file, found.python.pip, found.python.pip_guessed) == ("environment.yml", (), ())
    assert not found.warnings
