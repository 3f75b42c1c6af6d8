"""Python imports and programs."""

from __future__ import annotations

import json
from pathlib import Path

from roslab.evidence.python import imports
from roslab.repository.checkout import Repository


def tree(tmp_path: Path, files: dict[str, str]) -> Repository:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return Repository.open(tmp_path)


def test_what_comes_from_outside(tmp_path: Path) -> None:
    repository = tree(
        tmp_path,
        {
            "a.py": "import os, cv2 as cv, numpy.linalg\nfrom yaml import load\nimport mine\nfrom . import x\n",
            "pkg/mine.py": "def f():\n    import torch\n",
            "third_party/b.py": "import tensorflow\n",
            "docs/conf.py": "import sphinx_rtd_theme\n",
        },
    )
    found = [(d.name, d.strength, d.file, d.line) for d in imports.read(repository)]
    assert found == [
        ("cv2", "used", "a.py", 1),
        ("numpy", "used", "a.py", 1),
        ("yaml", "used", "a.py", 2),
        ("torch", "optional", "pkg/mine.py", 2),
    ]


def test_tkinter_is_a_package_of_its_own(tmp_path: Path) -> None:
    """The standard library has it, Debian's and Ubuntu's do not."""
    repository = tree(tmp_path, {"window.py": "import os\nimport tkinter as tk\nfrom tkinter import ttk\n"})
    assert [(d.name, d.line) for d in imports.read(repository)] == [("tkinter", 2)]


def test_notebooks_are_optional_evidence(tmp_path: Path) -> None:
    cells = {
        "cells": [{"cell_type": "code", "source": ["import pandas as pd\n", "x = 1\n", "from scipy import stats"]}]
    }
    repository = tree(tmp_path, {"a.ipynb": json.dumps(cells, indent=1)})
    assert [(d.name, d.strength) for d in imports.read(repository)] == [("pandas", "optional"), ("scipy", "optional")]


def test_programs(tmp_path: Path) -> None:
    guard = 'if __name__ == "__main__":\n    pass\n'
    repository = tree(
        tmp_path,
        {
            "train.py": "x = 1\n" + guard,
            "node.py": "import rospy\n" + guard,
            "pkg/__main__.py": "",
            "lib.py": "",
            "tests/t.py": guard,
            "setup.py": guard,
        },
    )
    found = [(s.file, s.line, s.kind) for s in imports.programs(repository)]
    assert found == [("node.py", 2, "node"), ("pkg/__main__.py", 1, "main"), ("train.py", 2, "main")]
