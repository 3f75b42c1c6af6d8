"""Lines that a tool took for the package of a module which another package of the list brings."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"play.py": "import numpy\nfrom direct.showbase.ShowBase import ShowBase\n"}
SETUP = "from setuptools import setup\nsetup(name='play', py_modules=['play'], install_requires={})\n"


@pytest.mark.parametrize(
    ("lines", "left"),
    [
        (["direct==1.0.1", "panda3d==1.10.10"], "direct==1.0.1"),
        (["serial", "pyserial>=3"], "serial"),
        (["direct==1.0.1", "numpy"], ""),  # the optimiser
        (["pyserial>=3", "numpy"], ""),
    ],
)
def test_they_are_left_out_of_lists_and_projects(tree: Tree, lines: list[str], left: str) -> None:
    for files in ({"requirements.txt": "\n".join(lines)}, {"setup.py": SETUP.format(lines)}):
        found = tree({"requirements.txt": "", "setup.py": "", **CODE, **files})
        asked = {each.written for each in found.python.pip}
        assert asked == ({*lines} - {left} if left else set())
        told = [each.message for each in found.warnings if "is left out" in each.message]
        assert [message.partition(" is left out")[0] for message in told] == [left] * bool(left)
        assert ("gfortran" in {*found.apt, *found.apt_guessed}) == ("direct==1.0.1" in lines and not left)
