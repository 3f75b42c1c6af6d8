"""Distributions in the paths that a CMakeLists.txt or a launch file has: ``/opt/ros/jazzy/include``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import end_of_line, matching_lines
from roslab.knowledge.distros import distros
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WORD = "/opt/ros/"
_PATH = pattern(r"[^#\n]{0,400}?/opt/ros/([a-z]+)\b(?!\.)")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each distribution that a file of the author's has a path of, at its first place in it."""
    launched = (file for file in repository.suffixed(".py", ".launch", ".xml") if ".launch" in file.name)
    for file in (*repository.named("CMakeLists.txt"), *launched):
        text = "" if places.aside(file.path) else repository.read(file)
        told: set[str] = set()
        for match in matching_lines(_PATH, text, _WORD) if _WORD in text else ():
            name = match[1]
            if name in distros() and name not in told:
                told.add(name)
                line = text.count("\n", 0, match.start()) + 1
                said = text[match.start() : end_of_line(text, match.start())].strip()[:120]
                yield Mention(topic="distro", value=name, source="code", file=file.path, line=line, text=said)
