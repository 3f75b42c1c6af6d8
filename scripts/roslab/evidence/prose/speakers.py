"""Scripts that a page runs and that only speak to what runs already: they publish, call services, and start nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex import shell
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS

MAX_SIZE = 64 * 1024
_SPEAK = frozenset({"topic", "service", "action", "param", "lifecycle", "node"})
"""Commands of ``ros2`` that speak to nodes: https://docs.ros.org/en/humble/Concepts/Basic/About-Command-Line-Tools.html
(2026-11-28); ``rostopic`` and its like in ROS 1."""
_SPEAKERS = frozenset({"rostopic", "rosservice", "rosparam", "rosnode"})
_STILL = frozenset(
    (
        *("echo", "printf", "sleep", "wait", "source", ".", "export", "set", "cd", "exit", "trap", "clear", "read"),
        *("if", "then", "else", "elif", "fi", "for", "while", "until", "do", "done", "case", "esac", "{", "}", "in"),
        *("[", "[[", "test", "true", "false", "local", "declare", "shift", "return", "seq", "let", "unset", ":"),
    )
)
"""Words of a shell by which no program of the repository starts."""


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each such script at the place of the command that runs it."""
    only: dict[str, bool] = {}
    for mention in mentions:
        script = next((file for file in mention.files if file.endswith(SHELL_SCRIPTS)), "")
        if mention.topic != "command" or mention.source != "readme" or not script:
            continue
        if script not in only:
            only[script] = _only_speaks(repository.read(script, limit=MAX_SIZE))
        if only[script]:
            yield replace(mention, topic="speaks", value=script, files=(), inside="")


def _only_speaks(text: str) -> bool:
    if not any(word in text for word in ("ros2 ", *_SPEAKERS)):
        return False
    speaks = False
    for line, logical in shell.logical_lines(text):
        for command in shell.commands(logical, line):
            first, *rest = command.words or ("",)
            if first in _SPEAKERS or (first == "ros2" and rest[:1] and rest[0] in _SPEAK):
                speaks = True
            elif first not in _STILL and first:
                return False
    return speaks
