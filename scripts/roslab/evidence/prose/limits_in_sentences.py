"""Limits that a sentence of a page gives a Python package: "it is important to use `gym<=0.19.0`"."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.knowledge.prose_names import package_of
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

SENTENCE = pattern(r"(?<=[.!?;])\s+(?=[A-Z\[(])")
"""Where one ends; a page may have a whole paragraph on one line."""
MEANT = pattern(
    r"\b(?:tested|require[sd]?|needs?|develop(?:ed|ment)|depends?|works?|verified|implemented|written|using|runs?|we\s+used?)\b",
    re.IGNORECASE,
)
"""A sentence about what the code itself runs with."""
NOT = pattern(
    r"\b(?:not|n't|instead|other|another|older|old|previous|before|branch|port|convert\w*|newer versions?)\b",
    re.IGNORECASE,
)
_BOUNDED = pattern(
    r"`([A-Za-z][\w.-]*\s?(?:<=|==|~=|<)\s?\d+(?:\.\d+)*)`|"
    r"(?<![\w.`/=:-])([A-Za-z][\w.-]*==\d+(?:\.\d+)+)(?![\w`*=+]|\.\w)"
)
"""A requirement that is all there is between backticks, or one as pip is given it."""
_NAME = pattern(r"[A-Za-z][\w.-]*")
_INSTALLS = pattern(r"\b(?:pip[\d.]*|conda|mamba)\b")
"""A line with such a word may be a command, which others read."""
_TO_USE = pattern(
    r"\b(?:us(?:e|ing)|must|should|please|make sure|ensure|install(?:ed|ing)?|downgrad(?:e|ing)|pin(?:ned)?)\b",
    re.IGNORECASE,
)
_TROUBLE = pattern(
    r"\b(?:if|alternatively|optional(?:ly)?|bugs?|issues?|errors?|fail\w*|broken?|warnings?|deprecated)\b",
    re.IGNORECASE,
)
MAX_LINE = 400
MAX_PARAGRAPH = 4000


def bounded(text: str, file: str) -> Iterator[Requirement]:
    """Yield each requirement in a sentence that tells to use it: "it is important to use `gym<=0.19.0`".

    It has the role ``bounded``: it only counts for a package that something else asks for.
    """
    fenced = False
    for number, line in enumerate(text.split("\n"), start=1):
        fenced = fenced != fence(line)
        signs = "`" in line or "==" in line
        if fenced or not signs or len(line) > MAX_PARAGRAPH or not _BOUNDED.search(line):
            continue
        for sentence in SENTENCE.split(line):
            meant = MEANT.search(sentence) or _TO_USE.search(sentence)
            if len(sentence) <= MAX_LINE and meant and not (NOT.search(sentence) or _TROUBLE.search(sentence)):
                for match in _BOUNDED.finditer(sentence):
                    if match[2] and _INSTALLS.search(sentence):
                        continue
                    yield stated(_by_index(match[1] or match[2]), "prose", file, number, role="bounded")


def _by_index(asked: str) -> str:
    """Return a requirement with what pip calls the package: ``Stable baselines3`` has other spellings in pages."""
    name = _NAME.match(asked)
    return f"{package_of(name[0]) or name[0]}{asked[name.end() :]}" if name else asked


def fence(line: str) -> bool:
    """Tell whether a line begins or ends a code block."""
    return line.lstrip()[:3] in {"```", "~~~"}
