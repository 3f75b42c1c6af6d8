"""A page takes torch from the index of one CUDA: the image has pip's own index, too, with newer ones for others."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
INDEX = "https://download.pytorch.org/whl/"
MAIN = "import torch\ntorch.zeros(1).cuda()\nif __name__ == '__main__':\n    pass\n"
PROJECT = """[project]
name = "main"
version = "1"
requires-python = ">=3.10,<3.11"
dependencies = ["torch"]
[build-system]
requires = ["setuptools"]
build-backend = "setuptools.build_meta"
"""
LOCK = f"""[[package]]
name = "torch"
version = "2.8.0"
source = {{ registry = "{INDEX.replace("download.pytorch", "index.example")}" }}
wheels = [
    {{ url = "https://index.example/torch-2.8.0-cp310-cp310-manylinux_2_28_x86_64.whl", hash = "sha256:00" }},
]
"""


def limits(found: Decision) -> set[str]:
    return {each.written for each in found.python.bounds if each.key == "torch"}


@pytest.mark.parametrize(
    ("line", "limit"),
    [
        ("torch torchvision --index-url {}cu118", {"torch==2.7.*"}),
        ("torch --index-url {}cu121", {"torch==2.5.*"}),
        ("'torch>=2.0' --index-url {}cu118", {"torch==2.7.*"}),
        ("torch --index-url {}cu130", set()),  # the newest one for Python 3.10 is built for it, too
        ("torch --index-url {}cu128", {"torch==2.11.*"}),
        ("torch --index-url {}cpu", set()),
        ("torch==2.1.0 --index-url {}cu118", {"torch==2.1.0"}),
        ("torch --extra-index-url {}cu118", set()),  # pip takes the newest of both there, too
    ],
)
def test_torch_is_no_newer_than_that_index(tree: Tree, line: str, limit: set[str]) -> None:
    page = f"# Net\n```\npip install {line.format(INDEX)}\npython main.py\n```\n"
    assert limits(tree({"main.py": MAIN, "README.md": page})) == limit


@pytest.mark.parametrize(
    ("page", "index", "cuda"),
    [
        ("docs/install.md", "cu118", "12.8"),
        ("docs/install.md", "cu126", "12.6"),  # it has a build of the lock's torch
        ("README.md", "cu118", "11.8"),
    ],
)
def test_an_index_without_the_torch_of_the_lock_is_of_another_time(
    tree: Tree, page: str, index: str, cuda: str
) -> None:
    text = f"# Net\n## GPU\n```\npip install torch --index-url {INDEX}{index}\n```\n"
    files = {"pyproject.toml": PROJECT, "uv.lock": LOCK, "main.py": MAIN, "README.md": "# Net\nRuns on CUDA GPUs.\n"}
    found = tree({**files, page: text})
    assert found.cuda == cuda
    assert any(index in option for option in found.python.options) == (cuda != "12.8")
