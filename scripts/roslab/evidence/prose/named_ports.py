"""Ports at which a page has its reader open what it starts: ``Open http://localhost:5055``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.knowledge.other_servers import ports_of_others
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ADDRESS = pattern(r"https?://(?:localhost|127\.0\.0\.1|0\.0\.0\.0|<([\w .-]{1,30})>):(\d{4,5})(?![\d:])")
_OPENED = pattern(
    r"\b(?:[Oo]pen(?:s|ed|ing)?|[Vv]isit|[Bb]rows\w+|[Gg]o to|[Nn]avigat\w+|[Aa]ccess\w*|[Ss]ee|[Ss]een|[Vv]iew\w*|"
    r"[Pp]oint|available (?:at|on))\b(?:[^.!?]|[.!?]\S)*$"
)
"""The words before an address that tell of opening it: other sentences tell where another server has to be."""
_REMARK = pattern(r"^\s*\S.*?\s#\s*$")
"""A command before a remark that is nothing but the address."""
_ELSEWHERE = pattern(r"(?:^|[\W_])(?:robot|remote|device|drone|camera|jetson|raspberry|pi)(?![a-z])", re.IGNORECASE)
"""A placeholder for another machine than the one that runs the image."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such port of the pages at the root, with the titles that it stands under."""
    for file in pages(repository):
        text = text_of(repository, file) if "/" not in file.path else ""
        above = ""
        for line in lines_of(text) if _ADDRESS.search(text) else ():
            shown = line.text[:MAX_LINE]
            for match in _ADDRESS.finditer(shown):
                if _opened(above, shown[: match.start()], fenced=line.fenced) and not _of_others(match[1], match[2]):
                    yield Mention(
                        topic="port",
                        value=match[2],
                        source="readme",
                        file=file.path,
                        line=line.number,
                        text=match[0],
                        heading=" / ".join(line.titles.values()),
                    )
            above = shown if shown.strip() else above


def _opened(above: str, before: str, *, fenced: bool) -> bool:
    """Tell whether what stands before an address, or in the line above where nothing does, has a reader open it."""
    if fenced and before.strip():
        return bool(_REMARK.match(before))
    return bool(_OPENED.search(before if before.strip("-*<>`([ ") else above))


def _of_others(machine: str | None, port: str) -> bool:
    return port in ports_of_others() or bool(machine and _ELSEWHERE.search(machine))
