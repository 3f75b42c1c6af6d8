"""What a script that a page starts on the host starts in a container: ``./in_container.sh make demo``."""

from __future__ import annotations

import posixpath
import re
import shlex

from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import commands, logical_lines
from roslab.evidence.prose.in_containers import inside, is_program
from roslab.evidence.prose.shells import MAX_SIZE, starts_container
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

_GIVEN = pattern(r"\"?\$@\"?[ \t]*$")
_PLAIN = pattern(r"[\w./:=+,-]+")
_ENDS = pattern(r"[\s#}']|(?:fi|done|esac)\b")
"""How a line begins that is inside of something, or ends it."""


def in_container(mention: Mention, repository: Repository) -> Mention | None:
    """Return a command as what it starts in a container; with an empty value where nobody knows what that is.

    ``None`` if its script starts no container, itself or by the script that it ends with.
    """
    words = mention.value.split()
    script = next((word for word in words[:2] if word in mention.files and word.endswith(SHELL_SCRIPTS)), "")
    started = _started(repository, script, tuple(words[words.index(script) + 1 :])) if script else None
    return None if started is None else replace(mention, value=" ".join(started), files=())


def _started(
    repository: Repository, script: str, given: tuple[str, ...], *, further: bool = True
) -> tuple[str, ...] | None:
    text = repository.read(script, limit=MAX_SIZE)
    lines = [line for _, line in logical_lines(text, 1) if line.strip() and not _ENDS.match(line)]
    if starts_container(text):
        line = next(filter(starts_container, lines), "")
        if _GIVEN.search(line) and given:
            return _handed(repository, given)
        found = [each.words for command in commands(line, 1) for each in inside(command)] if line else []
        return found[0] if found and not any(map(_on_host, lines)) else ()
    last = _words(lines[-1]) if further and lines and not any(map(_on_host, lines[:-1])) else ()
    last = last[1:] if last[:1] == ("exec",) else last
    named = [
        file.path for file in repository.suffixed(*SHELL_SCRIPTS) if last and file.name == posixpath.basename(last[0])
    ]
    if len(named) != 1 or named[0] == script or not starts_container(repository.read(named[0], limit=MAX_SIZE)):
        return None
    return _started(repository, named[0], last[1:], further=False)


def _on_host(line: str) -> bool:
    return any(is_program(command.words) for command in commands(line, 1))


def _words(text: str) -> tuple[str, ...]:
    try:
        return tuple(shlex.split(text))
    except ValueError:
        return ()


def _handed(repository: Repository, words: tuple[str, ...]) -> tuple[str, ...]:
    """Return what the words that a script hands to its container start there, none where that is not known."""
    if _script(repository, words):
        return ("bash", *words)
    return words if _known(repository, words) else ()


def _script(repository: Repository, words: tuple[str, ...]) -> bool:
    """Tell whether words start a script of the tree, as a shell does that is the image's entry point."""
    inside = words[0].endswith(SHELL_SCRIPTS) and repository.has(words[0]) and all(map(_PLAIN.fullmatch, words))
    return inside and not starts_container(repository.read(words[0], limit=MAX_SIZE))


def _known(repository: Repository, words: tuple[str, ...]) -> bool:
    """Tell whether words start something with Python or ROS, or name a target of the Makefile at the root."""
    if not all(map(_PLAIN.fullmatch, words)):
        return False
    if words[0] != "make":
        return is_program(words)
    made = repository.read("Makefile", limit=MAX_SIZE) if repository.has("Makefile") else ""
    return len(words) == 2 and bool(re.search(rf"(?m)^{re.escape(words[1])}[ \t]*:(?!=)", made))
