"""A module of no table that a command cannot start without: pip's package of its name is tried, and it is said."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.by_own_name import MOST

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Run\n```\npython main.py\n```\n"
MAIN = "import numpy\nfrom agents import plan\n"
MODULES = '[submodule "down"]\n\tpath = down\n\turl = https://github.com/a/down.git\n'
FOLDER = "import os\nfor each in os.listdir(here):\n    __import__('.'.join([__name__, each[:-3]]))\n"
BELOW = {
    "README.md": PAGE.replace("main", "app/main"),
    "app/main.py": "from tree_of import a\n",
    "app/tree_of/a.py": "import tree_of.b\n",
    "app/tree_of/b.py": "import hashwords\n",
}


def tried(tree: Tree, files: dict[str, str]) -> list[str]:
    found = tree({"README.md": PAGE, "main.py": MAIN, "requirements.txt": "numpy\n", **files})
    return [each.written for each in found.python.pip_guessed]


@pytest.mark.parametrize(
    "files",
    [
        {"main.py": "import hashwords\n"},
        {"agents/plan.py": "import hashwords\n"},
        {"agents/__init__.py": "", "agents/plan.py": "from .a import b\n", "agents/a.py": "import hashwords.b\n"},
        {"agents/__init__.py": FOLDER, "agents/other.py": "import hashwords\n", "main.py": "from agents import *\n"},
        BELOW,
        {"__init__.py": "", "agents/plan.py": "import hashwords\n"},
    ],
)  # fmt: skip
def test_what_a_program_imports_by_its_own_modules(tree: Tree, files: dict[str, str]) -> None:
    assert tried(tree, files) == ["hashwords"]


@pytest.mark.parametrize(
    ("script", "reached"),
    [
        ("#!/bin/bash\nset -e\npython main.py --a\n", True),
        ("#!/bin/bash\nCUDA_VISIBLE_DEVICES=0 python3 -u main.py \\\n  --a b\n", True),
        ("#!/bin/bash\nexec python -m main\n", True),
        ("#!/bin/bash\npython other.py\npython main.py\n", False),  # it stops at the first one
        ("#!/bin/bash\npython -c 'import main'\n", False),
        ("#!/bin/bash\npython absent.py\n", False),
    ],
)
def test_what_a_script_of_the_default_command_starts_stops_it(tree: Tree, script: str, *, reached: bool) -> None:
    guard = "if __name__ == '__main__':\n    print()\n"
    files = {"README.md": PAGE.replace("python main.py", "bash tools/run.sh"), "tools/run.sh": script}
    files |= {"main.py": f"{MAIN}{guard}", "agents/plan.py": "import hashwords\n", "other.py": f"import numpy\n{guard}"}
    decision = tree(files)
    assert decision.command == ("bash", "tools/run.sh")
    (said,) = [each.message for each in decision.warnings if "hashwords" in each.message]
    assert ("the default command stops at this import" in said) == reached


@pytest.mark.parametrize(
    "files",
    [
        {"agents/plan.py": "try:\n    import hashwords\nexcept ImportError:\n    pass\n"},
        {"agents/plan.py": "def show():\n    import hashwords\n"},
        {"agents/other.py": "import hashwords\n"},
        {"main.py": "def show():\n    from agents import plan\n", "agents/plan.py": "import hashwords\n"},
        {"agents/plan.py": "import hashwords\n", "hashwords.py": ""},
        {"agents/plan.py": "import utils\n"},
        {"agents/plan.py": "import math_utils\n"},
        {"agents/plan.py": "import mrcnn\n"},
        {"agents/plan.py": "import yarp\n"},
        {"agents/plan.py": "import hash\n"},
        {"agents/plan.py": "import nav_msgs\n"},
        {"agents/plan.py": "import isaacgym\n"},
        {"agents/plan.py": "import hashwords\n", "requirements.txt": "hashwords2\n"},
        {"agents/plan.py": "import hashwords\n", "requirements.txt": "hashwords-sdk\n"},
        {"agents/plan.py": "import hashwords\n", ".gitmodules": MODULES},
        {"agents/plan.py": "import hashwords\n", "CMakeLists.txt": "project(hashwords)\nadd_library(a a.cpp)\n"},
        {"agents/plan.py": "import hashwords\n", "README.md": f"{PAGE}```\ngit clone https://github.com/a/hashwords\n```\n"},
    ],
)  # fmt: skip
def test_what_is_not_tried_by_its_name(tree: Tree, files: dict[str, str]) -> None:
    assert {*tried(tree, files)} <= {"numpy", "git+https://github.com/a/hashwords"}


@pytest.mark.parametrize(
    ("declared", "module", "told"),
    [
        ("torch", "torchwordsX", True),
        ("torch", "torch_words", True),
        ("brumby", "brumbywords", True),
        ("brumby", "brumby_words", False),
        ("brumby-words", "brumby", False),
        ("brumby-words", "words_brumby", False),
        ("brumby", "BrumbyWords", False),
    ],
)
def test_a_declared_package_excuses_its_name_and_what_is_parted_from_that(
    tree: Tree, declared: str, module: str, *, told: bool
) -> None:
    files = {"README.md": PAGE, "main.py": "import numpy\n", "other.py": f"import {module}\n"}
    found = tree({**files, "requirements.txt": f"numpy\n{declared}\n"})
    assert any(f"brings it: {module};" in each.message for each in found.warnings) == told


def test_a_try_is_told_where_it_is_imported(tree: Tree) -> None:
    found = tree(
        {"README.md": PAGE, "main.py": MAIN, "requirements.txt": "numpy\n", "agents/plan.py": "import hashwords\n"}
    )
    ((message, file, line),) = [(w.message, w.file, w.line) for w in found.warnings if "hashwords" in w.message]
    assert (file, line) == ("agents/plan.py", 1)
    assert "is tried" in message
    assert "the default command stops at this import" in message
    (reason,) = [each.reason for each in found.reasons if each.answer == "hashwords"]
    assert "the package of its name is tried" in reason


def test_another_program_of_the_page_stops_without_it(tree: Tree) -> None:
    page = f"{PAGE}\n# Plots\n```\npython draw.py\n```\n"
    found = tree({"README.md": page, "main.py": "import numpy\n", "draw.py": "import hashwords\n"})
    (message,) = [w.message for w in found.warnings if "hashwords" in w.message]
    assert "is tried" in message
    assert "default command" not in message


@pytest.mark.parametrize("module", ["mrcnn", "math_utils"])
def test_what_stays_missing_stops_the_default_command(tree: Tree, module: str) -> None:
    code = {"agents/other.py": "import brumby\n", "agents/plan.py": f"import {module}\n"}
    found = tree({"README.md": PAGE, "main.py": MAIN, **code})
    said = {w.file: w.message for w in found.warnings if "no table knows" in w.message}
    assert "the default command stops at this import: name the package under `pip`" in said["agents/plan.py"]
    assert "if it is needed" not in said["agents/plan.py"]
    assert said["agents/other.py"].endswith("in roslab.yaml if it is needed")


def test_of_many_modules_only_some_are_tried_and_those_that_stop_the_command_first(tree: Tree) -> None:
    others = {
        "README.md": f"{PAGE}```\npython also.py\n```\n",
        "also.py": "".join(f"import akeyword{n}s\n" for n in range(40)),
    }
    found = tried(tree, {**others, "agents/plan.py": "import zhashwords\n"})
    assert len(found) == MOST
    assert found[0] == "zhashwords"


def test_thousands_of_modules_of_no_table_cost_little(tree: Tree) -> None:
    files = {"main.py": "".join(f"import hash{n}words\n" for n in range(2000))}
    files["requirements.txt"] = "".join(f"brumby-{n}\n" for n in range(700))
    before = time.process_time()
    assert len(tried(tree, files)) == MOST
    assert time.process_time() - before < 8
