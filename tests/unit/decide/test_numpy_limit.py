"""NumPy's limit heeds every release that the image gets, whoever names it: a page, a lock or the image's CUDA."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.torch_build import numpy_of
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
LISTS = {"run.py": "import torch\nimport numpy\n", "requirements.txt": "torch\nnumpy\n"}


@pytest.mark.parametrize(("torch", "limited"), [("2.2.0", True), ("2.4.0", False)])
def test_a_torch_that_only_a_page_pins(tree: Tree, torch: str, limited: bool) -> None:
    page = f"# Net\n```\npip install torch=={torch}\npip install -r requirements.txt\n```\n"
    written = {each.written for each in tree({**LISTS, "README.md": page}).python.bounds}
    assert f"torch=={torch}" in written
    assert ("numpy<2" in written) is limited


@pytest.mark.parametrize(
    ("asked", "limited"),
    [
        (["torch", "numpy", "torch==2.2.0"], True),
        (["torch", "numpy", "torch==2.2.*"], True),
        (["torch", "torch<2.3"], True),
        (["torch", "torch<2.4"], False),
        (["torch==2.2.0", "numpy", "numpy==2.1.0"], False),
        (["torch==2.2.0", "numpy", "numpy==1.21.5"], False),
        (["torch", "torch>=2.2", "numpy"], False),
    ],
)
def test_limits_count_like_what_is_asked_for(asked: list[str], limited: bool) -> None:
    assert [each.written for each in numpy_of(map(stated, asked)).answer] == ["numpy<2"] * limited
