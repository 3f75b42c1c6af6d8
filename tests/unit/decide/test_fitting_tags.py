"""What pip takes from git beside an older framework is of the last tag that was made for that one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.fitting_tags import fitting_tags
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
ADDRESS = "git+https://github.com/facebookresearch/pytorch3d"


@pytest.mark.parametrize(
    ("asked", "held", "day", "tag"),
    [
        (f"pytorch3d @ {ADDRESS}", "torch==1.10.0+cu113", None, "@v0.7.4"),
        (f"pytorch3d @ {ADDRESS}", "torch==1.11.0", None, "@v0.7.4"),
        (f"pytorch3d @ {ADDRESS}", "torch==1.13.1", "2024-08-28", "@v0.7.6"),
        (f"pytorch3d @ {ADDRESS}", "torch==1.13.1", "2023-01-01", ""),  # what the repository was then
        (f"pytorch3d @ {ADDRESS}", "torch==2.4.1", None, ""),
        (f"pytorch3d @ {ADDRESS}", "torch==1.0.1", None, ""),
        (f"pytorch3d @ {ADDRESS}", "torch", None, ""),
        (f"pytorch3d @ {ADDRESS}", "numpy==1.10.0", None, ""),
        (f"pytorch3d @ {ADDRESS}.git", "torch==1.10.0", None, ""),  # its author says so
        (f"pytorch3d @ {ADDRESS}@v0.6.2", "torch==1.10.0", None, ""),
        ("pytorch3d==0.3.0", "torch==1.10.0", None, ""),
    ],
)
def test_the_last_tag_for_a_framework(asked: str, held: str, day: str | None, tag: str) -> None:
    (found,) = fitting_tags([stated(asked)], [stated(held)], day)
    assert found.written == f"{asked}{tag}"
    assert not tag or found.url == f"{ADDRESS}{tag}"


@pytest.mark.parametrize("listed", [True, False])
def test_it_is_installed_so(tree: Tree, *, listed: bool) -> None:
    lines = "torch==1.12.1\npytorch3d\n" if listed else "torch==1.12.1\n"
    code = "import torch\nfrom pytorch3d.transforms import so3_log_map\n"
    python = tree({"requirements.txt": lines, "main.py": code}).python
    asked = [each.written for each in (*python.pip, *python.pip_guessed) if each.key == "pytorch3d"]
    assert asked == [f"pytorch3d @ {ADDRESS}@v0.7.6"]
