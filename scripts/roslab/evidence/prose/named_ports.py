"""Ports at which a page has its reader open what it starts: ``http://localhost:5055``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ADDRESS = pattern(r"https?://(?:localhost|127\.0\.0\.1|0\.0\.0\.0|<[\w .-]{1,30}>):(\d{4,5})(?![\d:])")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such port of the pages at the root, with the titles that it stands under."""
    for file in pages(repository):
        text = text_of(repository, file) if "/" not in file.path else ""
        for line in lines_of(text) if _ADDRESS.search(text) else ():
            for match in _ADDRESS.finditer(line.text[:MAX_LINE]):
                yield Mention(
                    topic="port",
                    value=match[1],
                    source="readme",
                    file=file.path,
                    line=line.number,
                    text=match[0],
                    heading=" / ".join(line.titles.values()),
                )
