"""Two bounds of one package that exclude each other are never both written: that of the code gives way, and is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.bounds import excluded
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import setup\nfrom torch.utils.cpp_extension import CUDAExtension, BuildExtension\n"
    "setup(name='ops', ext_modules=[CUDAExtension('ops', ['a.cu'])], cmdclass={'build_ext': BuildExtension})\n"
)
PAGE = (
    "# Net\n## Requirements\n- Python {python}\n- CUDA {cuda}\n\n"
    "```\npip install torch\ncd ops && python setup.py install\n```\n"
)
CODE = "import torch\nfrom torch._six import inf\n"


@pytest.mark.parametrize(
    ("one", "other", "found"),
    [
        ("torch<2", "torch==2.7.*", True),
        ("torch<2", "torch==1.13.1+cu117", False),
        ("torch<2", "torch>=1.8", False),
        ("numpy<1.24", "numpy<2", False),
        ("numpy<1.24", "numpy>=1.24", True),
        ("numpy<2.0", "numpy>1.26", False),
        ("gym<0.26", "gym==0.26.2", True),
        ("gym<0.26", "gymnasium==0.29", False),
        ("numpy<2", "numpy", False),
    ],
)
def test_which_exclude_each_other(one: str, other: str, *, found: bool) -> None:
    assert excluded(stated(one), [stated(other)]) is found
    assert excluded(stated(other), [stated(one)]) is found


def planned(tree: Tree, python: str, cuda: str) -> tuple[set[str], list[str]]:
    page = PAGE.format(python=python, cuda=cuda)
    files = {"README.md": page, "train.py": CODE, "ops/setup.py": SETUP, "ops/a.cu": "__global__ void f() {}\n"}
    decision = tree(files)
    bounds = {each.written for each in decision.python.bounds if each.key == "torch"}
    return bounds, [each.message for each in decision.warnings if "torch<2" in each.message]


def test_the_bound_of_the_code_gives_way_to_the_cuda(tree: Tree) -> None:
    bounds, told = planned(tree, "3.12", "12.8")
    assert bounds == {"torch==2.7.*"}
    why = "the code uses torch._six, which newer versions no longer have, and may stop there"
    assert told == [f"torch<2 is not kept to, for torch==2.7.* is installed: {why}"]


def test_one_that_the_cuda_has_stays(tree: Tree) -> None:
    bounds, told = planned(tree, "3.10", "11.7")
    assert "torch<2" in bounds
    assert not told


def test_one_without_a_wheel_for_the_python_gives_way(tree: Tree) -> None:
    project = "[project]\nname = 'net'\nversion = '1'\nrequires-python = '>=3.12'\ndependencies = ['torch']\n"
    decision = tree({"pyproject.toml": project, "net/__init__.py": "", "net/train.py": CODE})
    assert not [each for each in decision.python.bounds if each.key == "torch" and each.below]
    assert any("it has no wheel for Python 3.12" in each.message for each in decision.warnings)
