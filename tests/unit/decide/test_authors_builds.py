"""Pins to builds that no index has, as a freeze writes them, are those of a release."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("pinned", "taken"),
    [
        ("torchvision==0.6.0a0", "torchvision"),  # torch, which is pinned, tells which
        ("torchvision==0.9.0a0+2a1d7b9", "torchvision"),
        ("torchaudio==0.7.0a0+a853dff", "torchaudio"),
        ("torchvision==0.7.0+78ed10c", "torchvision==0.7.0"),
        ("scipy==1.5.2+computecanada", "scipy==1.5.2"),
        ("pandas==1.0.5+unknown", "pandas==1.0.5"),
    ],
)
def test_a_build_of_somebody_is_the_release(tree: Tree, pinned: str, taken: str) -> None:
    decision = tree({"requirements.txt": f"torch==1.6.0\n{pinned}\n", "run.py": "import torch\n"})
    assert decision.python.requirements == ()
    assert [each.written for each in decision.python.pip] == ["torch==1.6.0", taken]
    (said,) = [each for each in decision.warnings if pinned in each.message]
    assert (said.file, said.line) == ("requirements.txt", 2)
    assert said.message.startswith(f"no index has {pinned}, which was built elsewhere: ")


def test_a_torch_that_was_compiled_is_one_of_its_numbers(tree: Tree) -> None:
    python = tree({"requirements.txt": "torch==1.8.0a0+1606899\nnumpy==1.19.5\n", "run.py": "import torch\n"}).python
    assert [each.written for each in python.pip] == ["torch==1.8.*", "numpy==1.19.5"]


@pytest.mark.parametrize(
    "pinned", ["torchvision==0.7.0+cu101", "torchvision==0.7.0+cpu", "mmcv==0.1a0", "sim==0.3.1+g1234abc"]
)
def test_a_build_of_an_index_stays(tree: Tree, pinned: str) -> None:
    decision = tree({"requirements.txt": f"torch==1.6.0\n{pinned}\n", "run.py": "import torch\n"})
    assert decision.python.requirements == ("requirements.txt",)


def test_a_list_that_conda_exported_has_the_release_for_its_torch(tree: Tree) -> None:
    files = {
        "spec.txt": "# platform: linux-64\npython=3.7.6=h0371630_2\ntorch=1.6.0=pypi_0\ntorchvision=0.6.0a0=pypi_0\n",
        "run.py": "import torch\n",
        "README.md": "```\nconda create --name a --file spec.txt\n```\n",
    }
    decision = tree(files)
    assert [each.written for each in decision.python.pip] == ["torch==1.6.0", "torchvision"]
    assert any(each.message.startswith("no index has torchvision==0.6.0a0") for each in decision.warnings)
