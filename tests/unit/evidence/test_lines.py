"""Patterns that are tried only at the lines with a word."""

from __future__ import annotations

import re

import pytest

from roslab.evidence.lex.lines import first_line, lines_with, matches_at
from roslab.knowledge.code_limits import limits

TEXT = "first word\n\nnone\nword, and a second word\nlast: word"


def test_each_line_with_the_word_is_named_once() -> None:
    assert [TEXT[start:].partition("\n")[0] for start in lines_with(TEXT, "word")] == [
        "first word",
        "word, and a second word",
        "last: word",
    ]


def test_lines_with_several_words_are_in_order() -> None:
    assert [TEXT[start:].partition("\n")[0] for start in lines_with(TEXT, "last", "none", "word")] == [
        "first word",
        "none",
        "word, and a second word",
        "last: word",
    ]


@pytest.mark.parametrize("text", ["", "\n", "wor\nd"])
def test_no_line_has_the_word(text: str) -> None:
    assert list(lines_with(text, "word")) == []


@pytest.mark.parametrize(
    ("source", "found"),
    [("^.*and", "word, and"), ("^last", "last"), (r"^\w+ word", "first word"), ("^none", None), ("^second", None)],
)
def test_first_match_at_the_beginning_of_a_line(source: str, found: str | None) -> None:
    match = first_line(re.compile(source, re.MULTILINE), TEXT, "word")
    assert (match and match[0]) == found


def test_signs_of_one_line_match_no_line_break() -> None:
    signs = [limit for limit in limits() if limit.where in {"line", "annotation"}]
    assert signs
    for sign in signs:
        assert not re.search(r"\\s|\\n(?!\])|\\W", sign.pattern.pattern), sign.what


def test_a_match_begins_with_a_word_and_ends_before_the_next() -> None:
    each = re.compile(r"(?:pkg|package)=(\S+)")
    text = "package=a pkg=package=b a_package=c Pkg=d"
    assert [match[1] for match in matches_at(each, text, "package", "pkg")] == ["a", "package=b", "c"]
    assert [match[1] for match in matches_at(each, text, "Pkg")] == []
    anyhow = re.compile(each.pattern, re.IGNORECASE)
    assert [match[1] for match in matches_at(anyhow, text, "pkg", place_in=text.lower())] == ["package=b", "d"]
