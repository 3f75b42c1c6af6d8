"""A torch that a page was tested with, and that is older than every CUDA of an image, where extensions are compiled."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.torch_build import torch_build
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import setup\nfrom torch.utils.cpp_extension import CUDAExtension, BuildExtension\n"
    "setup(name='ops', ext_modules=[CUDAExtension('ops', ['a.cu'])], cmdclass={'build_ext': BuildExtension})\n"
)
PAGE = "# Net\n## Requirements\n- Python 3.6\n- {torch}\n\n## Install\n```\n{install}\n```\n## Run\n`python train.py`\n"
COMPILES = "cd ops && python setup.py install"


def planned(tree: Tree, torch: str, install: str = COMPILES, **more: str) -> Decision:
    files = {"train.py": "import torch\n", "ops/setup.py": SETUP, "ops/a.cu": "__global__ void f() {}\n", **more}
    return tree({**files, "README.md": PAGE.format(torch=torch, install=install)})


def torch_of(decision: Decision) -> set[str]:
    asked = (*decision.python.pip, *decision.python.pip_guessed, *decision.python.bounds)
    return {each.written for each in asked if each.key == "torch"}


@pytest.mark.parametrize(
    ("torch", "install", "found"),
    [
        ("PyTorch 1.1.0", COMPILES, {"torch", "torch==1.7.*"}),
        ("PyTorch 1.8.0", COMPILES, {"torch==1.8.0"}),
        ("PyTorch 1.1.0", f"pip install torch==1.1.0\n{COMPILES}", {"torch==1.1.0"}),
    ],
)
def test_the_oldest_torch_for_the_cuda_of_the_image(tree: Tree, torch: str, install: str, found: set[str]) -> None:
    assert torch_of(planned(tree, torch, install)) == found


def test_a_manifest_that_leaves_it_free(tree: Tree) -> None:
    found = planned(
        tree, "PyTorch 1.6", f"pip install -r requirements.txt\n{COMPILES}", **{"requirements.txt": "torch\n"}
    )
    assert found.cuda == "11.0"
    assert torch_of(found) == {"torch==1.7.*"}


def test_where_nothing_is_compiled_it_stays(tree: Tree) -> None:
    page = PAGE.format(torch="PyTorch 1.1.0", install="pip install numpy")
    assert torch_of(tree({"train.py": "import torch\n", "README.md": page})) == {"torch==1.1.0"}


@pytest.mark.parametrize("asked", ["torch", "torch>=1.0"])
def test_of_a_day_before_any_torch_for_the_cuda_of_the_image(asked: str) -> None:
    limits, options = torch_build([stated(asked)], "11.0", "3.7", "2020-04-15").answer
    assert [each.written for each in limits] == ["torch==1.7.*"]
    assert options == ("--find-links https://download.pytorch.org/whl/cu110/torch_stable.html",)


@pytest.mark.parametrize(
    ("install", "found"),
    [
        ("conda create -n net python=2.7\nconda install pytorch=0.3 torchvision cuda80 -c soumith", {"torch==0.3.*"}),
        ("pip install torch==0.3.1", {"torch==0.3.1"}),
        ("pip install torch==0.4.1", {"torch==0.4.1"}),
        ("pip install torch==1.0.1", {"torch==1.0.1"}),
    ],
)
def test_one_that_pip_s_index_does_not_have_is_looked_for_at_pytorch_s_page(
    tree: Tree, install: str, found: set[str]
) -> None:
    decision = tree({"train.py": "import torch\n", "README.md": f"# Net\n## Install\n```\n{install}\n```\n"})
    assert torch_of(decision) == found
    page = "--find-links https://download.pytorch.org/whl/cu90/torch_stable.html"
    assert (page in decision.python.options) is ("torch==1.0.1" not in found)
    assert decision.python.version in {"2.7", "3.6", "3.7"}


@pytest.mark.parametrize("option", ["", "-f https://download.pytorch.org/whl/cu90/torch_stable.html\n"])
def test_a_file_that_names_that_page_needs_no_other(tree: Tree, option: str) -> None:
    python = tree({"train.py": "import torch\n", "requirements.txt": f"{option}torch==0.4.1\n"}).python
    assert (python.version, python.requirements, bool(python.options)) == ("3.6", ("requirements.txt",), not option)
