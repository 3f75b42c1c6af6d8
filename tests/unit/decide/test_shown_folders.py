"""A folder of examples that a page names, where the page starts nothing."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose import shown_folders
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
SETUP = "from setuptools import setup\nsetup(name='arm', packages=['arm'], install_requires=['numpy'])\n"
ARM = {"arm/__init__.py": "", "setup.py": SETUP}
MOVES = "import arm\narm.move()\n"
SEE = "# Arm\nSee `examples/` for how to use it.\n"
GUARDED = "import argparse\nif __name__ == '__main__':\n    parser = argparse.ArgumentParser()\n    {}\n"


@pytest.mark.parametrize(
    "said",
    [
        "See `examples/` for how to use it.",
        "Look at the files in examples/.",
        "The examples folder shows more.",
        "The directory `examples` shows more.",
        "Have a look at the [examples](examples).",
        "Some [examples](./examples/) are there.",
        "There are [some](https://github.com/demo/arm/tree/main/examples/).",
        "Look into our `example/` directory.",
    ],
)
def test_the_only_program_of_a_folder_that_a_page_names(tree: Tree, said: str) -> None:
    decision = tree({**ARM, "README.md": f"# Arm\n{said}\n", "examples/reach.py": MOVES})
    assert decision.command == ("python3", "examples/reach.py")


@pytest.mark.parametrize(
    "page",
    [
        "# Arm\n```\nexamples/\n  reach.py\n```\n",  # a drawn tree
        "# Arm\nA library with many examples.\n",
        "# Arm\n## Windows\nSee `examples/`.\n",
        "# Arm\nSee `demos/`.\n",
    ],
)
def test_what_names_no_folder_of_the_tree(tree: Tree, page: str) -> None:
    assert tree({**ARM, "README.md": page, "examples/reach.py": MOVES}).command == ("bash",)


@pytest.mark.parametrize(
    ("files", "page", "command"),
    [
        ({"examples/10_last.py": MOVES, "examples/2_first.py": MOVES}, SEE, "examples/2_first.py"),
        ({"examples/a.py": MOVES, "examples/b.py": MOVES}, f"{SEE}- b.py: reaches\n- a.py: waits\n", "examples/b.py"),
        ({"examples/a.py": "import sys\nprint(sys.argv[1])\n", "examples/b.py": MOVES}, SEE, "examples/b.py"),
        (
            {"examples/a.py": GUARDED.format("parser.add_argument('bag')"), "examples/b.py": MOVES},
            SEE,
            "examples/b.py",
        ),
        (
            {"examples/a.py": GUARDED.format("parser.add_argument('--bag', required=True)"), "examples/b.py": MOVES},
            SEE,
            "examples/b.py",
        ),
        ({"examples/a.py": "import numpy\nnumpy.load('log.npy')\n", "examples/b.py": MOVES}, SEE, "examples/b.py"),
        ({"examples/a.py": "open('out.txt', 'w').write('1')\n", "examples/b.py": MOVES}, SEE, "examples/a.py"),
        ({"examples/a.py": "print(input('Which? '))\n", "examples/b.py": MOVES}, SEE, "examples/b.py"),
        ({"examples/a.py": "def a():\n    pass\n", "examples/b.py": MOVES}, SEE, "examples/b.py"),
        ({"examples/convert_logs.py": MOVES, "examples/reach.py": MOVES}, SEE, "examples/reach.py"),
        ({"examples/reach_test.py": MOVES, "examples/wait.py": MOVES}, SEE, "examples/wait.py"),
        ({"examples/reach/main.py": MOVES}, SEE, "examples/reach/main.py"),
        ({"arm/demos/reach.py": MOVES}, "# Arm\nSee `arm/demos/`.\n", "arm/demos/reach.py"),
    ],
)
def test_the_first_that_can_be_started_as_it_is(tree: Tree, files: dict[str, str], page: str, command: str) -> None:
    decision = tree({**ARM, **files, "README.md": page})
    assert decision.command == ("python3", command)
    assert {("python3", path) for path in files if "def a" not in files[path]} <= {*decision.command_candidates}


def test_none_can_be_started_as_it_is(tree: Tree) -> None:
    decision = tree({**ARM, "README.md": SEE, "examples/a.py": "import sys\nprint(sys.argv[1])\n"})
    assert decision.command == ("bash",)
    assert decision.command_candidates == (("python3", "examples/a.py"),)


@pytest.mark.parametrize(
    ("lies", "command"), [("arm.urdf", "cd examples && exec python3 a.py"), ("leg.urdf", ("bash",))]
)
def test_what_lies_above_is_found_from_its_own_folder(tree: Tree, lies: str, command: object) -> None:
    files = {"README.md": SEE, "examples/a.py": "import arm\narm.read('../data/arm.urdf')\n"}
    assert tree({**ARM, **files, f"data/{lies}": "<robot/>"}).command == command


@pytest.mark.parametrize(
    ("page", "more", "command"),
    [
        (f"{SEE}## Usage\n```\npython train.py\n```\n", {"train.py": MOVES}, ("python", "train.py")),
        (SEE, {"examples/README.md": "```\npython wait.py\n```\n"}, ("python", "examples/wait.py")),
    ],
)
def test_what_a_page_runs_comes_first(tree: Tree, page: str, more: dict[str, str], command: tuple[str, ...]) -> None:
    files = {**ARM, "README.md": page, "examples/reach.py": MOVES, "examples/wait.py": MOVES, **more}
    assert tree(files).command == command


def test_notebooks(tree: Tree) -> None:
    notebook = '{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}'
    files = {"notebooks/1_reach.ipynb": notebook, "notebooks/2_wait.ipynb": notebook}
    decision = tree({**ARM, **files, "README.md": "# Arm\nSee the `notebooks` folder.\n"})
    assert decision.command[-1] == "notebooks/1_reach.ipynb"
    assert decision.command[0] == "jupyter"


def test_an_example_finds_what_lies_at_the_root(tree: Tree) -> None:
    files = {"README.md": SEE, "requirements.txt": "numpy\n", "leg.py": "", "examples/a.py": "import leg\nleg.move()\n"}
    decision = tree(files)
    assert decision.command == ("python3", "examples/a.py")
    assert decision.python_path == (".",)


def test_a_folder_without_programs_is_looked_into_once(tmp_path: Path) -> None:
    files = {f"examples/_{number}.py": "" for number in range(300)}
    repository = tree_of(tmp_path, {**files, "README.md": "# Arm\n" + "See examples/.\n" * 16_000})
    start = time.process_time()
    assert not shown_folders.read(repository)
    assert time.process_time() - start < 2
