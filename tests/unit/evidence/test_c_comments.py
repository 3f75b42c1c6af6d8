"""Comments of C and C++ and what only looks like one."""

from __future__ import annotations

import pytest

from roslab.evidence.lex.c_comments import without_c_comments


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("a(); // b\nc();", "a();     \nc();"),
        ("a(); /* b\n// c */ d();", "a();     \n        d();"),
        ('open("package://arm/a.urdf"); // b', 'open("package://arm/a.urdf");     '),
        ('glob("maps/*"); a();', 'glob("maps/*"); a();'),
    ],
    ids=["line", "lines", "address", "never closed"],
)
def test_the_rest_keeps_its_place(text: str, left: str) -> None:
    assert without_c_comments(text) == left
