"""What is installed by name finds what the project's lists find: it has their further indexes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
WHEELS = "https://download.pytorch.org/whl/cu111"
EXTENSION = """\
from setuptools import setup
from torch.utils.cpp_extension import BuildExtension, CUDAExtension
setup(name="ops", ext_modules=[CUDAExtension("ops", ["ops.cu"])], cmdclass={"build_ext": BuildExtension})
"""
LIST = "numpy==1.19.5\ntorch==1.8.1+cu111\n"


@pytest.mark.parametrize(
    ("written", "given"),
    [
        (f"--extra-index-url {WHEELS}", f"--extra-index-url {WHEELS}"),
        (f"-f {WHEELS}/torch_stable.html", f"--find-links {WHEELS}/torch_stable.html"),
        (f"--index-url {WHEELS}", f"--find-links {WHEELS}/torch_stable.html"),
    ],
)
def test_a_torch_that_extensions_are_built_with_comes_from_the_index_of_its_list(
    tree: Tree, written: str, given: str
) -> None:
    decision = tree({"requirements.txt": f"{written}\n{LIST}", "setup.py": EXTENSION, "ops.cu": ""})
    assert "torch==1.8.1+cu111" in [each.written for each in decision.python.first]
    assert decision.python.options == (given,)


@pytest.mark.parametrize(
    "option", ["--no-binary :all:", "--index-url https://pypi.example.org/simple", "--find-links ./wheels"]
)
def test_other_options_of_a_list_stay_its_own(tree: Tree, option: str) -> None:
    list_ = f"{option}\nnumpy==1.19.5\ntorch==1.8.1\n"
    decision = tree({"requirements.txt": list_, "setup.py": EXTENSION, "ops.cu": ""})
    assert not any(option.partition(" ")[2] in each for each in decision.python.options)


def test_a_list_alone_needs_its_options_only_in_the_file(tree: Tree) -> None:
    decision = tree({"requirements.txt": f"--extra-index-url {WHEELS}\n{LIST}", "run.py": "import torch\n"})
    assert not decision.python.options
