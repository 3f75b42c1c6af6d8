"""Python imports and programs."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from roslab.evidence.gather import gather
from roslab.evidence.python import imports
from roslab.evidence.python import modules as python_modules
from roslab.evidence.python.programs import read as programs
from roslab.evidence.python.statements import statements
from roslab.knowledge.table import rows
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


@pytest.mark.parametrize(
    ("statement", "outside"),
    [
        ("from datasets.indoor.loader import Loader", []),
        ("import datasets.indoor.loader as loader", []),
        ("from datasets.outdoor import Loader", []),  # a package of its own
        ("from datasets import load_dataset", ["datasets"]),
        ("from datasets.indoor.other import Loader", ["datasets"]),
    ],
)
@pytest.mark.parametrize("above", ["", "src/"])
def test_a_folder_that_is_called_like_a_package(statement: str, outside: list[str], above: str, tmp_path: Path) -> None:
    """It has no module of its own: only what its folders have is known not to be the package's."""
    files = {f"{above}datasets/indoor/loader.py": "", f"{above}datasets/outdoor/__init__.py": ""}
    repository = tree(tmp_path, {**files, f"{above}train/run.py": f"{statement}\n"})
    assert [d.name for d in imports.read(repository)] == outside


@pytest.mark.parametrize("name", ["tkinter", "Tkinter"])
def test_tkinter_is_a_package_of_its_own(name: str, tmp_path: Path) -> None:
    """The standard library has it, of Python 2 by its older name; Debian's and Ubuntu's do not."""
    repository = tree(tmp_path, {"window.py": f"import os\nimport {name} as tk\nfrom {name} import ttk\n"})
    assert [(d.name, d.line) for d in imports.read(repository)] == [(name, 2)]


def test_notebooks_are_optional_evidence(tmp_path: Path) -> None:
    cells = {
        "cells": [{"cell_type": "code", "source": ["import pandas as pd\n", "x = 1\n", "from scipy import stats"]}]
    }
    repository = tree(tmp_path, {"a.ipynb": json.dumps(cells, indent=1)})
    assert [(d.name, d.strength) for d in imports.read(repository)] == [("pandas", "optional"), ("scipy", "optional")]


@pytest.mark.parametrize(
    "cells",
    [
        {"cells": [{"cell_type": "code", "source": "x = 1\nimport numpy, pandas\nif x:\n    import scipy"}]},
        {"worksheets": [{"cells": [{"cell_type": "code", "input": ["import numpy, pandas\n", "  import scipy"]}]}]},
        {
            "cells": [
                {"cell_type": "markdown", "source": ["import torch"]},
                {"cell_type": "code", "source": ["import numpy, pandas"], "outputs": [{"text": ["import jax"]}]},
                {"cell_type": "code"},
                None,
            ],
            "metadata": {"language_info": {"name": "Python"}, "kernelspec": []},
        },
    ],
)
def test_only_what_stands_in_code_counts(cells: object, tmp_path: Path) -> None:
    repository = tree(tmp_path, {"a.ipynb": json.dumps(cells, indent=1)})
    assert [d.name for d in imports.read(repository)] == ["numpy", "pandas"]


def test_the_line_of_a_notebooks_file_is_named(tmp_path: Path) -> None:
    text = json.dumps({"cells": [{"cell_type": "code", "source": ["x = 1\n", "import numpy\n"]}]}, indent=1)
    repository = tree(tmp_path, {"a.ipynb": text})
    (found,) = imports.read(repository)
    assert "import numpy" in text.split("\n")[found.line - 1]


@pytest.mark.parametrize(
    "text",
    [
        '{"cells": [{"cell_type": "code", "source": ["import numpy"]}',
        "[" * 100_000,
        '["import numpy"]',
        '{"cells": [{"cell_type": "code", "source": ["import numpy"]}], "metadata": {"kernelspec": {"language": "R"}}}',
    ],
    ids=["cut", "deep", "list", "r"],
)
def test_what_is_no_notebook_of_python_says_nothing(text: str, tmp_path: Path) -> None:
    assert imports.read(tree(tmp_path, {"a.ipynb": text})) == ()


@pytest.mark.parametrize("row", rows("imports"), ids=lambda row: row["module"])
def test_every_module_of_the_table_is_read(row: dict[str, str], tmp_path: Path) -> None:
    repository = tree(tmp_path, {"src/a.py": f"import os, {row['module']}\n"})
    assert [d.name for d in imports.read(repository)] == [row["module"].partition(".")[0]]


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
    found = [(s.file, s.line, s.kind) for s in programs(repository)]
    assert found == [("node.py", 2, "node"), ("pkg/__main__.py", 1, "main"), ("train.py", 2, "main")]


