"""Packages of Ubuntu that a page names in a list or a sentence, without a command that installs them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Prose
from roslab.evidence.prose import readme
from roslab.evidence.prose.headings import MAX_LINE, fence, heading_of, section_of, title_of
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
    files = (file for file in readme.pages(repository) if "/" not in file.path)
    return Prose(tuple(asked for file in files for asked in said(readme.text_of(repository, file), file.path)))


def said(text: str, file: str) -> Iterator[Dependency]:
    """Yield each package of a page, once; sections for another system and optional ones are left out."""
    if "-dev" not in text:
        return
    lines = text.split("\n")
    title = title_of(lines)
    elsewhere, fenced, told = 0, False, set[str]()
    unasked: dict[int, bool] = {}
    for number, line in enumerate(lines, 1):
        if fence(line):
            fenced = not fenced
            continue
        heading = None if fenced else heading_of(line, lines[number] if number < len(lines) else "")
        elsewhere = section_of(heading, elsewhere) if number != title else 0
        if heading:
            unasked = {level: said for level, said in unasked.items() if level < heading[0]}
            unasked[heading[0]] = number != title and bool(_UNASKED.search(heading[1]))
        if elsewhere or any(unasked.values()) or "-dev" not in line or len(line) > MAX_LINE or _UNASKED.search(line):
            continue
        if fenced and not _NAMES_ALONE.fullmatch(line.strip()):
            continue
        for name in dict.fromkeys(_NAME.findall(line)):
            if name not in told:
                told.add(name)
                yield Dependency(namespace="apt", name=name, strength="prose", file=file, line=number, role="named")
