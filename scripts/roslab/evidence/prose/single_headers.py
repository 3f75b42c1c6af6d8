"""Libraries of one header that a page fetches by its address and puts where every compiler looks."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN
from roslab.evidence.prose.downloads import BELOW, INTO, option
from roslab.values.pattern import pattern

_HEADER = pattern(r"[\w][\w.+-]*\.(?:h|hh|hpp|hxx|cuh)")
_URL = pattern(r"https?://[^\s\"'<>?#,]+/([^\s\"'<>/?#,]+)")
_FOLDER = pattern(r"/usr/(?:local/)?include(?:/[\w.+-]+)*")
"""Where the compilers of Ubuntu look without being told: https://gcc.gnu.org/onlinedocs/cpp/Search-Path.html"""
_MOVES = frozenset({"mv", "cp", "install"})


def called(words: tuple[str, ...]) -> Iterator[str]:
    """Yield ``fetched URL PATH`` for a header that wget or curl fetches, ``moved NAME PATH`` for one that is put there.

    The path is the header's own name where it is fetched to somewhere else.
    """
    program = words[0].rpartition("/")[2]
    if program in INTO:
        for word in words[1:]:
            match = _URL.fullmatch(word)
            if match and _HEADER.fullmatch(match[1]) and UNKNOWN not in word:
                named = option(words, INTO[program]) or match[1]
                path = posixpath.join(option(words, BELOW[program]), named)
                yield f"fetched {word} {path if _within(path) else posixpath.basename(path)}"
    elif program in _MOVES:
        for word in words[1:-1]:
            name = posixpath.basename(word)
            last = posixpath.normpath(words[-1])
            path = last if _HEADER.fullmatch(posixpath.basename(last)) else posixpath.join(last, name)
            if _HEADER.fullmatch(name) and _within(path):
                yield f"moved {name} {path}"


def placed(mentions: tuple[Mention, ...]) -> Iterator[tuple[Mention, str, str]]:
    """Yield each header with its address and its path in the image, by what the same text says of it before."""
    fetched: dict[tuple[str, str], tuple[Mention, str]] = {}
    for mention in mentions:
        what, first, path = mention.value.split(" ", 2)
        if what == "fetched" and _within(path):
            yield mention, first, path
        elif what == "fetched":
            fetched[mention.file, path] = mention, first
        elif there := fetched.get((mention.file, first)):
            yield *there, path


def _within(path: str) -> bool:
    return bool(_FOLDER.fullmatch(posixpath.dirname(path)) and _HEADER.fullmatch(posixpath.basename(path)))
