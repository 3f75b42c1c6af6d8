"""The table of compilers that are newer than an Ubuntu's own."""

from __future__ import annotations

import pytest

from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.newer_compilers import newer_compiler, repository_of
from roslab.knowledge.table import rows

PPA = "ppa:ubuntu-toolchain-r/test"


@pytest.mark.parametrize(
    ("ubuntu", "at_least", "found", "repository"),
    [
        ("xenial", "8", "9", PPA),
        ("bionic", "8", "8", ""),
        ("bionic", "10", "11", PPA),
        ("noble", "15", None, None),
        ("resolute", "9", None, None),
    ],
)
def test_the_oldest_that_is_new_enough(ubuntu: str, at_least: str, found: str | None, repository: str | None) -> None:
    assert newer_compiler(ubuntu, at_least) == found
    assert repository_of(ubuntu, found or at_least) == repository


def test_each_row_is_of_an_ubuntu_and_alone() -> None:
    table = rows("newer_compilers")
    assert {row["ubuntu"] for row in table} <= set(python_of_ubuntu())
    assert len({(row["ubuntu"], row["gcc"]) for row in table}) == len(table)
    assert {row["repository"] for row in table} == {"", PPA}
