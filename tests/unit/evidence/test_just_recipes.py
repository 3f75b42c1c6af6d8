"""A page that calls just runs the lines of its recipes."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from roslab.evidence.lex.justfile import parsed
from roslab.pipeline import plan_repository

FILE = """\
set dotenv-load
epochs := "3"
level := env_var_or_default("LEVEL", "info")
alias r := run

default:
    @just --list

# Install all
setup:
    sudo apt-get install -y libzmq3-dev
    pip install einops  # for the layers

run mode="fast" *more: setup
    @echo start
    -python3 train.py --mode {{mode}} \\
        --epochs {{ epochs }} --level {{level}} {{more}}

[windows]
open:
    start a.html

[linux]
open file="a.html":
    xdg-open {{file}}

must name:
    cat {{name}}

told: && (must "b.txt")
    just open c.html
    cat {{justfile_directory()}}/a.txt

python:
    #!/usr/bin/env python3
    print("a")

date:
    echo {{datetime("%Y")}}

around: about
    echo a
about: around
    echo b
"""
SETUP = ("sudo apt-get install -y libzmq3-dev", "pip install einops")


@pytest.mark.parametrize(
    ("call", "lines"),
    [
        ("setup", SETUP),
        ("run", (*SETUP, "echo start", "python3 train.py --mode fast --epochs 3 --level info")),
        ("r slow --a 1", (*SETUP, "echo start", "python3 train.py --mode slow --epochs 3 --level info --a 1")),
        ("open", ("xdg-open a.html",)),
        ("told", ("xdg-open c.html", "cat ./a.txt", "cat b.txt")),
        ("must", None),
        ("must a.txt", ("cat a.txt",)),
        ("setup more", None),
        ("python", None),
        ("date", None),
        ("nothing", None),
        ("around", ("echo b", "echo a")),
    ],
)
def test_what_a_recipe_runs(call: str, lines: tuple[str, ...] | None) -> None:
    name, *given = call.split()
    assert parsed(FILE).lines_of(name, given) == lines


def test_lines_for_another_shell_are_not_read() -> None:
    assert parsed(f"set shell := ['python3', '-c']\n{FILE}").lines_of("setup") is None


@pytest.mark.parametrize(
    "text",
    [
        "a" + " " * 120_000,
        "".join(f"a{n}: {' '.join(f'a{m}' for m in range(300))}\n    x\n" for n in range(300)),
        "run:\n    " + "{{ " * 40_000,
        "run:\n" + "".join(f"    {'# ' * 900}'\n" for _ in range(60)),
    ],
    ids=["blanks", "needed", "braces", "comments"],
)
def test_a_hostile_file_takes_no_long_time(text: str) -> None:
    start = time.process_time()
    found = parsed(text)
    for name in found.recipes:
        found.lines_of(name)
    assert time.process_time() - start < 2


CODE = {
    "train.py": "import numpy\nif __name__ == '__main__':\n    print('a')\n",
    "other.py": "if __name__ == '__main__':\n    print('a')\n",
    "requirements.txt": "numpy\n",
}


@pytest.mark.parametrize(
    "page",
    [
        "```\n$ just run  # trains\n```\n",
        "    just run\n",
        "Start it with `just run`.\n",
        "```\njust setup\njust run\n```\n",
    ],
    ids=["prompt", "indented", "sentence", "lines"],
)
@pytest.mark.parametrize("name", ["justfile", ".justfile"])
def test_the_image_runs_the_recipe(tmp_path: Path, page: str, name: str) -> None:
    for path, text in {**CODE, name: FILE, "README.md": f"# Usage\n\n{page}"}.items():
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    assert plan.run.command[:4] == ("python3", "train.py", "--mode", "fast")
    assert "einops" in plan.python.pip_guessed
    assert "libzmq3-dev" in (*plan.apt, *plan.apt_guessed)


def test_a_call_of_what_is_not_known_stays(tmp_path: Path) -> None:
    for path, text in {**CODE, "justfile": FILE, "README.md": "```\njust date\n```\njust run\n"}.items():
        (tmp_path / path).write_text(text)
    assert plan_repository(tmp_path).plan.python.pip_guessed == ()
