"""The titles of a page, its blocks of code, and the sections that are for another system than this one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from roslab.values.pattern import pattern

MAX_LINE = 2_000
"""Most characters of a line that a person types."""
_FENCE = pattern(r"^\s{0,40}(?:[-*>]\s{0,20}){0,9}(?:```+(?![^\n]*`)|~~~+)")
"""Backquotes that are closed on their own line are inline code. https://spec.commonmark.org/0.31.2/#fenced-code-blocks"""
_HEADING = pattern(r"^(#{1,6})\s+(.*?)\s*#*$")
_SYSTEMS = r"windows|mac ?os ?x?|macos|osx|homebrew|arch linux|fedora|centos|jetson|raspberry"
_ELSEWHERE = pattern(
    rf"\b(?:{_SYSTEMS}|nvidia driver|uninstall|docker (?:install|engine)|real[- ]robots?(?!is\b)|"
    r"hardware(?: setup)?|kernel|contribut|changelog|news|acknowledg|citation|licen[sc]e)",
    re.IGNORECASE,
)
WITHOUT = pattern(
    r"\b(?:no|without(?: an?y?)?|fake|mock(?:ed)?|simulated|virtual)[ -](?:real[ -])?(?:hardware|robots?)\b",
    re.IGNORECASE,
)
"""What needs no other machine: ``Simulation (no hardware)``."""
_HARDWARE = pattern(r"\b(?:real[- ]robots?|hardware)\b", re.IGNORECASE)
_SIMULATED = pattern(r"\b(?:simulat(?:ions?|ed|ors?|ing)|dry run)\b", re.IGNORECASE)
_BOTH = pattern(r"\b(?:real|actual|physical|hardware|not?|n't|instead)\b", re.IGNORECASE)
_SYSTEM = pattern(rf"\b(?:{_SYSTEMS})", re.IGNORECASE)
"""What the title of a whole page may be about; other words tell what the code is for: ``Policies for Real Robots``."""
_HERE = pattern(
    r"\s{0,12}(?:[-*+]|\d{1,2}[.)])\s+[*_]{0,3}(?:(?:on|for)\s+)?(?:ubuntu|linux|debian)\b[^:`\n]{0,60}:[*_]{0,3}\s*`",
    re.IGNORECASE,
)
"""An item that has a command for this system: what follows it is for all systems again."""
_LEAF = pattern(r"\b(?:acknowledg|citation|licen[sc]e)", re.IGNORECASE)
DEEPEST = 7
"""Such a section ends at the next heading, whatever the level of that one."""
_RST_LINE = pattern(r"^([=\-~^\"'`+#*])\1{3,}\s*$")
_RST_BEGINS = frozenset(4 * mark for mark in "=-~^\"'`+#*")


class Line(NamedTuple):
    """A line of a page that is no fence."""

    number: int
    text: str
    fenced: bool
    heading: tuple[int, str] | None
    """Its level and its title, if it is one."""
    titles: Mapping[int, str]
    """The titles that it stands under, its own too, by their levels."""
    elsewhere: bool
    """Its section is for another system."""


def lines_of(text: str) -> Iterator[Line]:
    """Yield the lines of a page."""
    lines = text.split("\n")
    whole = title_of(lines)
    titles: dict[int, str] = {}
    elsewhere, fenced = 0, False
    here = resumed(lines)
    for number, line in enumerate(lines, 1):
        elsewhere = 0 if elsewhere and number in here and about(titles) else elsewhere
        if fence(line):
            fenced = not fenced
            continue
        heading = None if fenced else heading_of(line, lines[number] if number < len(lines) else "")
        elsewhere = section_of(heading, elsewhere) if number != whole else 0
        titles = under(titles, heading)
        yield Line(number, line, fenced, heading, titles, bool(elsewhere))


def under(titles: dict[int, str], heading: tuple[int, str] | None) -> dict[int, str]:
    """Return the titles that hold from a line on, by their levels; ``heading`` is that of the line, if it is one."""
    if heading is None:
        return titles
    return {level: title for level, title in titles.items() if level < heading[0]} | {heading[0]: heading[1]}


def fence(line: str) -> bool:
    """Tell whether a line begins or ends a block of code."""
    return ("```" in line or "~~~" in line) and bool(_FENCE.match(line[:MAX_LINE]))


def heading_of(line: str, below: str) -> tuple[int, str] | None:
    """Return the level and the title of a heading: ``## Title``, or a line above a line of ``===``."""
    if line.startswith("#") and (heading := _HEADING.match(line[:200])):
        return len(heading[1]), heading[2]
    if below[:4] in _RST_BEGINS and line.strip() and _RST_LINE.match(below[:200]):
        return 2, line.strip()[:200]
    return None


def title_of(lines: Sequence[str]) -> int:
    """Return the number of the line with the title of the whole page, the only ``#``; 0 if its sections are so too.

    A title that names another system counts as a section: all of the page is for that.
    """
    fenced, found = False, 0
    for number, line in enumerate(lines, 1):
        if fence(line):
            fenced = not fenced
        elif not fenced and line.startswith("#") and (heading := _HEADING.match(line[:200])):
            first = len(heading[1]) == 1
            if first == bool(found) or (not found and _SYSTEM.search(heading[2])):
                return 0
            found = found or number
    return found


def simulated(lead: str, titles: Mapping[int, str]) -> bool:
    """Tell whether what follows needs no hardware though its section is about that: ``In case of a simulation:``.

    ``lead``: the last line of prose before it; ``titles``: those that it stands under.
    """
    lead = lead.rstrip(" *_") if len(lead) <= MAX_LINE else ""
    said = lead.endswith(":") and _SIMULATED.search(lead) and not _BOTH.search(WITHOUT.sub("", lead))
    about = [WITHOUT.sub("", title) for title in titles.values()] if said else []
    return any(map(_HARDWARE.search, about)) and not any(_ELSEWHERE.search(_HARDWARE.sub("", each)) for each in about)


def resumed(lines: Sequence[str]) -> frozenset[int]:
    """Return the numbers of the lines from which on a section about another system is about this one again.

    ``## Packages on macOS`` may be the last title above the steps that are the same on both: ``- Ubuntu: `cmake ..` ``.
    Such an item has a command for this system; the block of commands right above it is for both.
    """
    found: set[int] = set()
    opened, fenced, behind = 0, False, False
    for number, line in enumerate(lines, 1):
        if fence(line):
            fenced = not fenced
            opened, behind = (number, False) if fenced else (opened, True)
        elif not fenced and line.strip():
            if "`" in line and _HERE.match(line[:200]):
                found.add(opened if behind else number)
            behind = False
    return frozenset(found)


def about(titles: Mapping[int, str]) -> bool:
    """Tell whether a title names another system."""
    return any(map(_SYSTEM.search, titles.values()))


def section_of(heading: tuple[int, str] | None, elsewhere: int) -> int:
    """Return the level of the heading under which the text is for another system, 0 if it is for this one.

    ``heading`` is that of the line that is read, if it is one; ``elsewhere`` is what holds above it.
    """
    if heading is None:
        return elsewhere
    level, title = heading
    if 0 < elsewhere < level:
        return elsewhere
    if _LEAF.search(title):
        return DEEPEST
    return level if _ELSEWHERE.search(WITHOUT.sub("", title)) else 0
