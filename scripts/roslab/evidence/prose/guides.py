"""Sections on the installation that only lead to the page of another repository."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, Line, lines_of
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_TITLE = pattern(
    r"(?i)\b(?:install\w*|set-?up|setting up|build(?:ing)?|compil\w*|dependenc\w*|requirements?|prerequisites?|"
    r"getting started)\b"
)
_LINK = pattern(r"\[([^\]\n]{1,120})\]\((https?://(?:www\.)?github\.com/[\w.-]+/[\w.-]+[^)\s]{0,200})\)")
_SENDS = pattern(r"(?i)\b(?:see|refer|follow|found|find|described|instructions?|guides?|check|visit|consult)\b")
_ABOUT = pattern(
    r"(?i)install|set-?up|setting up|\bbuild|compil|dependenc|requirements?|prerequisites?|get(?:ting)? started"
)
_CODE = pattern(r"(?:\s{4,}|\t|\s*\$ )\S")
"""A line of code without a fence."""


def read(repository: Repository) -> Prose:
    """Return where pages at the root send their readers for the installation, in sections without a command."""
    top = (file for file in pages(repository) if "/" not in file.path)
    return Prose(mentions=tuple(each for file in top for each in _of_page(text_of(repository, file), file.path)))


def _of_page(text: str, file: str) -> Iterator[Mention]:
    if "github.com/" not in text:
        return
    found: list[Mention] = []
    code = False
    for line in lines_of(text):
        if line.heading:
            yield from () if code else found
            found, code = [], False
        title = line.titles[max(line.titles)] if line.titles else ""
        code = code or line.fenced or bool(_CODE.match(line.text))
        if not (line.fenced or line.elsewhere) and _TITLE.search(title):
            found += _sent(line, file)
    yield from () if code else found


def _sent(line: Line, file: str) -> Iterator[Mention]:
    text = line.text[:MAX_LINE]
    for link in _LINK.finditer(text) if _SENDS.search(text) and _ABOUT.search(text) else ():
        yield Mention(topic="guide", value=link[2], source="readme", file=file, line=line.number, text=text[:200])
