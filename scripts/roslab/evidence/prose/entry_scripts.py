"""What a script that an author's ENTRYPOINT names starts in the end: what it is given, or always the same program."""

from __future__ import annotations

import posixpath
import re
import shlex
from collections.abc import Iterable, Iterator

from roslab.evidence.entry_script import EntryScript, Taken
from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.prose.entry_defaults import PROGRAM, starts_alone
from roslab.evidence.prose.entry_folders import absent
from roslab.knowledge.machine_variables import of_every_image
from roslab.repository.checkout import File, Repository
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_SHELLS = frozenset({"bash", "sh", "dash"})
_SOURCES = frozenset({"source", "."})
_HANDED = pattern(r"\$(?:[@*#1-9]|\{[@*#1-9!])|\bBASH_ARGV\b|(?:^|[ \t;])(?:shift|getopts)\b", re.MULTILINE)
"""A script looks at what it was given."""
_STARTS_IT = pattern(
    r"(?m)^[ \t]*(?:exec[ \t]+(?:\S+[ \t]+)*?)?[\"']?\$(?:[@*]|\{[@*](?::?-[^}\n]{1,300})?\})[\"']?[ \t]*$"
)
_SHELL = pattern(r"(?:exec[ \t]+)?(?:/usr)?(?:/bin/)?(?:ba|z|da)?sh(?:[ \t]+-+[a-z-]+)*[ \t]*[;'\"]*$")
_CLOSES = frozenset({"fi", "done", "esac", "}", ";;", "else"})
_STOPS = pattern(r"(?m)^[ \t]*set[ \t]+-[a-z]*e|^#!\S*sh[ \t]+-[a-z]*e")
_READ = pattern(r"(?<!\\)\$(?:([A-Z][A-Z0-9_]{2,})\b|\{([A-Z][A-Z0-9_]{2,})(\}|[^}])?)")
_SET = pattern(r"(?:^|[;&|(\s])([A-Z][A-Z0-9_]{2,})\+?=|\b(?:read(?:[ \t]+-\w+)*|for)[ \t]+([A-Z][A-Z0-9_]{2,})\b")
_TESTED = pattern(r"\s-[nzv][ \t]+[\"']?\$?\{?([A-Z][A-Z0-9_]{2,})|\[\[?[ \t]+[\"']?\$\{?([A-Z][A-Z0-9_]{2,})")
_BY_SHELL = frozenset(
    {"EUID", "UID", "GROUPS", "RANDOM", "SECONDS", "LINENO", "OLDPWD", "IFS", "SHELL", "PPID", "HOSTTYPE", "OSTYPE"}
)
"""https://www.gnu.org/software/bash/manual/html_node/Bash-Variables.html, read 2026-11-27."""
_OF_ROS = pattern(r"/opt/ros/|/setup\.(?:ba|z)?sh\b|/local_setup\.(?:ba|z)?sh\b|\.bashrc\b|/bin/activate\b|conda\.sh\b")
_ENDS = pattern(r"(?m)^[ \t]*exec[ \t]+([^\n#$;|&]{1,300}?)[ \t]+\"?\$@\"?[ \t]*\Z")


def started_by(repository: Repository, entrypoint: tuple[str, ...]) -> tuple[str, ...]:
    """Return the words of the program that the script gives all arguments to, else the ENTRYPOINT as it is.

    The script is the only one of that name in the tree: the image may have it anywhere.
    """
    file = _script(repository, entrypoint)
    if file is None or not file.name.endswith(SHELL_SCRIPTS):
        return entrypoint
    found = _ENDS.search(repository.read(file).rstrip())
    if found is None:
        return entrypoint
    try:
        words = tuple(shlex.split(found[1]))
    except ValueError:
        return entrypoint
    return (words[1:] or entrypoint) if words[:1] == ("--",) else words  # the end of the options of exec itself


def entry_script(
    repository: Repository, entrypoint: tuple[str, ...], written: Iterable[Instruction], known: Iterable[str]
) -> EntryScript | None:
    """Return what the script that an ENTRYPOINT names does, ``None`` where it names none of the tree.

    ``written`` are the Dockerfile's instructions, of which none writes to the script; ``known`` are the variables that
    its last stage sets.
    """
    file, written = _script(repository, entrypoint), tuple(written)
    if file is None or any(each.name == "RUN" and _writes(each.text, file.name) for each in written):
        return None
    lines = [(number, _code(line)) for number, line in enumerate(repository.read(file).splitlines(), 1)]
    commands = [(number, line) for number, line in lines if line.strip() and line.strip() not in _CLOSES]
    if not commands:
        return None
    text = "\n".join(line for _, line in lines)
    takes: Taken = "commands" if _STARTS_IT.search(text) else "arguments" if _HANDED.search(text) else "nothing"
    ends, last = commands[-1]
    return EntryScript(
        file=file.path,
        line=ends,
        takes=takes,
        shell=bool(_SHELL.fullmatch(last.strip())) and not PROGRAM.search(text),
        alone=takes == "commands" and starts_alone([line for _, line in lines]),
        unset=tuple(_unset(lines, text, {*known})),
        absent=tuple(absent(repository, lines, written)),
        stops=bool(_STOPS.search(text)),
    )


def _script(repository: Repository, entrypoint: tuple[str, ...]) -> File | None:
    """Return the only file of the tree with the name of the script that is the last word."""
    script = next(
        (word for word in entrypoint if word.rpartition("/")[2] not in _SHELLS and not word.startswith("-")), ""
    )
    if not script or script != entrypoint[-1] or len(script.split()) != 1:
        return None
    named = [file for file in repository.named(posixpath.basename(script)) if file.name == posixpath.basename(script)]
    if len(named) != 1 or named[0].size > MAX_SIZE:
        return None
    shell = named[0].name.endswith(SHELL_SCRIPTS) or _is_shell(repository.read(named[0]))
    return named[0] if shell else None


def _is_shell(text: str) -> bool:
    first = text.partition("\n")[0].split()
    return text.startswith("#!") and any(word.rpartition("/")[2] in _SHELLS for word in (first[0][2:], *first[1:]))


def _writes(text: str, name: str) -> bool:
    return name in text and any(name in part for part in text.split(">")[1:])


def _code(line: str) -> str:
    """Return a line without its comment."""
    return "" if line.lstrip().startswith("#") else line


def _unset(lines: list[tuple[int, str]], text: str, known: set[str]) -> Iterator[tuple[str, int]]:
    """Yield each variable that is read and neither set, tested, nor of every container; none where others are read."""
    sourced = (line.split() for _, line in lines)
    if any(words and words[0] in _SOURCES and not _OF_ROS.search(" ".join(words)) for words in sourced):
        return
    found = (*_SET.finditer(text), *_TESTED.finditer(text))
    known = known | _BY_SHELL | {match[1] or match[2] for match in found}
    for number, line in lines:
        for match in _READ.finditer(line):
            name, after = match[1] or match[2], match[3] or "}"
            if after in {":", "-", "+", "?", "="}:
                known.add(name)
            elif name not in known and not of_every_image(name):
                known.add(name)
                yield name, number
