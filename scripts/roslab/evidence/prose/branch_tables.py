"""Tables of pages that tell which branch is for which distribution: ``| Distro | Branch | Build |``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.evidence.facts import Mention
from roslab.evidence.prose.pages import pages, text_of
from roslab.knowledge.distros import ever
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_RULE = frozenset("|:- \t\r")
"""All that stands on the line below a table's first one."""
_LINK = pattern(r"!?\[([^\[\]]{0,200})\]\([^()]{0,500}\)")
_NAME = pattern(r"[\w][\w./-]*")
_WORD = pattern(r"[a-z]+")
_BRANCH = pattern(r"\bbranch(?:es)?\b", re.IGNORECASE)
_OF_OTHERS = pattern(r"\b(?:packages?|repo\w*|depend\w*|librar\w*|projects?|modules?)\b", re.IGNORECASE)
"""The title of a column that tells of other repositories, whose branches these are."""
_PAST = pattern(r"\beol\b|end[- ]of[- ]life|deprecated|unsupported|no longer|\bnot\b", re.IGNORECASE)
MOST_ROWS = 40
MOST_WORDS = 12
"""Most words of a cell that names distributions: more are a sentence."""
Row = tuple[int, tuple[str, ...]]
"""A line's number and its cells."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return each distribution that a table at the root has in the row, or the column, of the branch checked out.

    Nothing where that branch stands beside none, or where the tables do not name any.
    """
    branch = repository.branch
    found: list[Mention] = []
    for page in pages(repository) if branch else ():
        text = text_of(repository, page) if "/" not in page.path else ""
        for table in _tables(text) if "|" in text and _BRANCH.search(text) else ():
            for line, name in _of(branch or "", table):
                found.append(
                    Mention(topic="distro", value=name, source="branch", file=page.path, line=line, text=branch or "")
                )
    return tuple(dict.fromkeys(found))


def _tables(text: str) -> Iterator[list[Row]]:
    """Yield the rows of each table, the first of which has the titles."""
    lines = text.split("\n")
    for index, line in enumerate(lines):
        if index and "-" in line and _RULE.issuperset(line) and "|" in lines[index - 1]:
            rows = [(index, _cells(lines[index - 1]))]
            for number, row in enumerate(lines[index + 1 : index + 1 + MOST_ROWS], index + 2):
                if "|" not in row:
                    break
                rows.append((number, _cells(row)))
            yield rows


def _cells(line: str) -> tuple[str, ...]:
    said = _LINK.sub(lambda match: match[1], _LINK.sub(lambda match: match[1], line[:4000]))
    return tuple(cell.strip().strip("*_`").strip() for cell in said.strip().strip("|").split("|"))


def _of(branch: str, table: Sequence[Row]) -> Iterator[tuple[int, str]]:
    """Yield the distributions beside a branch, each with its line: in its row, or above it where a row has them all."""
    (_, titles), *rows = table
    if any(map(_OF_OTHERS.search, titles)):
        return
    column = next((at for at, title in enumerate(titles) if _BRANCH.search(title)), None)
    if column is not None:
        for line, cells in rows:
            if len(cells) > column and branch in _NAME.findall(cells[column]):
                others = (cell for at, cell in enumerate(cells) if at != column)
                yield from ((line, name) for cell in others for name in _named(cell))
        return
    for line, cells in rows:
        if _BRANCH.search(cells[0]):
            for title, cell in zip(titles[1:], cells[1:], strict=False):
                if branch in _NAME.findall(cell):
                    yield from ((line, name) for name in _named(title))


def _named(cell: str) -> list[str]:
    """Return the distributions that a short cell names."""
    words = _WORD.findall(cell.lower())
    told = len(words) <= MOST_WORDS and not _PAST.search(cell)
    return [word for word in dict.fromkeys(words) if word in ever()] if told else []
