"""Functions and aliases of the repository's own scripts for the shell, which its pages have the reader call."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import commands
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 60
_ENDINGS = (".sh", ".bash", ".zsh")
_FUNCTION = pattern(
    r"^[ \t]*(?:function[ \t]+)?([A-Za-z][\w-]*)[ \t]*\(\)[ \t]*\{\s*([^{}\s][^{}\n]{0,299})(?:\n\s*)?\}", re.MULTILINE
)
"""A function of one command: ``record() { ros2 run recorder record "$@"; }``."""
_ALIAS = pattern(r"^[ \t]*alias[ \t]+([A-Za-z][\w-]*)=(['\"])([^'\"\n]{1,300})\2[ \t]*$", re.MULTILINE)
_GIVEN = pattern(r"\s+\"?\$(?:@|\*|\{@\})\"?$")
"""All that a function is given."""
_STARTS = frozenset({"ros2 run", "ros2 launch", "rosrun", "roslaunch"})
_PLAIN = pattern(r"[\w./:=+,@-]+")


def functions(repository: Repository) -> dict[str, str]:
    """Return the names that start a program of ROS with all that they are given, each with that command."""
    found: dict[str, str] = {}
    files = [each for each in repository.suffixed(*_ENDINGS) if each.size <= MAX_SIZE and not places.aside(each.path)]
    for file in files[:MAX_FILES]:
        for name, line in _defined(repository.read(file)):
            found.setdefault(name, line)
    return found


def _defined(text: str) -> Iterator[tuple[str, str]]:
    """Yield the names that a script gives to a command, each with it; what fills in more than it is given is none."""
    for name, body in _FUNCTION.findall(text):
        line = body.strip().removesuffix(";").rstrip()
        if (given := _GIVEN.sub("", line)) != line and _starts(given):
            yield name, given
    for name, _, line in _ALIAS.findall(text):
        if _starts(line):
            yield name, line


def _starts(line: str) -> bool:
    found = list(commands(line, 1))
    words = found[0].words if len(found) == 1 else ()
    called = " ".join(words[: 1 + (words[:1] == ("ros2",))])
    return called in _STARTS and all(map(_PLAIN.fullmatch, words)) and " ".join(words) == " ".join(line.split())


def meant(mentions: Iterable[Mention], named: dict[str, str]) -> Iterator[Mention]:
    """Yield calls of such names as what they start."""
    for mention in mentions:
        name, _, given = mention.value.partition(" ")
        yield replace(mention, value=f"{named[name]} {given}".strip())
