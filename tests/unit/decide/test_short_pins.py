"""A pin to the first numbers of a version that has more of them takes any version that begins so."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"run.py": "import cv2\n"}


@pytest.mark.parametrize(
    ("asked", "taken"),
    [
        ("opencv-python==4.2.0", "opencv-python==4.2.0.*"),
        ("opencv_python == 4.5.5", "opencv_python==4.5.5.*"),
        ("opencv-contrib-python-headless==4.5.5", "opencv-contrib-python-headless==4.5.5.*"),
    ],
)
def test_a_list_with_a_short_pin_is_installed_one_by_one(tree: Tree, asked: str, taken: str) -> None:
    decision = tree({**CODE, "requirements.txt": f"numpy==1.21.0\n{asked}\n"})
    assert [each.written for each in decision.python.pip] == ["numpy==1.21.0", taken]
    assert decision.python.requirements == ()
    assert any(f"{taken} is installed" in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    "asked",
    ["opencv-python==4.2.0.34", "opencv-python==3.1.0", "opencv-python>=4.2.0", "opencv-python", "numpy==1.21.0"],
)
def test_other_pins_stay(tree: Tree, asked: str) -> None:
    decision = tree({**CODE, "requirements.txt": f"{asked}\n"})
    assert decision.python.requirements == ("requirements.txt",)


def test_a_project_with_a_short_pin_is_installed_alone(tree: Tree) -> None:
    script = "from setuptools import setup\nsetup(name='arm', install_requires=['opencv-python==4.2.0'])\n"
    decision = tree({**CODE, "arm/__init__.py": "", "setup.py": script})
    assert decision.python.alone == (".",)
    assert "opencv-python==4.2.0.*" in [each.written for each in decision.python.pip]
