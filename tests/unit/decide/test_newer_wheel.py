"""A torch that pip's index has for CUDA 10 alone comes from PyTorch's own index where the image has CUDA 11."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
FIND = "--find-links https://download.pytorch.org/whl/{}/torch_stable.html"
INDEX = "--extra-index-url https://download.pytorch.org/whl/{}"


@pytest.mark.parametrize(
    ("asked", "options"),
    [
        ("torch==1.12.1\n", (INDEX.format("cu116"),)),
        ("torch==1.10.2\n", (FIND.format("cu113"),)),
        ("torch==1.13.1\n", ()),  # PyPI's is for CUDA 11.7
        ("torch==1.4.0\n", ()),  # there is none for CUDA 11
        ("torch==1.12.1+cpu\n", (INDEX.format("cpu"),)),
        (f"{INDEX.format('cu113')}\ntorch==1.12.1\n", ()),  # its author says where from
        ("numpy\n", ()),
    ],
)
def test_the_index_of_the_image_s_cuda(tree: Tree, asked: str, options: tuple[str, ...]) -> None:
    decision = tree({"train.py": "import torch\ntorch.zeros(1).cuda()\n", "requirements.txt": asked})
    assert decision.python.options == options
    assert not [each for each in decision.python.bounds if each.key == "torch"]


@pytest.mark.parametrize(("asked", "limit"), [("torch", ["torch==1.10.*"]), ("torch>=1.13", [])])
def test_a_free_one_stays_in_the_series_that_pip_takes_for_the_python(tree: Tree, asked: str, limit: list[str]) -> None:
    page = "# Net\n## Requirements\n- Python 3.6\n- CUDA 11.1\n```\npip install -r requirements.txt\n```\n"
    decision = tree({"train.py": "import torch\n", "requirements.txt": f"{asked}\n", "README.md": page})
    assert decision.cuda == "11.1"
    assert [each.written for each in decision.python.bounds if each.key == "torch"] == limit
    assert bool(decision.python.options) is bool(limit)


@pytest.mark.parametrize(("asked", "options"), [("1.10", (INDEX.format("cu115"),)), ("1.13", ())])
def test_one_that_a_page_only_lists(tmp_path: Path, asked: str, options: tuple[str, ...]) -> None:
    (tmp_path / "train.py").write_text("import torch\ntorch.zeros(1).cuda()\n")
    (tmp_path / "README.md").write_text(f"# Net\nRequirements: `python>=3.7`, `torch>={asked}`, `numpy`\n")
    config = Config(pip_date="2022-06-23")
    decision = decide(gather(Repository.open(tmp_path)), config, folder_name="demo")
    assert decision.python.options == options
