"""Programs of Octave that a page runs."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.decide.decision import Decision
from roslab.errors import NothingToBuildError

Tree = Callable[[dict[str, str]], Decision]
CODE = {"main.m": "pkg load statistics;\npkg('load', 'image')\ndisp(1)\n", "src/step.m": "function step()\n"}
PLOT = {"plot.py": "import matplotlib.pyplot as plt\nplt.show()\n"}


@pytest.mark.parametrize("more", [PLOT, {}])
@pytest.mark.parametrize("called", ["octave-cli --silent main.m", "octave main.m"])
def test_a_page_runs_it(tree: Tree, called: str, more: dict[str, str]) -> None:
    decision = tree({**CODE, **more, "README.md": f"# How to run\n```bash\n{called}\n```\n"})
    assert " ".join(decision.command) == called
    assert {"octave", "octave-image", "octave-statistics"} <= {*decision.apt_guessed}


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ("pkg load image statistics\n", {"octave-image", "octave-statistics"}),
        ("close all; pkg load image; pkg load signal, disp(1)\n", {"octave-image", "octave-signal"}),
        ("pkg('load', 'image'); pkg(\"load\", \"control\")\n", {"octave-image", "octave-control"}),
        ("pkg load nosuchthing\n% pkg load image\npkg load signal % image\n", {"octave-signal"}),
        ("pkg list image\nmypkg load image\n", set()),
        (f"pkg{' ' * 20_000}x\n" * 40, set()),
    ],
)
def test_what_it_loads(tree: Tree, code: str, expected: set[str]) -> None:
    with ends():
        decision = tree({"main.m": code, "README.md": "# How to run\n```bash\noctave main.m\n```\n"})
    assert {name for name in decision.apt_guessed if name.startswith("octave-")} == expected


@pytest.mark.parametrize(
    "page", ["Run `main` in MATLAB or Octave.\n", "```bash\noctave lost.m\n```\n", "```bash\nmatlab -r main.m\n```\n"]
)
def test_a_page_that_runs_nothing_of_the_tree_by_it(tree: Tree, page: str) -> None:
    with pytest.raises(NothingToBuildError):
        tree({**CODE, "README.md": f"# How to run\n{page}"})
    assert "octave" not in tree(PLOT).apt_guessed


def test_a_file_of_compiled_code_is_only_a_part(tree: Tree) -> None:
    cpp = {"CMakeLists.txt": "project(demo)\nadd_executable(demo demo.cpp)\n", "demo.cpp": "#include <vector>\n"}
    page = "```bash\nmkdir build && cd build && cmake .. && make\n./demo\n```\n# Plots\n```bash\noctave main.m\n```\n"
    assert tree({**cpp, **CODE, "README.md": page}).command == ("demo",)
