"""Distributions that a CMakeLists.txt compares the environment's with: ``if("$ENV{ROS_DISTRO}" STREQUAL "noetic")``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import end_of_line, matching_lines
from roslab.knowledge.distros import distros
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WORD = "ENV{ROS_DISTRO}"
_IF = pattern(r"^[ \t]*(?:else)?if[ \t]*\([^#\n]{0,400}", re.IGNORECASE | re.MULTILINE)
_COMPARED = pattern(
    r"\$ENV\{ROS_DISTRO\}[\"']?[ \t]+(?:STREQUAL|MATCHES)[ \t]+[\"']?\^?([a-z]+)",
    re.IGNORECASE,
)


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each distribution that a file of the author's names so, at its first place in it."""
    for file in repository.named("CMakeLists.txt"):
        text = "" if places.aside(file.path) else repository.read(file)
        told: set[str] = set()
        for condition in matching_lines(_IF, text, _WORD) if _WORD in text else ():
            names = {match[1].lower() for match in _COMPARED.finditer(condition[0])} & distros().keys() - told
            told |= names
            line = text.count("\n", 0, condition.start()) + 1
            said = text[condition.start() : end_of_line(text, condition.start())].strip()[:120]
            for name in sorted(names):
                yield Mention(topic="compared", value=name, source="code", file=file.path, line=line, text=said)
