"""An environment of conda or pixi in which C++ is compiled makes it no Python project."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CPP = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(arm)\nadd_executable(arm a.cpp b.cpp)\n",
    "a.cpp": "#include <Eigen/Dense>\nint main() {}\n",
    "b.cpp": "#include <Eigen/Core>\n",
}
TOOLS = "name: a\ndependencies:\n  - cmake\n  - cxx-compiler\n  - eigen\n"
PIXI = "[workspace]\nchannels = ['conda-forge']\nplatforms = ['linux-64']\n[dependencies]\nninja = '*'\neigen = '*'\n"
PYTHON = "numpy", "scipy", "cv2", "yaml"
USED = "name: a\ndependencies:\n  - python=3.9\n  - numpy\n"


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"environment.yml": TOOLS}, "cpp"),
        ({"pixi.toml": PIXI}, "cpp"),
        ({"ci/environment.yml": USED}, "cpp"),
        ({"environment.yml": USED}, "python"),
        ({"environment.yml": TOOLS, "README.md": "```\npython run.py\n```\n", "run.py": "import numpy\n"}, "python"),
        ({"environment.yml": TOOLS, **{f"use_{name}.py": f"import {name}\n" for name in PYTHON}}, "python"),
    ],
)
def test_what_compiles_it_is_no_python(tree: Tree, files: dict[str, str], kind: str) -> None:
    assert tree({**CPP, **files}).kind == kind
