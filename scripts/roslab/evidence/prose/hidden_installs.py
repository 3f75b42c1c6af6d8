"""Whether a Dockerfile may install more than what apt and pip are asked for in its own lines says."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, logical_lines
from roslab.values.pattern import pattern

_PIP = pattern(r"pip[\d.]*")
_PYTHON = pattern(r"python[\d.]*")
"""Options of RUN."""
_BRINGS_NOTHING = frozenset(
    (
        *(
            "apt-get",
            "apt",
            "add-apt-repository",
            "apt-key",
            "curl",
            "wget",
            "gpg",
            "locale-gen",
            "update-alternatives",
        ),
        *("rm", "mkdir", "cd", "ls", "pwd", "touch", "chmod", "chown", "echo", "printf", "tee", "sed", "true", ":"),
        *("export", "set", "test", "useradd", "usermod", "groupadd", "adduser", "ldconfig", "sleep"),
    )
)
"""Programs that bring no module of Python, but for what is read of the lines of apt."""
_ARCHIVES = (".whl", ".gz", ".zip", ".deb", ".tar")


def hides(written: Iterable[Instruction]) -> bool:
    """Tell whether it may: only a few programs are known not to, and pip with what is written out."""
    texts = (each.steps for each in written if each.name == "RUN")
    lines = (line for text in texts for _, line in logical_lines(text))
    return any(not _known(command) for line in lines for command in commands(line))


def _known(command: Command) -> bool:
    program, *words = command.words
    if _PYTHON.fullmatch(program) and words[:1] == ["-m"]:
        program, *words = words[1:] or [""]
    if _PIP.fullmatch(program):
        return not any(word.endswith(_ARCHIVES) or any(mark in word for mark in f"{UNKNOWN}$`*[") for word in words)
    return program in _BRINGS_NOTHING and not (program.startswith("apt") and any(map(_unread, words)))


def _unread(word: str) -> bool:
    return word.endswith(".deb") or UNKNOWN in word or "$" in word
