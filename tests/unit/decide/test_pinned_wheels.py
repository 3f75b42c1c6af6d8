"""Among the Pythons that may fit, one for which the pinned packages that have to be compiled have wheels."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"run.py": "import numpy\n"}


@pytest.mark.parametrize(
    ("pins", "python"),
    [
        ("torch==1.0.1\nmatplotlib==3.0.2\n", "3.7"),
        ("torch==1.0.1\nmatplotlib==3.0.2\nscikit_image==0.13.1\n", "3.6"),
        ("torch==1.0.1\nscipy==1.0.0\n", "3.6"),
        ("h5py==2.8.0\n", "3.7"),
        ("Pillow==6.1.0\npandas==0.25.1\n", "3.7"),
        ("matplotlib==3.8.2\nPillow==12.0.0\n", "3.10"),
        ("h5py<2.9\nscipy\n", "3.7"),
        ("torch<1.11\nscipy\n", "3.8"),
        ("h5py<=3.6\nscipy\n", "3.10"),
    ],
)
def test_compiled_packages_have_wheels(tree: Tree, pins: str, python: str) -> None:
    assert tree({**CODE, "requirements.txt": pins}).python.version == python


@pytest.mark.parametrize(
    ("pins", "python", "fits"),
    [
        ("torch==1.8.1\nscikit-image==0.15.0\n", "3.7", "every pin"),
        ("torch==1.8.1\nh5py==3.15.0\nscikit-image==0.15.0\n", "3.7", "most of the pins"),
    ],
)
def test_a_pin_that_contradicts_the_others_is_left_out_alone(tree: Tree, pins: str, python: str, fits: str) -> None:
    decision = tree({**CODE, "requirements.txt": pins})
    said = next(each.reason for each in decision.reasons if each.question == "python" and each.decisive)
    assert (decision.python.version, said.startswith(f"fits {fits} below")) == (python, True)
