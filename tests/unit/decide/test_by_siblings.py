"""A framework that a line of a page leaves open, or whose version nobody can read, beside a package of one release."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = "import torch\nimport torchvision\nif __name__ == '__main__':\n    print(torch.ones(2).cuda())\n"
SLIP = "pip install torch==1.cd 13.1+cu117 torchvision==0.14.1+cu117"


@pytest.mark.parametrize(
    ("line", "torch"),
    [
        (SLIP, "torch==1.13.1+cu117"),
        ("pip install torch torchvision==0.11.2", "torch==1.10.1"),
        ("pip install torch torchvision==0.8.0 torchaudio==0.7.0+cu110", "torch==1.7.0+cu110"),
        ("pip install torch torchvision==0.25.0", "torch==2.10.0"),
        ("pip install torch torchaudio==2.5.1", "torch==2.5.1"),
        ("pip install torch>=1.9 torchvision==0.11.2", "torch>=1.9"),
        ("pip install torch torchvision==0.11.9", "torch"),
        ("pip install torch==1.cd", "torch"),
        ("pip install torch\npip install torchvision==0.11.2", "torch"),
    ],
)
def test_the_release_that_the_sibling_was_made_with(tree: Tree, line: str, torch: str) -> None:
    decision = tree({"README.md": f"# Install\n```\n{line}\npython train.py\n```\n", "train.py": CODE})
    assert [each.written for each in decision.pip if each.key == "torch"] == [torch]


@pytest.mark.parametrize(
    ("asked", "written"),
    [
        ("scipy==1.x.2", "scipy"),
        ("'scipy[all]>=one'", "scipy[all]"),
        ("scipy==1.2", "scipy==1.2"),
        ("scipy==1.2.*", "scipy==1.2.*"),
    ],
)
def test_a_version_that_no_release_can_have_is_left_out(tree: Tree, asked: str, written: str) -> None:
    decision = tree(
        {"README.md": f"# Install\n```\npip install {asked}\n```\n", "run.py": "import scipy\nscipy.test()\n"}
    )
    assert [each.written for each in decision.pip if each.key == "scipy"] == [written]
