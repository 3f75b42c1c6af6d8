"""Addresses of repositories as anybody can clone them."""

from __future__ import annotations

import pytest

from roslab.evidence.ros.vcs import https


@pytest.mark.parametrize(
    ("url", "origin", "expected"),
    [
        ("../b.git", "git@github.com:a/x.git", "https://github.com/a/b.git"),
        ("../../c/b.git", "https://github.com/a/x.git", "https://github.com/c/b.git"),
        ("../../../../../../b.git", "https://github.com/a/x.git", "https://github.com/b.git"),
        ("../../../../b.git", "/srv/a", "/b.git"),
    ],
)
def test_an_address_is_read_from_that_of_the_checkout(url: str, origin: str, expected: str) -> None:
    assert https(url, origin) == expected
