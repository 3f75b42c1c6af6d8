"""Steps of a page that not every reader takes: what the sentence or the comment above a command says of it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from roslab.evidence.dependency import GitSource
from roslab.evidence.prose.headings import MAX_LINE, fence, heading_of, title_of
from roslab.values.dataclass import replace
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

_SAID = pattern(
    r"\boption(?:al(?:ly)?)?\b|\balternative|\bif (?:you|needed|necessary|desired|not)\b|\bin case\b|"
    r"\b(?:can|may) skip\b|"
    r"\bonly (?:if|for|needed|required|necessary)\b|\bnot (?:needed|required|necessary|mandatory)\b|"
    r"\b(?:for|to) (?:the )?(?:visuali[sz]|evaluat|compar|benchmark|debug)|\bviewer\b|\bdata ?sets?\b|"
    r"\bmac ?os|\bwindows\b|\bandroid\b|可选",
    re.IGNORECASE,
)
_TITLES = pattern(
    r"option|alternativ|troubl|docker|hardware|simulat|advanced|develop|faq|known issue|visuali[sz]|viewer|evaluat|"
    r"benchmark|data ?set|android|可选",
    re.IGNORECASE,
)
"""Titles of sections that not everybody follows."""
_NEEDED = pattern(r"(?<!not )(?<!if )\b(?:required|necessary|mandatory)\b", re.IGNORECASE)
"""Of a title that says so, everybody does: ``Install required simulation packages``."""
_ITSELF = pattern(
    r"\b(?:clon|download|check(?:ing)? ?out|fetch)\w*\b[^.]{0,20}\b(?:this|our)\b[^.]{0,20}"
    r"\b(?:repo|package|project|code)",
    re.IGNORECASE,
)
"""What a page says above the line that clones the repository that it is about."""
_ITEM = pattern(r"\s*(?:[-*+]|\d{1,2}[.)])\s")
_TOP = 30
"""Lines in which the first title of a page is looked for."""
MOST = 3
"""Most lines of a sentence."""


def marked(sources: Iterable[GitSource], text: str) -> list[GitSource]:
    """Return what a page clones, each with a mark where not everybody needs it.

    Its section tells that, the comments right above it in its block, the line itself outside of one, or the sentence
    above; the title of the page tells what the code is for. What such a section clones is none of the workspace's.
    """
    sources = tuple(sources)
    if not sources:
        return []
    lines = text.split("\n")
    title = title_of(lines)
    named = heading_of(lines[title - 1], "") if title else None
    found = [_marked(git, lines, named[1] if named else "") for git in sources]
    first = {_block(lines, git.line): git.line for git in reversed(found)}
    called = next((bare_name(each[1]) for line in lines[:_TOP] if (each := heading_of(line[:MAX_LINE], ""))), None)
    return [
        replace(
            git,
            itself=bare_name(git.name) == called or (git.itself and first[_block(lines, git.line)] == git.line),
        )
        for git in found
    ]


def _block(lines: Sequence[str], line: int) -> int:
    """Return the line that begins a line's block, the line itself outside of one."""
    begins = _fence_of(lines, min(line, len(lines)) - 1)
    return line if begins is None else begins


def _marked(git: GitSource, lines: Sequence[str], title: str) -> GitSource:
    itself = any(_ITSELF.search(line) for line in _above(lines, git))
    sections = [each for each in git.heading.split(" / ") if each != title]
    if any(_TITLES.search(each) and not _NEEDED.search(each) for each in sections):
        return replace(git, aside=True, beside=False, itself=itself)
    return replace(git, itself=itself, aside=any(_SAID.search(line) for line in _above(lines, git)))


def _above(lines: Sequence[str], git: GitSource) -> Iterator[str]:
    index = min(git.line, len(lines)) - 1
    begins = _fence_of(lines, index)
    if begins is None:
        yield lines[index]
    else:
        comments = index - 1
        while comments > begins and lines[comments].strip():
            if lines[comments].lstrip().startswith("#"):
                yield lines[comments]
            comments -= 1
        index = begins
    index -= 1
    while index >= 0 and not lines[index].strip():
        index -= 1
    for line in reversed(lines[max(0, index + 1 - MOST) : index + 1]):
        if not line.strip() or fence(line) or heading_of(line, ""):
            return
        yield line
        if _ITEM.match(line):
            return


def _fence_of(lines: Sequence[str], index: int) -> int | None:
    """Return the line that begins the block in which a line stands, ``None`` outside of one."""
    begins: int | None = None
    for number, line in enumerate(lines[:index]):
        if fence(line):
            begins = number if begins is None else None
    return begins
