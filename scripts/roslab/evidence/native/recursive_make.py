"""Makefiles that only call make in folders below: ``cd lib && make all``, ``make -C lib``, a loop over folders.

https://www.gnu.org/software/make/manual/html_node/Recursion.html, read 2026-11-27
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterable, Iterator
from itertools import islice

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

NAMES = ("GNUmakefile", "makefile", "Makefile")
MAX_SIZE = 64 * 1024
MOST = 60
"""Most Makefiles that are read for one."""
_MAKE = r"(?:g?make|\$[({]MAKE[)}])"
_FOLDER = r"([\w./-]{1,100}|\$\$?[({]?\w+[)}]?)"
_CALLS = (
    pattern(rf"^\t[^#\n]{{0,200}}\bcd\s+{_FOLDER}\s*(?:&&|;)\s*{_MAKE}(?=[\s;)]|$)", re.MULTILINE),
    pattern(rf"^\t[^#\n]{{0,200}}{_MAKE}\s(?:[^\n;&|]{{0,100}}\s)?-C\s*{_FOLDER}", re.MULTILINE),
    pattern(rf"^\t[^#\n]{{0,200}}{_MAKE}\s(?:[^\n;&|]{{0,100}}\s)?--directory[= ]\s*{_FOLDER}", re.MULTILINE),
)
_LOOP = pattern(r"\bfor\s+(\w+)\s+in\s+([^;\n]{1,400});")
_SET = pattern(r"^(\w+)\s*[:?+]?=\s*([\w./ -]{1,400})$", re.MULTILINE)
_VARIABLE = pattern(r"\$\$?[({]?(\w+)[)}]?")
_TARGET = pattern(r"[A-Za-z][\w-]*")
_NO_BUILD = frozenset(
    (
        *(
            "clean",
            "distclean",
            "cleanall",
            "mrproper",
            "install",
            "uninstall",
            "test",
            "tests",
            "check",
            "run",
            "help",
        ),
        *("sim", "start", "stop", "serve", "launch", "flash", "upload", "monitor", "watch", "deploy"),
        *("doc", "docs", "format", "lint", "package", "deb", "debug", "dist", "docker", "depend", "menuconfig"),
    )
)
"""Targets that a page calls for something else than to compile."""


def called(text: str) -> tuple[str, ...]:
    """Return the folders, relative to its own, in which a Makefile calls make, in their order."""
    text = text.replace("\\\n", " ")
    known = {name: value.split() for name, value in _SET.findall(text)}
    for name, words in _LOOP.findall(text):
        meant = dict.fromkeys(each for word in words.split() for each in _meant(word, known))
        known[name] = [*islice(meant, MOST)]
    found = (folder for pattern_ in _CALLS for match in pattern_.finditer(text) for folder in _meant(match[1], known))
    return tuple(dict.fromkeys(posixpath.normpath(folder) for folder in found))


def _meant(word: str, known: dict[str, list[str]]) -> list[str]:
    """Return what a word stands for; a rule for each folder, ``$@`` of ``$(FOLDERS):``, is none."""
    match = _VARIABLE.fullmatch(word)
    return known.get(match[1], []) if match else [] if "$" in word else [word]


def below(text: str, folder: str, repository: Repository, skip: Callable[[str, str], bool]) -> list[tuple[str, str]]:
    """Return the folder and the text of each Makefile that a Makefile calls, and of those that these call.

    ``skip``: whether one of this path with this text is passed over, with all that it calls.
    """
    found: dict[str, str] = {}
    left = [(folder, text)]
    while left and len(found) < MOST:
        above, written = left.pop(0)
        for name in called(written):
            there = posixpath.normpath(posixpath.join(above, name))
            path = next((p for each in NAMES if repository.has(p := posixpath.join(there, each))), None)
            if path is None or there in found or there == folder:
                continue
            inside = repository.read(path, limit=MAX_SIZE)
            if not skip(path, inside):
                found[there] = inside
                left.append((there, inside))
    return list(found.items())


def told(mentions: Iterable[Mention], folders: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield each of the folders in which a page calls make to compile, with the first target that it names there."""
    calls = [m.value.split() for m in mentions if m.topic == "make" and m.source == "readme"]
    for folder in folders:
        for place, *words in calls:
            targets = compiled_targets(words)
            if targets is not None and (place == folder or (folder and f"/{place}".endswith(f"/{folder}"))):
                yield folder, " ".join(targets)
                break


def compiled_targets(words: Iterable[str]) -> list[str] | None:
    """Return the targets of a call of make that compiles, ``None`` for a call for something else, or with options."""
    targets = list(words)
    plain = all(map(_TARGET.fullmatch, targets)) and _NO_BUILD.isdisjoint(targets)
    return targets if plain else None
