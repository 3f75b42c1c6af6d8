"""Plain lists of system packages, a name or more a line, and the lines that give such a file to apt."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence.lex.shell import logical_lines
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.merged import Prose
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
_NAME = pattern(r"[a-z0-9][a-z0-9+.-]+")
_APT = pattern(r"\bapt(?:-get)?\b[^\n]*\binstall\b")
_GIVEN = pattern(r"\bxargs\b|\$\(|`")
"""What makes words of a file: ``xargs apt install < FILE``, ``apt install $(cat FILE)``."""
_PART = pattern(r"&&|\|\||;|\n(?!\s*[|<])")
_PATH = pattern(r"(?:[\w.~${}-]*/)*[\w-][\w.-]*\.\w+")


def listed(text: str, path: str) -> Prose:
    """Return the packages of a list; none where a line is anything else than names and a comment."""
    lines = [line.split("#")[0].split() for line in text.split("\n")]
    if not all(_NAME.fullmatch(word.replace("=", "-")) for words in lines for word in words):
        return Prose()
    collector = Collector(path, "script")
    for number, words in enumerate(lines, 1):
        if words:
            collector.logical(f"apt-get install {' '.join(words)}", number)
    return collector.prose()


def given_to_apt(repository: Repository, text: str, by: File) -> Iterator[File]:
    """Yield the files of the tree whose names a text gives to apt; ``by`` is the file with the text."""
    if not (_GIVEN.search(text) and _APT.search(text)):
        return
    for _, logical in logical_lines(text):
        for part in _PART.split(logical):
            if _GIVEN.search(part) and _APT.search(part):
                yield from (file for word in _PATH.findall(part) if (file := _meant(repository, word, by)))


def _meant(repository: Repository, word: str, by: File) -> File | None:
    """Return the file that a path means, which may be one of the image: that with most of its parts, near ``by``."""
    found = [file for file in repository.named(posixpath.basename(word)) if file.size < MAX_SIZE]
    below = [file for file in found if file.path.startswith(f"{by.folder}/")] if by.folder else []
    ranked = sorted(below or found, key=lambda file: _alike(file.path, word), reverse=True)
    if len(ranked) > 1 and _alike(ranked[0].path, word) == _alike(ranked[1].path, word):
        return None
    return next(iter(ranked), None)


def _alike(path: str, word: str) -> int:
    """Return how many parts two paths have in common at their ends."""
    pairs = [one == other for one, other in zip(path.split("/")[::-1], word.split("/")[::-1], strict=False)]
    return pairs.index(False) if False in pairs else len(pairs)
