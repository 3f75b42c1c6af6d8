"""Lines that a program printed as a list of files are no commands; a rule of ten dashes is none of them."""

from __future__ import annotations

import pytest

from roslab.evidence.prose.listings import without_listings

HEAD = "Forward and otherwise.\n"


@pytest.mark.parametrize("line", ["----------", "| ---------- | ---------- |", "  ----------  "])
def test_a_rule_stays(line: str) -> None:
    assert without_listings(f"{HEAD}{line}\nNoetic\n") == f"{HEAD}{line}\nNoetic\n"


@pytest.mark.parametrize("line", ["drwxr-xr-x 2 a a 4096 May 1 src", "-rw-r--r--. 1 a a 12 May 1 run.py"])
def test_a_file_with_its_mode_goes(line: str) -> None:
    assert without_listings(f"{HEAD}{line}\nNoetic\n") == f"{HEAD}\nNoetic\n"
