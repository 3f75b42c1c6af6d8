"""One line that pip refuses stops the whole file, so that its packages are installed one by one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"main.py": "import six\nprint(six)\n"}


@pytest.mark.parametrize(
    ("line", "asked"),
    [("numpy=>1.2", "numpy>=1.2"), ("numpy 1.26.0", "numpy==1.26.0"), ("Pillow=-7.0.0", "Pillow==7.0.0")],
)
def test_signs_that_slipped_are_put_right(tree: Tree, line: str, asked: str) -> None:
    found = tree({**CODE, "requirements.txt": f"six\n{line}\n"})
    assert found.python.requirements == ()
    assert [each.written for each in found.python.pip_tried] == ["six", asked]
    assert [each.line for each in found.warnings if "pip would refuse this line; " in each.message] == [2]


@pytest.mark.parametrize("line", ["Requirements:", "Python 3", "sudo apt install python3-six"])
def test_a_line_that_asks_for_nothing_is_left_out_and_told(tree: Tree, line: str) -> None:
    found = tree({**CODE, "requirements.txt": f"-r base.txt\n{line}\n", "base.txt": "six\n"})
    assert found.python.requirements == ()
    assert [each.written for each in found.python.pip_tried] == ["six"]
    told = [each for each in found.warnings if "nothing tells what it asks for" in each.message]
    assert [(each.file, each.line) for each in told] == [("requirements.txt", 2)]


@pytest.mark.parametrize("line", ["numpy", "--no-color", "lib/six", "${HOME}/six", "# Requirements:", "numpy==1.0-odd"])
def test_a_file_that_pip_may_read_stays_as_it_is(tree: Tree, line: str) -> None:
    found = tree({**CODE, "requirements.txt": f"six\n{line}\n"})
    assert found.python.requirements == ("requirements.txt",)
