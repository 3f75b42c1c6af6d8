"""Paths of a container, as those of the tree: ``docker run -v $(pwd):/app IMAGE python /app/train.py``.

https://docs.docker.com/engine/storage/bind-mounts/, read 2026-11-28
"""

from __future__ import annotations

import itertools
import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence.lex.shell import UNKNOWN
from roslab.values.pattern import pattern

_VOLUME = frozenset({"-v", "--volume"})
_WORKDIR = frozenset({"-w", "--workdir"})
_HERE = frozenset({UNKNOWN, ".", "./", "$PWD", "${PWD}", "$(pwd)", "`pwd`"})
"""The folder where the page's reader stands, as a shell may write it or no reader of it knows."""
_OPTION = pattern(r"(?:^|,)(source|src|target|destination|dst)=([^,]+)")
_PROGRAM = 3
"""Most words of a command that tell its program: the last may be the line of a shell."""
_SCRIPT = pattern(r"[\w.+-][\w.+/-]*\.(?:py|sh|bash)")


def of_tree(options: tuple[str, ...], words: tuple[str, ...]) -> tuple[str, ...]:
    """Return what a container starts, with the paths below the mounted folder as those of the tree.

    ``options``: what stands before the image's name. A script that is started in a folder of it is that folder's.
    """
    folders = tuple(_values(options, _WORKDIR))
    mounts = tuple(mount for mount in _mounts(options) if _holds(mount, (*words[:_PROGRAM], *folders)))
    if not mounts:
        return words
    found = [_below(word, mounts) for word in words]
    inside = next((_below(folder, mounts) for folder in folders), "")
    if inside and not inside.startswith("/") and inside != ".":
        index = next((n for n, word in enumerate(found[:2]) if _SCRIPT.fullmatch(word) and word == words[n]), None)
        if index is not None:
            found[index] = posixpath.join(inside, found[index])
    return tuple(found)


def _mounts(options: tuple[str, ...]) -> Iterator[str]:
    """Yield where the folder of the page is in the container."""
    for value in _values(options, _VOLUME):
        source, _, rest = value.partition(":")
        if source in _HERE and rest.startswith("/"):
            yield rest.partition(":")[0].rstrip("/")
    for value in _values(options, frozenset({"--mount"})):
        said = dict(_OPTION.findall(value))
        source = said.get("source") or said.get("src") or ""
        target = said.get("target") or said.get("destination") or said.get("dst") or ""
        if source in _HERE and target.startswith("/"):
            yield target.rstrip("/")


def _holds(mount: str, words: Iterable[str]) -> bool:
    """Tell whether the program or its folder is in a mount: another unknown folder is the reader's, as of data."""
    return any(f"{mount}/" in f"{word}/" for word in words)


def _values(options: tuple[str, ...], names: frozenset[str]) -> Iterator[str]:
    for before, word in itertools.pairwise(options):
        if before in names:
            yield word
    yield from (word.partition("=")[2] for word in options if word.partition("=")[0] in names and "=" in word)


def _below(word: str, mounts: tuple[str, ...]) -> str:
    """Return a word with every path below a mount as one of the tree: also one behind ``--config=``, or in a script."""
    for mount in filter(None, mounts):
        if word.rstrip("/") == mount:
            return "."
        word = re.sub(rf"(?<![\w./-]){re.escape(mount)}/", "", word)
    return word
