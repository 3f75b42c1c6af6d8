"""Other branches of a repository: those that git knows of, and those that its page names in code marks.

Authors keep each version of their code on a branch of its own, and the default one holds a page alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.prose.headings import lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MOST = 20
_WORD = pattern(r"\bbranch(?:es)?\b", re.IGNORECASE)
_MARKED = pattern(r"(?<!`)`([A-Za-z0-9][\w./-]{0,60})`(?!`)")
_FILE = pattern(r"\.(?:md|py|sh|cpp|h|hpp|yaml|yml|launch|txt|xml|json|cfg)$|^(?:git|ros|cd)$")


def others(repository: Repository) -> tuple[str, ...]:
    """Return them without the one that is checked out: those of the page first, if git has them or has none."""
    own = {repository.branch, "HEAD", ""}
    there = [name for name in repository.branches if name not in own]
    said = [name for name in _said(repository) if name not in own and (name in there or not there)]
    return tuple(dict.fromkeys((*said, *there)))[:MOST]


def _said(repository: Repository) -> Iterator[str]:
    """Yield what stands in code marks on a line that speaks of branches, and below it until the next title."""
    for page in pages(repository):
        told, before = False, ""
        for line in lines_of(text_of(repository, page)) if "/" not in page.path else ():
            title = " / ".join(line.titles.values())
            told = (told and title == before) or bool(_WORD.search(line.text))
            before = title
            if told and not line.fenced:
                yield from (name for name in _MARKED.findall(line.text) if not _FILE.search(name))
