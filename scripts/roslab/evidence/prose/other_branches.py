"""Sections of a page that speak of another branch than the one checked out: they clone the repository with that one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache

from roslab.evidence.prose.headings import Line, lines_of
from roslab.knowledge.distros import ever, ubuntus
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_CLONE = pattern(r"\bgit\s+clone\s+([^\n;&|`]{1,300})")
_REF = pattern(r"(?:^|\s)(?:-b|--branch)[\s=]+(\S+)")
_CD = pattern(r"\bcd\s+([^\s;&|`]{1,200})")
_CHECKOUT = pattern(r"\bgit\s+(?:checkout|switch)\s+([\w./-]{1,100})\s*(?=$|[;&|`#])")
_WORD = pattern(r"[a-z]+|\d\d\.\d\d")
Section = tuple[int, ...]
"""The lines of the headings that a line stands under."""


@dataclass(frozen=True, kw_only=True, slots=True)
class _Said:
    """A branch of the repository that a section has the reader check out, ``None`` for the default one."""

    section: Section
    titles: tuple[str, ...]
    """Those of the section's headings."""
    branch: str | None


def without(repository: Repository, text: str) -> str:
    """Return the text of a page with the sections for other branches left blank, so that every line keeps its number.

    These name a distribution, and clone or check out another branch, where another section has the one checked out:
    by its name, or else by cloning without any. A release that one section clones is of this branch's history.
    """
    name, branch = repository.name.lower(), repository.branch
    if not branch or "git" not in text or name not in text.lower():
        return text
    return _without(text, name, branch)


def told(repository: Repository, file: File) -> bool:
    """Tell whether a page has sections for other branches."""
    text = repository.read(file)
    return without(repository, text) != text


@cache
def _without(text: str, name: str, branch: str) -> str:
    lines = dict(_placed(text))
    said = tuple(_said(lines, name))
    own = [each for each in said if each.branch == branch] or [each for each in said if each.branch is None]
    others = {_whole(each) for each in said if each not in own} - {()} if own else set()
    others = {other for other in others if not any(each.section[: len(other)] == other for each in own)}
    if not others:
        return text
    left = (_inside(lines, number, others) for number in range(1, text.count("\n") + 2))
    return "\n".join("" if out else line for out, line in zip(left, text.split("\n"), strict=True))


def _placed(text: str) -> Iterator[tuple[int, tuple[Section, Line]]]:
    """Yield each line's number with the section that it stands in."""
    open_: dict[int, int] = {}
    for line in lines_of(text):
        if line.heading is not None:
            open_ = {level: number for level, number in open_.items() if level < line.heading[0]}
            open_[line.heading[0]] = line.number
        yield line.number, (tuple(open_[level] for level in sorted(open_)), line)


def _said(lines: Mapping[int, tuple[Section, Line]], name: str) -> Iterator[_Said]:
    """Yield the branch that each section clones; a checkout in the clone's folder takes the place of its clone's."""
    found: dict[Section, _Said] = {}
    folder = ""
    before: Section = ()
    for section, line in lines.values():
        folder = folder if section == before else ""
        before = section
        titles = tuple(line.titles[level] for level in sorted(line.titles))
        for clone in _CLONE.finditer(line.text):
            if _named(clone[1], name):
                ref = _REF.search(clone[1])
                found[section] = _Said(section=section, titles=titles, branch=ref[1].strip("\"'") if ref else None)
        for went in _CD.finditer(line.text):
            folder = went[1].strip("\"'").rstrip("/").rpartition("/")[2].lower()
        if folder == name and (checkout := _CHECKOUT.search(line.text)):
            found[section] = _Said(section=section, titles=titles, branch=checkout[1])
    yield from found.values()


def _named(words: str, name: str) -> bool:
    """Tell whether the words of a clone have the repository's address."""
    urls = (word for word in words.split() if "/" in word)
    return any(re.sub(r"\.git$", "", url.strip("\"'<>).,/")).rpartition("/")[2].lower() == name for url in urls)


def _whole(said: _Said) -> Section:
    """Return the section around a clone of another branch whose title names a distribution; its own if the branch does.

    Nothing where neither does.
    """
    for depth in range(len(said.section), 0, -1):
        if _of_release(said.titles[depth - 1]):
            return said.section[:depth]
    return said.section if _of_release(said.branch or "") else ()


def _of_release(words: str) -> bool:
    """Tell whether words name a distribution or a release of Ubuntu."""
    return not {*ever(), *ubuntus(), *ubuntus().values()}.isdisjoint(_WORD.findall(words.lower()))


def _inside(lines: Mapping[int, tuple[Section, Line]], number: int, others: set[Section]) -> bool:
    """Tell whether a line is in one of the sections; a fence is where the line above it is."""
    while number > 1 and number not in lines:
        number -= 1
    section = lines[number][0] if number in lines else ()
    return any(section[: len(other)] == other for other in others)
