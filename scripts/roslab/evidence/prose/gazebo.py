"""The release of Gazebo that a text names: each is an ordinary word, which counts behind Gazebo's name alone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.knowledge.gazebo_releases import gazebo_releases
from roslab.repository.checkout import Repository

_SIGNS = ("azebo", "gz", "ign", "Gz", "GZ", "IGN", "Ign", "AZEBO")
MAX_SIZE = 256 * 1024
MOST = 20
"""Most mentions of one text."""


@cache
def _said() -> re.Pattern[str]:
    names = "|".join(gazebo_releases())
    program = r"(?:gazebo|gz|ign(?:ition)?)(?:[\s_-]{0,2}(?:sim|version|release))?"
    docs = r"(?:gazebosim|ignitionrobotics)\.org/docs"
    between = r"[\s:=_/\"'`(*)-]{1,4}"
    return re.compile(rf"(?<![a-z])(?:{program}|{docs}){between}({names})(?![a-z])", re.IGNORECASE)


def named(text: str, file: str, source: Literal["dockerfile", "ci", "readme", "script", "launch"]) -> Iterator[Mention]:
    """Yield the releases that a text names, each with its line: ``Gazebo Harmonic``, ``gz-harmonic``."""
    if not any(sign in text for sign in _SIGNS) or not any(map(text.lower().__contains__, gazebo_releases())):
        return
    for number, match in enumerate(_said().finditer(text)):
        if number >= MOST:
            return
        start = text.rfind("\n", 0, match.start()) + 1
        end = text.find("\n", match.end())
        said = text[max(start, match.start() - 90) : min(end if end >= 0 else len(text), match.end() + 90)]
        line = text.count("\n", 0, match.start()) + 1
        yield Mention(topic="gazebo", value=match[1].lower(), source=source, file=file, line=line, text=said.strip())


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each release that launch files name in their code or comments."""
    for file in repository.suffixed(".launch", ".xml", ".py"):
        if "launch" in file.path and file.size <= MAX_SIZE and not places.vendored(file.path):
            yield from named(repository.read(file), file.path, "launch")
