"""Programs that launch files run beside their nodes: around one, or to make a parameter."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.attributes import attributes
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.ros.executed import executed
from roslab.evidence.ros.launch_conditions import started
from roslab.knowledge.compiled import programs
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import File
from roslab.values.pattern import pattern

_PREFIX = pattern(r"\b(?:launch-)?prefix\s{0,9}=\s{0,9}\[?\s{0,9}[\"']\s{0,9}([a-z][\w.-]{1,40})(?=[\s\"'])")
"""A program that starts a node in its place: ``launch-prefix="xterm -e"``."""
_QUOTED = pattern(r"\"[^\"]*\"|'[^']*'")
"""A value, which may hold what ends a tag elsewhere: an attribute behind the tag is a remark."""
_DEBUGS = pattern(r"(?:^|[-_.])(?:gdb|debug\w*|valgrind|perf|profil\w*)(?:[-_.]|$)", re.IGNORECASE)
"""The name of a launch file for those who look for a fault."""
_COMMAND = pattern(
    r"(?:<param\s[^>]{0,300}?\bcommand\s?=\s?[\"']|\$\(command\s+[\"']|\bCommand\(\s*\[?\s*[\"']|"
    r"\bFindExecutable\(\s*(?:name\s?=\s?)?[\"'])\s*([a-z][\w.-]{1,40}?)(?:\.py)?(?=[\s\"'])"
)
"""A program that makes a parameter: ``command="xacro robot.xacro"``."""
_COMMANDS = ("<param", "$(command", "Command(", "FindExecutable(")
"""What its matches begin with."""
_OF_PACKAGE = r"(?:package|pkg)\s?[=:]\s?[\"']([\w-]{1,60})[\"']"
_PROGRAM = r"(?:exec(?:utable)?|type)\s?[=:]\s?[\"']([\w.-]{1,60})[\"']"
_NODE = pattern(rf"{_OF_PACKAGE}[^<>()]{{0,160}}?{_PROGRAM}")
_NODE_AFTER = pattern(rf"{_PROGRAM}[^<>()]{{0,160}}?{_OF_PACKAGE}")
"""The package and the program of a node in a call or an element, in either order."""
_TAG = pattern(r"<(arg|param)\s((?:[^<>\"']|\"[^\"<]{0,600}\"|'[^'<]{0,600}'){0,900})>")
_PYTHON = pattern(r"python[\d.]*")
"""ROS's own, which the image has."""
_ARGUMENT = pattern(r"\$\(\s*arg\s+(\w+)\s*\)")


def started_first(text: str, file: File, conditional: Callable[[str, int, int], bool]) -> Iterator[Dependency]:
    """Yield the programs of apt that start a node in its place, whatever the arguments are, and what opens a window."""
    xml = text.lstrip().startswith("<")
    for match in matches_at(_PREFIX, text, "launch-prefix", "prefix") if not _DEBUGS.search(file.name) else ():
        aside = xml and ">" in _QUOTED.sub("", text[text.rfind("<", 0, match.start()) : match.start()])
        if (name := programs().get(match[1])) and not (aside or conditional(text, match.start(), match.end())):
            line = text.count("\n", 0, match.start()) + 1
            yield Dependency(namespace="apt", name=name, strength="used", file=file.path, line=line, role="exec")
    yield from _executed(text, file)
    yield from _window_of_joints(text, file)


def _executed(text: str, file: File) -> Iterator[Dependency]:
    """Yield the programs of apt that a file in Python starts beside its nodes."""
    for each in executed(text, started) if file.name.endswith(".py") else ():
        name = "" if _PYTHON.fullmatch(each.program) else programs().get(each.program)
        if name:
            yield Dependency(namespace="apt", name=name, strength="used", file=file.path, line=each.line, role="exec")


def _window_of_joints(text: str, file: File) -> Iterator[Dependency]:
    """Yield the package of the window that joint_state_publisher opens by its parameter, which it stops without.

    It was a part of it until kinetic and melodic had 1.12.14: https://github.com/ros/joint_state_publisher/pull/31,
    2026-11-26. Of an argument its default counts.
    """
    if "use_gui" not in text or "joint_state_publisher" not in text:
        return
    tags = [(m, attributes(m[2])) for m in _TAG.finditer(text)]
    given = {said.get("name", ""): said.get("default", said.get("value", "")) for m, said in tags if m[1] == "arg"}
    for match, said in tags:
        value = said.get("value", "") if match[1] == "param" and said.get("name", "").strip("/~") == "use_gui" else ""
        if argument := _ARGUMENT.fullmatch(value.strip()):
            value = given.get(argument[1], "")
        if value.strip().lower() in {"true", "1"}:
            line = text.count("\n", 0, match.start()) + 1
            name = "joint_state_publisher_gui"
            yield Dependency(namespace="ros", name=name, strength="optional", file=file.path, line=line, role="exec")
            return


def of_parameters(text: str) -> Iterator[re.Match[str]]:
    """Yield the matches, with the package first, of programs that make a parameter: one is called like its package."""
    yield from (match for match in matches_at(_COMMAND, text, *_COMMANDS) if ever_released(match[1]))


def nodes(text: str, started: Callable[[str, int, int], bool | None]) -> Iterator[tuple[str, str]]:
    """Yield the package and the program of each node that a launch file starts, unless its condition does not hold."""
    if not any(word in text for word in ("exec", "type")):
        return
    for match in matches_at(_NODE, text, "package", "pkg"):
        if started(text, match.start(), match.end()) is not False:
            yield match[1], match[2]
    for match in matches_at(_NODE_AFTER, text, "exec", "type"):
        if started(text, match.start(), match.end()) is not False:
            yield match[2], match[1]