@pytest.mark.parametrize(
    ("more", "outside"),
    [
        ({}, ["pygame"]),
        ({"demo/envs/play.py": 'if __name__ == "__main__":\n    print(1)\n'}, []),  # its folder is on the path
    ],
)
def test_a_package_inside_another_that_is_called_like_a_known_one(
    more: dict[str, str], outside: list[str], tmp_path: Path
) -> None:
    files = dict.fromkeys(("demo/__init__.py", "demo/envs/__init__.py", "demo/envs/pygame/__init__.py"), "")
    repository = tree(tmp_path, {**files, **more, "demo/envs/pygame/walls.py": "from pygame import Color\n"})
    assert [d.name for d in imports.read(repository)] == outside


def test_what_a_newer_python_dropped_is_pythons_own_whichever_python_makes_the_plan(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "main.py").write_text("import telnetlib\nimport Queue\nimport pipes\nimport tomllib\nimport scipy\n")
    newer = {"telnetlib", "pipes"}  # as Python 3.13 has them no more
    monkeypatch.setattr("sys.stdlib_module_names", frozenset(sys.stdlib_module_names) - newer)
    imports._standard.cache_clear()
    try:
        assert [each.name for each in imports.read(Repository.open(tmp_path))] == ["scipy"]
    finally:
        imports._standard.cache_clear()


EXTENSION = "from setuptools import setup\nsetup(ext_modules=[CUDAExtension('fast_ops', sources=['a.cu'])])\n"


@pytest.mark.parametrize(
    ("files", "outside"),
    [
        ({"setup.py": EXTENSION}, []),
        ({"setup.py": EXTENSION.replace("'fast_ops'", "name='fast_ops._C'")}, []),
        ({"setup.py": "setup()\n"}, ["fast_ops"]),
    ],
)
def test_what_the_tree_compiles_is_its_own(tmp_path: Path, files: dict[str, str], outside: list[str]) -> None:
    repository = tree(tmp_path, {"main.py": "import fast_ops\n", **files})
    assert [d.name for d in imports.read(repository) if d.file == "main.py"] == outside


def test_copied_code_of_a_known_package_may_not_be_compiled(tmp_path: Path) -> None:
    files = {"main.py": "import open3d\n", "third_party/a/setup.py": EXTENSION.replace("fast_ops", "open3d")}
    assert [d.name for d in imports.read(tree(tmp_path, files))] == ["open3d"]


def test_the_imports_of_a_module_are_looked_for_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def counted(text: str) -> object:
        asked.append(text)
        return statements(text)

    monkeypatch.setattr(python_modules, "statements", counted)
    guard = "if __name__ == '__main__':\n    pass\n"
    files = {
        f"{name}.py": f"import {other}\nimport cv2, odd_{name}\n{guard}" for name, other in (("a", "b"), ("b", "a"))
    }
    gather(tree(tmp_path, {**files, "README.md": "```bash\npython a.py\n```\n"}))
    assert sorted(asked) == sorted(files.values())


_EXITS = "try:\n    import flask\nexcept ImportError:\n    print('flask is required')\n    exit(1)\n"


@pytest.mark.parametrize(
    ("text", "strength"),
    [
        (_EXITS, "used"),
        (_EXITS.replace("exit(1)", "sys.exit(1)"), "used"),
        (_EXITS.replace("except ImportError", "except"), "used"),
        (_EXITS.replace("except ImportError", "except (ImportError, KeyError) as error"), "used"),
        (_EXITS.replace("print('flask is required')\n    exit(1)", "raise RuntimeError('no flask')"), "used"),
        (_EXITS.replace(":\n    print('flask is required')\n    exit(1)", ": raise RuntimeError('no flask')"), "used"),
        (_EXITS.replace("print('flask is required')", "print 'of Python 2'"), "used"),
        ("x = 1\n# first\ntry:  # last\n\n    # here\n    import flask\nexcept ImportError:\n    quit()\n", "used"),
        ("try:\n    import flask\nexcept KeyError:\n    pass\nexcept ImportError:\n    exit()\n", "used"),
        (_EXITS.replace("exit(1)", "flask = None"), "optional"),
        (_EXITS.replace("exit(1)", "if strict:\n        exit(1)"), "optional"),  # only under a condition
        (_EXITS.replace("    print", "    import bottle as flask\n    print"), "optional"),  # it has another way
        (_EXITS.replace("ImportError", "KeyError"), "optional"),
        (_EXITS + "except Exception:\n    pass\n", "optional"),
        ("try:\n    if web:\n        import flask\nexcept ImportError:\n    exit(1)\n", "optional"),
        ("try:\n    import flask\nfinally:\n    exit(1)\n", "optional"),
        ("def start():\n    try:\n        import flask\n    except ImportError:\n        exit(1)\n", "optional"),
        ("try:\n    import flask", "optional"),
    ],
)
def test_a_try_that_stops_where_it_fails(text: str, strength: str, tmp_path: Path) -> None:
    """``import flask`` under ``try`` is no option where the program ends without it."""
    found = {each.name: each.strength for each in imports.read(tree(tmp_path, {"gui.py": text}))}
    assert found["flask"] == strength
