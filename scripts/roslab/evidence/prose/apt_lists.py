"""Packages of Ubuntu that a page names in a list or a sentence, without a command that installs them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.prose.headings import MAX_LINE, lines_of, title_of
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_NAME = pattern(r"(?<![\w./+=:-])lib[a-z0-9][a-z0-9.+-]{1,60}-dev(?![\w/-]|[.*]\w)")
"""Headers of a library: nothing but a package of Ubuntu or Debian is called so."""
_NAMES_ALONE = pattern(r"(?:lib[a-z0-9.+-]+|[a-z0-9][a-z0-9.+-]*-dev)(?:[\s,]+[a-z0-9][a-z0-9.+-]+)*[\s,\\]*")
"""A line of a block that is no command: it begins with a package."""
_UNASKED = pattern(
    r"\b(?:optional\w*|remov\w*|purge\w*|uninstall\w*|not|without|instead|conflict\w*|fail\w*|errors?|only if|"
    r"alternativ\w*|trouble\w*|problems?|issues?|faq|docker|docs?|documentation|tests?|testing)\b|n't\b",
    re.IGNORECASE,
)
"""A title or a sentence about what need not be there."""


def read(repository: Repository) -> Prose:
    """Return what the pages at the root name, each name at its first place."""
    files = (file for file in pages(repository) if "/" not in file.path)
    return Prose(tuple(asked for file in files for asked in said(text_of(repository, file), file.path)))


def said(text: str, file: str) -> Iterator[Dependency]:
    """Yield each package of a page, once; sections for another system and optional ones are left out."""
    if "-dev" not in text:
        return
    whole = 1 if title_of(text.split("\n")) else 0
    told = set[str]()
    for line in lines_of(text):
        words = line.text
        if line.elsewhere or "-dev" not in words or len(words) > MAX_LINE or _UNASKED.search(words):
            continue
        if any(level > whole and _UNASKED.search(title) for level, title in line.titles.items()):
            continue
        if line.fenced and not _NAMES_ALONE.fullmatch(words.strip()):
            continue
        for name in dict.fromkeys(_NAME.findall(words)):
            if name not in told:
                told.add(name)
                place = line.number
                yield Dependency(namespace="apt", name=name, strength="prose", file=file, line=place, role="named")
