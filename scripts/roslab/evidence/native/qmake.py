"""Project files of qmake: the program that each makes, the modules of Qt that it asks for and what it links."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.makefile import Makefile
from roslab.evidence.native import compile_scripts
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_COMMENT = pattern(r"#[^\n]*")
_ELSEWHERE = pattern(r"\b(?:win32|windows|macx?|macos|android|ios)\b[^\n{}]{0,80}(?:\{[^{}]*\}|:[^\n]*)")
_SET = pattern(r"^[^\n=]{0,120}?\b(QT|TARGET|TEMPLATE)[ \t]*\+?=[ \t]*([^\n]*)", re.MULTILINE)
_INCLUDED = pattern(r"\binclude\(\s*([\w./-]{1,200}\.pri)\s*\)")
_NAME = pattern(r"[A-Za-z][\w-]*")
_USUAL = ("core", "gui")
"""https://doc.qt.io/qt-5/qmake-variable-reference.html#qt, read 2026-11-26."""


def read(repository: Repository) -> Iterator[Makefile]:
    """Yield the program of each project near the root; of several in one folder the first.

    https://doc.qt.io/qt-5/qmake-project-files.html, read 2026-11-26: without a template it is a program.
    """
    files: dict[str, File] = {}
    for file in repository.suffixed(".pro"):
        aside = places.vendored(file.path) or places.aside(file.path)
        if file.path.count("/") <= 1 and file.size <= MAX_SIZE and not aside:
            files.setdefault(file.folder, file)
    for file in files.values():
        text = _whole(file, repository)
        said: dict[str, list[str]] = {}
        for name, value in _SET.findall(text):
            said.setdefault(name, []).extend(value.split())
        template = said.get("TEMPLATE", ["app"])[-1]
        if template == "app" and ("SOURCES" in text or "HEADERS" in text):
            target = said.get("TARGET", [file.name.removesuffix(".pro")])[-1]
            yield Makefile(
                file=file.path,
                line=1,
                programs=(target,) if _NAME.fullmatch(target) else (),
                linked=compile_scripts.linked(text),
                cuda=False,
                qt=tuple(dict.fromkeys(filter(_NAME.fullmatch, (*_USUAL, *said.get("QT", ()))))),
            )


def _whole(file: File, repository: Repository) -> str:
    """Return the text of a project with what it includes from its folder, for Linux alone."""
    text = repository.read(file)
    for name in _INCLUDED.findall(_COMMENT.sub("", text)):
        path = posixpath.normpath(posixpath.join(file.folder, name))
        text += "\n" + (repository.read(path, limit=MAX_SIZE) if repository.has(path) else "")
    return _ELSEWHERE.sub("", _COMMENT.sub("", text).replace("\\\n", " "))
