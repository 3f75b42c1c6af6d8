"""A page that calls just runs the lines of its recipes."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.lex import justfile
from roslab.evidence.lex.justfile import Justfile, parsed
from roslab.evidence.prose.called_tasks import MAX_ADDED, with_tasks
from roslab.pipeline import plan_repository
from roslab.repository.checkout import Repository

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


def pages_of(folder: Path, just: str, pages: dict[str, str]) -> list[str]:
    for path, text in {"justfile": just, **pages}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    repository = Repository.open(folder)
    return [with_tasks(text, repository, repository.named(Path(path).name)[0]) for path, text in pages.items()]


def test_a_page_does_not_grow_without_end(tmp_path: Path) -> None:
    long = "".join(f"    echo {'x' * 1_900}\n" for _ in range(29))
    page = "just long\n" * 1_000 + "just short\n"
    (grown,) = pages_of(tmp_path, f"long:\n{long}short:\n    ls\n", {"README.md": f"```\n{page}```\n"})
    assert len(grown) <= len(page) + MAX_ADDED + len("```\n```\n")
    assert grown.startswith("```\necho xxx")
    assert grown.count("just long\n") == 999
    assert grown.endswith("\nls\n```\n")


def test_each_call_is_looked_up_once_for_all_pages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[str, list[str]]] = []
    lines_of = Justfile.lines_of

    def counted(self: Justfile, name: str, given: Sequence[str] = ()) -> tuple[str, ...] | None:
        asked.append((name, [*given]))
        return lines_of(self, name, given)

    monkeypatch.setattr(Justfile, "lines_of", counted)
    page = "```\njust a\njust a\njust b c\njust gone\n```\n"
    found = pages_of(tmp_path, "a:\n    ls\nb x:\n    cat {{x}}\n", {f"docs/p{each}.md": page for each in range(5)})
    assert found == ["```\nls\nls\ncat c\njust gone\n```\n"] * 5
    assert asked == [("a", []), ("b", ["c"]), ("gone", [])]


def test_values_do_not_multiply() -> None:
    """Each recipe has the argument a hundred times, and gives that to the next."""
    recipes = "".join(f"r{each} *x:\n    just r{each + 1} {'{{x}} ' * 100}\n" for each in range(10))
    with ends():
        assert parsed(f"{recipes}r10 *x:\n    echo {{{{x}}}}\n").lines_of("r0", ["a" * 19]) is None
    assert parsed("a *x:\n    just b {{x}} {{x}}\nb *x:\n    echo {{x}}\n").lines_of("a", ["c"]) == ("echo c c",)


def test_thousands_of_lines_are_not_filled(monkeypatch: pytest.MonkeyPatch) -> None:
    filled: list[str] = []
    kept = justfile._filled

    def counted(line: str, values: Mapping[str, str]) -> str | None:
        filled.append(line)
        return kept(line, values)

    monkeypatch.setattr(justfile, "_filled", counted)
    assert parsed("a:\n" + "    echo a\n" * 2_000).lines_of("a") is None
    assert len(filled) <= justfile.MOST + 1
