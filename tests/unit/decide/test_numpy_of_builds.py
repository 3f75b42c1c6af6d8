"""Where an author has an old NumPy, packages of old Pythons are compiled for no newer one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.numpy_of_builds import numpy_of_builds
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("lines", "python", "limits"),
    [
        (["numpy==1.19.5", "numpy-quaternion"], "3.8", ["numpy<=1.19.5"]),
        (["numpy<1.20", "numpy-quaternion"], "3.7", ["numpy<1.20"]),
        (["numpy>=1.17,<1.20", "numpy-quaternion"], "3.8", ["numpy<1.20"]),
        (["numpy==1.19.*", "numpy-quaternion"], "3.8", ["numpy==1.19.*"]),
        (["numpy<=1.19.5", "numpy-quaternion"], "3.8", ["numpy<=1.19.5"]),
        (["numpy~=1.19.2", "numpy-quaternion"], "3.8.10", ["numpy~=1.19.2"]),
        (["numpy==1.19.5", "scipy"], "3.8", []),  # it has wheels
        (["numpy==1.19.5"], "3.8", []),
        (["numpy>=1.19.5", "numpy-quaternion"], "3.8", []),
        (["numpy", "numpy-quaternion"], "3.8", []),
        (["numpy==1.24.4", "numpy-quaternion"], "3.8", []),  # the newest of this Python
        (["numpy==1.19.5", "numpy-quaternion"], "3.9", []),  # what is compiled for NumPy 2 runs with it
        (["numpy==1.19.5", "numpy-quaternion"], None, []),
        (["numpy==1.19.5; python_version < '3'", "numpy-quaternion"], "3.8", []),
        (["numpy==1.19.5", "numpy>=1.20", "numpy-quaternion"], "3.8", []),
    ],
)
def test_the_limit_of_what_is_compiled(lines: list[str], python: str | None, limits: list[str]) -> None:
    found = numpy_of_builds([stated(line, "manifest", "list.txt") for line in lines], python)
    assert [each.written for each in found.answer] == limits
    assert len(found.reasons) == len(limits)


def test_it_is_a_constraint_of_the_image(tree: Tree) -> None:
    files = {
        "requirements.txt": "numpy==1.19.5\nnumpy-quaternion\n",
        ".python-version": "3.8\n",
        "a.py": "import numpy\n",
    }
    found = tree(files)
    assert found.python.version == "3.8"
    assert "numpy<=1.19.5" in [each.written for each in found.python.bounds]
