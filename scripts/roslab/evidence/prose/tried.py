"""What a page has the reader run once to see whether it works: ``test your installation by running:``."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, fence
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_SAID = pattern(
    r"\b(?:[Tt]est|[Vv]erify|[Cc]heck|[Tt]ry)\b[^.\n]{0,40}\b(?:install\w*|set-?up|build)\b[^.\n]{0,60}"
    r"\b(?:run|launch|start|execut)\w*\b|"
    r"\b(?:[Rr]un|[Ll]aunch|[Ss]tart|[Tt]ry)(?:ning|ing)?\s+(?:an?|the|our)\s+(?:\w+\s+){0,2}(?:demo\w*|example)\b"
)

_LAST = pattern(r"[.!?:]\)?\s+(?=[A-Z])")
"""Between two sentences: the last one is about the block below it."""


def read(repository: Repository, said: Iterable[Mention]) -> tuple[Mention, ...]:
    """Return the commands in blocks of pages below such a sentence."""
    commands = [mention for mention in said if mention.topic == "command" and mention.source == "readme"]
    files = {mention.file for mention in commands}
    below = {page.path: _lines(text_of(repository, page)) for page in pages(repository) if page.path in files}
    return tuple(
        Mention(topic="tried", value=m.value, source="readme", file=m.file, line=m.line, text=m.text)
        for m in commands
        if m.line in below.get(m.file, ())
    )


def _lines(text: str) -> frozenset[int]:
    """Return the numbers of the lines in the blocks that such a sentence introduces."""
    found: set[int] = set()
    fenced = introduced = False
    for number, line in enumerate(text.split("\n") if _SAID.search(text) else (), 1):
        if fence(line):
            fenced = not fenced
            introduced = introduced and fenced
        elif fenced and introduced:
            found.add(number)
        elif not fenced and line.strip():
            introduced = len(line) <= MAX_LINE and bool(_SAID.search(_LAST.split(line.rstrip())[-1]))
    return frozenset(found)
