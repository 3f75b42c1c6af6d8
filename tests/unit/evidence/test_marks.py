"""Marks of Markdown in a line that shows a command are no part of it; what a shell means by such signs stays."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

FENCE = "```\n{}\n```\n"


@pytest.mark.parametrize(
    "page",
    [
        FENCE.format("python a.py --x b.json `"),
        FENCE.format("python a.py --x b.json ```"),
        FENCE.format("python a.py --x b.json \\`"),
        FENCE.format("python a.py --x **b.json**"),
        FENCE.format("**python a.py --x b.json**"),
        FENCE.format("`python a.py --x b.json`"),
        "**`python a.py --x b.json`**\n",
        "- **python a.py --x b.json**\n",
        "*python a.py --x b.json*\n",
        "`python a.py --x b.json`<br />\n",
        "1. `$ python a.py --x b.json`\n",
    ],
)
def test_marks_are_no_words(tmp_path: Path, page: str) -> None:
    assert _commands(tmp_path, page) == ["python a.py --x b.json"]


@pytest.mark.parametrize(
    "line", ["python a.py data/*", "python a.py src/**/*.txt", "python a.py a*.txt b*", "python a.py __x__ y__"]
)
def test_signs_of_the_shell_stay(tmp_path: Path, line: str) -> None:
    assert _commands(tmp_path, FENCE.format(line)) == [line]


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("Run it:<br />\n`./main`\n", ["./main"]),
        ("`cd lib ; ./install.sh ; cd ..`<br />\n`./main -v`\n", ["./install.sh", "./main -v"]),
        ("- `config.yaml`\n- `main`\n", []),
        ("The program `./main` is there.\n", []),
    ],
)
def test_a_line_that_is_code_alone_is_a_command(tmp_path: Path, page: str, found: list[str]) -> None:
    assert _commands(tmp_path, page) == found


def _commands(folder: Path, page: str) -> list[str]:
    (folder / "README.md").write_text(f"# Demo\n\n{page}", encoding="utf-8")
    (folder / "a.py").write_text("import numpy\n", encoding="utf-8")
    told = gather(Repository.open(folder)).mentions
    return [each.value for each in told if each.topic == "command"]
