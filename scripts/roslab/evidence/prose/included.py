"""Launch files that the page at the root shows how to include, with the arguments that it gives."""

from __future__ import annotations

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_INCLUDE = pattern(
    r"<include\s{1,9}file\s?=\s?[\"']\$\(find(?:-pkg-share)?\s+([a-z]\w{0,60})\)/(?:[\w.-]{1,60}/){0,4}([\w.-]{1,80})[\"']\s{0,9}"
    r"(?:/>|>((?:(?!</?include\b)[\s\S]){0,4000})</include>)"
)
"""``<include file="$(find demo)/launch/a.launch">…</include>``: the package, the file's name, what stands between."""
_GIVEN = pattern(r"<arg\s+name\s?=\s?[\"']([\w-]{1,60})[\"']\s+value\s?=\s?[\"']([\w./:-]{1,200})[\"']\s*/?>")


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the package and the name of each file, and what it is given: ``demo a.launch eye:=left``.

    Arguments with substitutions are left out: their values are the reader's.
    """
    found: list[Mention] = []
    for page in pages(repository):
        text = text_of(repository, page) if "/" not in page.path else ""
        for match in matches_at(_INCLUDE, text, "<include"):
            given = (f"{name}:={value}" for name, value in _GIVEN.findall(match[3] or ""))
            found.append(
                Mention(
                    topic="included",
                    value=" ".join((match[1], match[2], *given)),
                    source="readme",
                    file=page.path,
                    line=text.count("\n", 0, match.start()) + 1,
                    text=" ".join(match[0].split())[:200],
                )
            )
    return tuple(found)
