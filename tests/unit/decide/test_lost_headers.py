"""An extension that includes a header which nothing brings stops the image only where the command needs it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import Extension, find_packages, setup\n"
    "setup(name='plan', packages=find_packages(), install_requires=['numpy'],\n"
    "      ext_modules=[Extension('plan._fast', ['src/fast.cpp'])])\n"
)
FILES = {
    "setup.py": SETUP,
    "src/fast.cpp": "#include <Python.h>\n#include <labplanner/planner.h>\nint f() { return 1; }\n",
    "plan/__init__.py": "from plan.core import go\n",
    "plan/core.py": "def go():\n    print(1)\n",
    "main.py": "from plan import go\n\nif __name__ == '__main__':\n    go()\n",
    "README.md": "# Plan\n```\npip install -e .\npython main.py\n```\n",
}
NEEDED = "from ._fast import f\n\n\ndef go():\n    print(f())\n"


def lost(decision: Decision) -> list[tuple[str, list[str]]]:
    return [(folder, [each.written for each in asked]) for folder, asked in decision.python.lost_extensions]


def said(decision: Decision) -> list[tuple[str, int, str]]:
    told = (each for each in decision.warnings if "the extension of plan includes" in each.message)
    return [(each.file or "", each.line or 0, each.message) for each in told]


def test_the_pure_part_is_kept_where_the_command_does_not_import_it(tree: Tree) -> None:
    decision = tree(FILES)
    assert lost(decision) == [(".", ["numpy"])]
    ((file, line, message),) = said(decision)
    assert (file, line) == ("src/fast.cpp", 2)
    assert "labplanner/planner.h, and nothing is known that brings it: where pip stops there" in message


@pytest.mark.parametrize("how", [NEEDED, "from plan._fast import f\n", "from . import _fast\n", "import plan._fast\n"])
def test_the_build_stops_where_the_command_imports_it(tree: Tree, how: str) -> None:
    decision = tree({**FILES, "plan/core.py": f"{how}\n\ndef go():\n    pass\n"})
    assert lost(decision) == []
    ((file, line, message),) = said(decision)
    assert (file, line) == ("src/fast.cpp", 2)
    assert "the build will stop there, for the command imports plan._fast of it (plan/core.py:1)" in message


@pytest.mark.parametrize(
    "files",
    [
        {"src/labplanner/planner.h": "int g();\n"},
        {"src/fast.cpp": "#ifdef WITH_PLANNER\n#include <labplanner/planner.h>\n#endif\n"},
        {"src/fast.cpp": "#include <ATen/ATen.h>\n#include <numpy/arrayobject.h>\n"},  # wheels bring them
        {"src/fast.cpp": "#include <Eigen/Dense>\n"},
        {"src/fast.cpp": "int f();\n", "src/other.cpp": "#include <labplanner/planner.h>\n"},  # not compiled
        {"setup.py": SETUP + "# cloned: https://github.com/lab/labplanner\n"},
        {"README.md": "# Plan\n```\nsudo apt install liblabplanner-dev\npip install -e .\npython main.py\n```\n"},
        {".gitmodules": '[submodule "m"]\n\tpath = m\n\turl = https://github.com/lab/m\n'},
    ],
)
def test_what_is_known_or_may_be_there_is_not_told(tree: Tree, files: dict[str, str]) -> None:
    decision = tree({**FILES, **files})
    assert (lost(decision), said(decision)) == ([], [])


def test_what_roslab_yaml_installs_is_not_told(tmp_path: Path) -> None:
    decision = decided(tmp_path, FILES, config=Config(apt=("liblabplanner-dev",)))
    assert (lost(decision), said(decision)) == ([], [])
