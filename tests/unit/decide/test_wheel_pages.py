"""Pages of wheels for another torch, and repositories of what is installed in a release."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.wheel_pages import fitting_pages
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
MMCV = "--find-links https://download.openmmlab.com/mmcv/dist/{}/index.html"
PYG = "--find-links https://data.pyg.org/whl/torch-{}.html"
OWN = "--extra-index-url https://download.pytorch.org/whl/{}"


@pytest.mark.parametrize(
    ("asked", "options", "kept"),
    [
        ("torch==1.10.0+cu113", [MMCV.format("cu113/torch1.10.0"), MMCV.format("cu101/torch1.6.0")], [0]),
        ("torch==1.7.1", [MMCV.format("cu110/torch1.7.0"), OWN.format("cu110"), PYG.format("1.7.1+cu101")], [0, 1]),
        ("torch==1.12.*", [OWN.format("cu116"), PYG.format("1.12.0+cu116"), PYG.format("1.12.0+cu113")], [0, 1]),
        ("torch==1.10.0", [PYG.format("1.10.0+cu102"), PYG.format("1.10.0+cpu")], [0, 1]),
        ("torch", [MMCV.format("cu101/torch1.6.0")], [0]),
        ("numpy", [MMCV.format("cu101/torch1.6.0")], [0]),
    ],
)
def test_a_page_for_another_torch_is_left_out(asked: str, options: list[str], kept: list[int]) -> None:
    choice = fitting_pages(options, [stated(asked)])
    assert list(choice.answer) == [options[number] for number in kept]
    assert len(choice.warnings) == len(options) - len(kept)


@pytest.mark.parametrize(
    ("lines", "cloned"),
    [
        (("mmdet==2.14.0", "git+https://github.com/open-mmlab/mmdetection.git"), 0),
        (("mmdet", "git+https://github.com/open-mmlab/mmdetection.git"), 1),
        (("scipy==1.4.1", "git+https://github.com/open-mmlab/mmdetection.git"), 1),
        (("scipy==1.4.1", "git+https://github.com/open-mmlab/mmdetection3d.git"), 0),
    ],
)
def test_a_release_wins_over_the_repository_of_the_same_package(
    tree: Tree, lines: tuple[str, ...], cloned: int
) -> None:
    page = "# Install\n```\n" + "".join(f"pip install {line}\n" for line in lines) + "```\n"
    files = {"README.md": page, "setup.py": "from setuptools import setup\nsetup(name='mmdet3d')\n", "a.py": "x = 1\n"}
    assert sum(each.vcs for each in tree(files).python.pip_guessed) == cloned
