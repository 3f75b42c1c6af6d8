"""Lists of packages that a page shows for reference only: what its author's machine had."""

from __future__ import annotations

import re

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_REFERENCE = pattern(r"\b(?:as|for|only|a)\s(?:an?\s|your\s|the\s)?(?:\w{1,20}\s)?reference\b", re.IGNORECASE)
_LIST = pattern(r"(?<![\w./-])(?:[\w-]+/)*[\w.-]*(?:env|require)[\w.-]*\.(?:ya?ml|txt)(?![\w/-])", re.IGNORECASE)


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return each list that stands on a line of the page at the root which speaks of a reference."""
    found: dict[str, Mention] = {}
    for page in pages(repository):
        text = text_of(repository, page) if "/" not in page.path else ""
        for line in lines_of(text) if _REFERENCE.search(text) else ():
            if line.fenced or len(line.text) > MAX_LINE or not _REFERENCE.search(line.text):
                continue
            for match in _LIST.finditer(line.text):
                if repository.has(match[0]):
                    found.setdefault(
                        match[0],
                        Mention(
                            topic="reference",
                            value=match[0],
                            source="readme",
                            file=page.path,
                            line=line.number,
                            text=line.text.strip()[:200],
                        ),
                    )
    return tuple(found.values())
