"""Commands that a block of a page comments out are not the reader's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("block", "installed"),
    [
        ("# pip install tqdm\npip install rich", {"rich"}),
        ("  # pip install tqdm\n  pip install rich", {"rich"}),
        ("# the progress\npip install tqdm", {"tqdm"}),
        ("# pip install tqdm\n# pip install rich", {"tqdm", "rich"}),  # the prompt of root
        ("# pip install tqdm\nCollecting tqdm", {"tqdm"}),
        ("pip install rich # pip install tqdm", {"rich"}),
        ("# pip install tqdm\n```\n```\npip install rich", {"tqdm", "rich"}),
    ],
)
def test_what_a_block_comments_out_is_not_installed(tree: Tree, block: str, installed: set[str]) -> None:
    python = tree({"a.py": "import numpy\n", "README.md": f"# Install\n```bash\n{block}\n```\n"}).python
    assert {each.key for each in (*python.pip, *python.pip_guessed)} == {"numpy", *installed}


@pytest.mark.parametrize("other", ["pip install torch==1.10.1+cpu", "pip install numpy"])
def test_a_pytorch_that_a_block_comments_out_tells_no_cuda(tree: Tree, other: str) -> None:
    page = f"# Install\n```bash\n# pip install torch==1.10.1\n{other}\n```\n"
    assert tree({"a.py": "import numpy\n", "README.md": page}).base_image.startswith("ubuntu:")
