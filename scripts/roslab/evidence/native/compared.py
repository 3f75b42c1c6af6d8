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
_COMPARED = pattern(
    r"^[ \t]*(?:else)?if[ \t]*\([^#\n]{0,200}?\$ENV\{ROS_DISTRO\}[\"']?[ \t]+"
    r"(?:STREQUAL|MATCHES)[ \t]+[\"']?\^?([a-z]+)",
    re.IGNORECASE | re.MULTILINE,
)


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each distribution that a file of the author's names so, at its first place in it."""
    for file in repository.named("CMakeLists.txt"):
        text = "" if places.aside(file.path) else repository.read(file)
        told: set[str] = set()
        for match in matching_lines(_COMPARED, text, _WORD) if _WORD in text else ():
            name = match[1].lower()
            if name in distros() and name not in told:
                told.add(name)
                line = text.count("\n", 0, match.start(1)) + 1
                said = text[match.start() : end_of_line(text, match.start())].strip()[:120]
                yield Mention(topic="compared", value=name, source="code", file=file.path, line=line, text=said)
