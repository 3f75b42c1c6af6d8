"""Files that a text changes in place by ``sed``, perhaps of what it has cloned."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Iterator

from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.values.pattern import pattern

MAX_SIZE = 2_000
"""Most characters of a call."""
_EXPRESSION = frozenset({"-e", "--expression"})
_OPTION = pattern(r"-[Erzsn]+|--(?:regexp-extended|null-data|separate|quiet|silent)")
_IN_PLACE = pattern(r"(-[Ersz]*)i[\w.~]*|--in-place(?:=[\w.~]*)?")
"""Other letters may stand before ``i``, and after it is the ending of the file that keeps what was there."""
_FILE = pattern(r"[\w./+-]+")


def called(command: Command, folder: str) -> Iterator[str]:
    """Yield a call that changes files, as words, with the paths of these after ``--``: ``folder`` is where the text is.

    https://www.gnu.org/software/sed/manual/html_node/Command_002dLine-Options.html, 2026-11-28.
    """
    words = command.words
    if words[0] != "sed" or sum(map(len, words)) > MAX_SIZE or any(map(_unclear, words)):
        return
    options, scripts, files, in_place = [], [], [], False
    rest = iter(words[1:])
    for word in rest:
        if word in _EXPRESSION:
            scripts += ["--expression", next(rest, "")]
        elif word.startswith("--expression="):
            scripts.append(word)
        elif match := _IN_PLACE.fullmatch(word):
            in_place = True
            options += [match[1]] if len(match[1] or "") > 1 else []
        elif _OPTION.fullmatch(word):
            options.append(word)
        elif word.startswith("-"):
            return
        else:
            files.append(word)
    if not scripts:
        scripts, files = [f"--expression={files[0]}"] if files else [], files[1:]
    if in_place and scripts and files and all(map(_FILE.fullmatch, files)):
        there = [posixpath.normpath(posixpath.join(f"/{folder}", file)).strip("/") for file in files]
        yield shlex.join(("sed", "--in-place", *options, *scripts, "--", *there))


def _unclear(word: str) -> bool:
    """Tell whether only a running shell knows what a word is, or no line of a Dockerfile can hold it."""
    return UNKNOWN in word or not word.isprintable()
