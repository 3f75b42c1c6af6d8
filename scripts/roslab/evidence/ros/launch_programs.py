"""Programs that launch files run beside their nodes: around one, or to make a parameter."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.lines import matches_at
from roslab.knowledge.compiled import programs
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import File
from roslab.values.pattern import pattern

_PREFIX = pattern(r"\b(?:launch-)?prefix\s{0,9}=\s{0,9}\[?\s{0,9}[\"']\s{0,9}([a-z][\w.-]{1,40})(?=[\s\"'])")
"""A program that starts a node in its place: ``launch-prefix="xterm -e"``."""
_DEBUGS = pattern(r"(?:^|[-_.])(?:gdb|debug\w*|valgrind|perf|profil\w*)(?:[-_.]|$)", re.IGNORECASE)
"""The name of a launch file for those who look for a fault."""
_COMMAND = pattern(
    r"(?:<param\s[^>]{0,300}?\bcommand\s?=\s?[\"']|\$\(command\s+[\"']|\bCommand\(\s*\[?\s*[\"']|"
    r"\bFindExecutable\(\s*(?:name\s?=\s?)?[\"'])\s*([a-z][\w.-]{1,40}?)(?:\.py)?(?=[\s\"'])"
)
"""A program that makes a parameter: ``command="xacro robot.xacro"``."""
_COMMANDS = ("<param", "$(command", "Command(", "FindExecutable(")
"""What its matches begin with."""


def started_first(text: str, file: File, conditional: Callable[[str, int, int], bool]) -> Iterator[Dependency]:
    """Yield the programs of apt that start a node in its place, whatever the arguments are."""
    for match in matches_at(_PREFIX, text, "launch-prefix", "prefix") if not _DEBUGS.search(file.name) else ():
        if (name := programs().get(match[1])) and not conditional(text, match.start(), match.end()):
            line = text.count("\n", 0, match.start()) + 1
            yield Dependency(namespace="apt", name=name, strength="used", file=file.path, line=line, role="exec")


def of_parameters(text: str) -> Iterator[re.Match[str]]:
    """Yield the matches, with the package first, of programs that make a parameter: one is called like its package."""
    yield from (match for match in matches_at(_COMMAND, text, *_COMMANDS) if ever_released(match[1]))
