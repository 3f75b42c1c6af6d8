"""Install lines of a page in a section for another distribution or Ubuntu, where one for this image has its own."""

from __future__ import annotations

from functools import cache

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros_of, ever, ubuntus
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_WORD = pattern(r"[a-z]+|\d\d\.\d\d")
_OPEN = pattern(r"\d\+|>|≥|\b(?:newer|later|above|higher|up|onwards?|older|earlier|below|before|others?)\b")
"""The title names more than it lists."""


def of_this_ubuntu(evidence: Evidence, ubuntu: str | None, distro: str | None) -> Evidence:
    """Return the evidence without lines of apt whose titles name others alone, on a page that has this one's too."""
    ours = {ubuntu, distro} - {None}
    ours |= {*distros_of(ubuntu, 1), *distros_of(ubuntu, 2)} if ubuntu and not distro else set()
    said = {each: named for each in evidence.prose if each.heading and (named := _named(each.heading))}
    having = {each.file for each, named in said.items() if named & ours}
    left = tuple(each for each in evidence.prose if not _of_others(each, said.get(each), ours, having))
    return replace(evidence, prose=left) if len(left) < len(evidence.prose) else evidence


def _of_others(asked: Dependency, named: frozenset[str] | None, ours: set[str | None], having: set[str]) -> bool:
    return named is not None and asked.file in having and not named & ours


@cache
def _named(heading: str) -> frozenset[str]:
    """Return the distributions and Ubuntus in the innermost title that names any, none where others are meant too."""
    for title in reversed(heading.lower().split(" / ")):
        words = (ubuntus().get(word, word) for word in _WORD.findall(title))
        if found := {*ever(), *ubuntus().values()} & set(words):
            return frozenset() if _OPEN.search(title) else frozenset(found)
    return frozenset()
