"""What a page names in one version comes before all others and limits them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.named_frameworks import Named, named_frameworks
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
WHEELS = "-f https://download.pytorch.org/whl/torch_stable.html"
CODE = {"train.py": "import torch\nimport kornia\n", "requirements.txt": "pytorch-lightning\ntimm\n"}


def _page(*lines: str) -> str:
    commands = "\n".join(lines)
    return f"# Installation\n```\nconda create -n lab python=3.8\n{commands}\npip install -r requirements.txt\n```\n"


@pytest.mark.parametrize(
    ("line", "first", "limits"),
    [
        (
            f"pip install torch==1.7.1+cu110 torchvision==0.8.2+cu110 {WHEELS}",
            ["torch==1.7.1+cu110", "torchvision==0.8.2+cu110"],
            {"torch==1.7.1+cu110", "torchvision==0.8.2+cu110"},
        ),
        ("conda install pytorch=1.7.1 cudatoolkit=11.0 -c pytorch", ["torch==1.7.1"], {"torch==1.7.1"}),
        ("pip install tensorflow-gpu==2.4.1", ["tensorflow-gpu==2.4.1"], {"tensorflow-gpu==2.4.1"}),
        ('pip install "jax[cuda]==0.3.10"', ["jax[cuda]==0.3.10"], {"jax==0.3.10"}),
    ],
)
def test_a_pinned_framework_of_a_page_is_installed_first_and_kept(
    tree: Tree, line: str, first: list[str], limits: set[str]
) -> None:
    python = tree({**CODE, "README.md": _page(line)}).python
    assert [each.written for each in python.pip] == first
    assert {each.written for each in python.bounds} - {"numpy<2", "protobuf<3.21"} == limits
    assert not {each.key for each in python.pip} & {each.key for each in python.pip_guessed}


@pytest.mark.parametrize("asked", ["torch", "torch==2.9.0", "torch==1.9.1+cu101", "scipy==1.4.1"])
def test_what_has_no_version_or_no_wheel_for_the_python_stops_nothing(asked: str) -> None:
    assert named_frameworks((stated(asked, "prose", "README.md"),), "3.8").answer == Named()


def test_the_framework_stands_before_the_requirement_files(tmp_path: Path) -> None:
    for name, text in {**CODE, "README.md": _page(f"pip install torch==1.7.1+cu110 {WHEELS}")}.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    limits = text.index("\ntorch==1.7.1+cu110\n")
    assert limits < text.index(" torch==1.7.1+cu110\n") < text.index("--requirement /tmp/manifests/requirements.txt")


def test_the_wheel_of_the_cuda_that_conda_is_asked_for_is_taken(tree: Tree) -> None:
    for line in ("pytorch=1.7", "pytorch==1.7.1"):
        files = {**CODE, "requirements.txt": "torch>=1.4\n"}
        python = tree({**files, "README.md": _page(f"conda install {line} cudatoolkit=11.0 -c pytorch")}).python
        assert "--find-links https://download.pytorch.org/whl/cu110/torch_stable.html" in python.options
