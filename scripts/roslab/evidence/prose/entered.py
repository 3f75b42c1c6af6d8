"""Environments of Python that commands make or enter: what is installed after one belongs to it."""

from __future__ import annotations

import itertools

from roslab.evidence.lex.shell import UNKNOWN
from roslab.evidence.python.install_lines import CONDA
from roslab.values.pattern import pattern

_SCRIPT = pattern(r"(?:^|/)([^/]+)/(?:bin|Scripts)/activate$")
_NAME = pattern(r"[\w.-]+")
_MAKERS = frozenset({"virtualenv", "mkvirtualenv", "workon"})
_NAMED = frozenset({"-n", "--name"})
_EVERYWHERE = frozenset({"", ".", "..", "base"})


def entered(words: tuple[str, ...]) -> str | None:
    """Return the name of the environment that a command makes or enters, ``None`` for every other command."""
    program = words[0].rpartition("/")[2]
    if program in {"source", "."} and (match := _SCRIPT.search(words[-1])):
        return _known(match[1])
    if program in CONDA or words[:2] == ("source", "activate"):
        return _of_conda(words)
    made = program in _MAKERS or words[1:3] == ("-m", "venv") or words[:2] == ("uv", "venv")
    return _known(words[-1].rstrip("/").rpartition("/")[2]) if made and len(words) > 1 else None


def _of_conda(words: tuple[str, ...]) -> str | None:
    if words[1:2] == ("activate",):
        return _known(words[-1])
    if "create" not in words[1:3]:
        return None
    glued = (word.partition("=")[2] for word in words if word.startswith("--name="))
    named = (value for flag, value in itertools.pairwise(words) if flag in _NAMED)
    return _known(next(itertools.chain(glued, named), ""))


def _known(name: str) -> str | None:
    return name if name not in _EVERYWHERE and UNKNOWN not in name and _NAME.fullmatch(name) else None
