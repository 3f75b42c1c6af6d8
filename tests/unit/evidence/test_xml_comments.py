"""Comments of XML in files that may be broken."""

from __future__ import annotations

import pytest

from roslab.evidence.lex.xml_comments import without_xml_comments


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("<a/>", "<a/>"),
        ("<a/><!-- b\nc --><d/>", "<a/>\n<d/>"),
        ("<!-- a <!-- b --> c --><d/>", " c --><d/>"),
        ("<!--a--><!--b-->\n<c/>", "\n<c/>"),
        ("<a/><!--> b --><c/>", "<a/><c/>"),
        ("<a/><!-- b\n<c/>", "<a/><!-- b\n<c/>"),
    ],
)
def test_lines_keep_their_numbers(text: str, left: str) -> None:
    assert without_xml_comments(text) == left


def test_what_follows_keeps_its_position() -> None:
    assert without_xml_comments("a<!-- b\nc -->d", spaced=True) == "a      \n     d"
