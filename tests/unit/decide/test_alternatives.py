"""Of several ways in which a page installs torch exactly one is taken, with its CUDA."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
STABLE = "https://download.pytorch.org/whl/torch_stable.html"
WHEELS = "https://download.pytorch.org/whl"


def _torch(decision: Decision) -> set[str]:
    asked = (*decision.python.pip, *decision.python.pip_guessed)
    return {each.written for each in asked if each.key in {"torch", "torchvision"}}


def _page(text: str) -> dict[str, str]:
    return {"README.md": f"# Installation\n{text}\n", "train.py": "import torch\nimport torchvision\n"}


def _block(*lines: str) -> str:
    return "```\n" + "\n".join(lines) + "\n```\n"


@pytest.mark.parametrize(
    ("text", "cuda", "torch"),
    [
        (
            "CUDA 10.2\n" + _block("pip install torch==1.9.1 torchvision==0.10.1")
            + "CUDA 11.1\n" + _block(f"pip install torch==1.9.1+cu111 torchvision==0.10.1+cu111 -f {STABLE}"),
            "11.1", {"torch==1.9.1+cu111", "torchvision==0.10.1+cu111"},
        ),
        (
            _block("conda install pytorch==1.10.0 torchvision==0.11.0 cudatoolkit=10.2 -c pytorch", "# or",
                   "conda install pytorch==1.10.0 torchvision==0.11.0 cudatoolkit=11.3 -c pytorch"),
            "11.3", {"torch==1.10.0", "torchvision==0.11.0"},
        ),
        (
            _block("# CPU", f"pip install torch==2.1.0+cpu torchvision==0.16.0+cpu --index-url {WHEELS}/cpu",
                   "# GPU", f"pip install torch==2.1.0 torchvision==0.16.0 --index-url {WHEELS}/cu118"),
            "11.8", {"torch==2.1.0", "torchvision==0.16.0"},
        ),
        (
            _block("pip install torch==1.8.1+cu102 \\", "  torchvision==0.9.1+cu102 \\", f"  -f {STABLE}",
                   "pip install torch==1.12.1+cu113 \\", "  torchvision==0.13.1+cu113 \\",
                   f"  --extra-index-url {WHEELS}/cu113"),
            "11.3", {"torch==1.12.1+cu113", "torchvision==0.13.1+cu113"},
        ),
        (
            _block("conda install pytorch torchvision cpuonly -c pytorch",
                   "conda install pytorch==1.12.1 torchvision==0.13.1 cudatoolkit=11.6 -c pytorch -c conda-forge"),
            "11.6", {"torch==1.12.1", "torchvision==0.13.1"},
        ),
    ],
)  # fmt: skip
def test_one_way_is_taken(tree: Tree, text: str, cuda: str, torch: set[str]) -> None:
    decision = tree(_page(text))
    assert (decision.cuda, _torch(decision)) == (cuda, torch)
    assert not any(option.endswith(("/cpu", "/cu102")) for option in decision.python.options)


@pytest.mark.parametrize("index", [f"--extra-index-url {WHEELS}/rocm5.6", f"-f {STABLE}"])
def test_an_index_whose_builds_come_last_in_the_alphabet_is_left_out(tree: Tree, index: str) -> None:
    decision = tree(_page(_block(f"pip install torch==1.9.1 torchvision==0.10.1 {index}")))
    assert decision.python.options == (f"--find-links {WHEELS}/cu111/torch_stable.html",)  # the image's own
    assert _torch(decision) == {"torch==1.9.1", "torchvision==0.10.1"}


@pytest.mark.parametrize(
    "line",
    [
        "pip install mmcv-full -f https://download.openmmlab.com/mmcv/dist/cu111/torch1.9.0/index.html",
        "pip install torch-scatter -f https://data.pyg.org/whl/torch-1.9.0+cu111.html",
    ],
)
def test_wheels_that_are_built_for_one_torch_name_it(tree: Tree, line: str) -> None:
    decision = tree(_page(_block("conda install pytorch torchvision cudatoolkit=11.1 -c pytorch", line)))
    assert decision.cuda == "11.1"
    assert _torch(decision) == {"torch==1.9.0+cu111", "torchvision"}


def test_a_torch_that_is_pinned_elsewhere_is_not_named_by_wheels(tree: Tree) -> None:
    line = "pip install torch-scatter -f https://data.pyg.org/whl/torch-1.9.0+cu111.html"
    decision = tree({**_page(_block(line)), "requirements.txt": "torch==1.10.0\n"})
    assert not any(each.key == "torch" for each in decision.python.pip_guessed)


@pytest.mark.parametrize(
    ("option", "given"),
    [("", True), (f"--extra-index-url {WHEELS}/cu116\n", False)],
    ids=["pip-would-not-find-it", "the-list-says-where"],
)
def test_the_wheels_of_a_build_that_a_list_pins_are_found(tree: Tree, option: str, given: bool) -> None:
    decision = tree({"requirements.txt": f"{option}torch==1.12.1+cu116\n", "run.py": "import torch\n"})
    assert (f"--extra-index-url {WHEELS}/cu116" in decision.python.options) is given
