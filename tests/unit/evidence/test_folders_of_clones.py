"""Which clone of a page lies in a folder that it goes to."""

from __future__ import annotations

import pytest

from roslab.evidence.dependency import GitSource
from roslab.evidence.lex.shell import commands
from roslab.evidence.prose.checkouts import clone_at, cloned


@pytest.mark.parametrize(
    ("folder", "ref", "found"),
    [
        ("solver", None, True),
        ("Solver", None, True),
        ("solver-src", None, True),
        ("solver-2.6.2", None, False),  # another archive's: git writes no number there
        ("solver-2.6.2", "2.6.2", True),
        ("solver-2.6.2", "v2.6.2", True),
        ("solver-2.6.2", "v2.7", False),
        ("solvers", None, False),
    ],
)
def test_a_folder_with_a_number_is_that_of_an_archive(folder: str, ref: str | None, found: bool) -> None:
    git = GitSource(
        name="solver",
        url="https://github.com/lab/solver",
        ref=ref,
        strength="prose",
        file="install.sh",
        line=1,
        kind="clone",
    )
    assert clone_at(["tools", folder], [git]) == (0 if found else None)


@pytest.mark.parametrize(
    ("address", "url", "private"),
    [
        ("https://$GIT_TOKEN@github.com/some/arm.git", "https://github.com/some/arm.git", True),
        ("https://${NAME}:${TOKEN}@github.com/some/arm", "https://github.com/some/arm", True),
        ("https://<token>@github.com/some/arm.git", "https://github.com/some/arm.git", True),
        ("https://github.com/some/arm.git", "https://github.com/some/arm.git", False),
        ("https://github.com/$OWNER/arm.git", None, False),
        ("https://$HOST/some/arm.git", None, False),
        ("https://#", None, False),
    ],
)
def test_the_address_without_a_token_that_the_reader_writes(address: str, url: str | None, private: bool) -> None:
    said = f"git clone {address}"
    found = [cloned(command, "README.md", "", "", inside=False) for command in commands(said)]
    assert [(each.url, each.private) for each in found if each] == ([(url, private)] if url else [])
