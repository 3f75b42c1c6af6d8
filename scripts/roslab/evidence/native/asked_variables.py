"""Variables that a program demands: ``getenv("DEMO")``, and ``"Please set DEMO to the root of demo"`` below it.

And those that the root's CMake demands: ``if(NOT DEFINED ENV{SDK_DIR})`` around a ``message(FATAL_ERROR …)``; those
of any CMake where the tree has the folder, with the library that ``find_library`` looks for in ``$ENV{SDK_DIR}/lib``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import File, Repository
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

HERE = "./"
"""The repository's folder, as the value of a variable."""
NEAR = 400
"""Characters in which the demand follows."""
_SUFFIXES = (".cpp", ".cc", ".cxx", ".c")
_READ = pattern(r"\bgetenv\(\s*\"([A-Z][A-Z0-9_]{2,40})\"\s*\)")
_TEXT = pattern(r"\"([^\"\n]{1,200})\"")
_DEMANDS = pattern(r"(?i)\b(?:please|must|needs?|ha(?:s|ve) to|should)\b.*\b(?:set|defined?|export)\b")
_ROOT = pattern(
    r"(?i)\b(?:root|top)(?:[ -]level)?(?: (?:dir(?:ectory)?|folder|path))? of (?:the |your |this )?([\w-]+)"
)
_UNSET = pattern(r"NOT DEFINED ENV\{([A-Za-z]\w+)\}")
_OTHERWISE = pattern(r"NOT \(?DEFINED ENV\{([A-Za-z]\w+)\}\)?")
"""The same, or the last branch behind one for the variable."""
_THIS = frozenset({"repository", "repo", "project", "source", "sources", "checkout"})


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield ``NAME=./`` for each that is to name the repository's root, for others their name alone."""
    projects = tuple(projects)
    own = {*_THIS, bare_name(repository.name), *(bare_name(p.name) for p in projects if p.name)}
    told: set[str] = set()
    for project in projects:
        text = repository.read(project.file) if not places.aside(project.file) else ""
        held = {each.value.partition("=")[0]: each for each in _held(repository, text, project.file)}
        yield from held.values()
        if "/" not in project.file:
            yield from (each for each in _by_cmake(text, project.file) if each.value not in held)
    for file in repository.suffixed(*_SUFFIXES):
        text = "" if places.aside(file.path) else repository.read(file)
        for name, demand, line in _demanded(text) if "getenv" in text else ():
            if name not in told:
                told.add(name)
                root = _ROOT.search(demand)
                yield _mention(file, line, name, demand, here=root is not None and bare_name(root[1]) in own)


def stops(found: Iterable[Call], unset: re.Pattern[str]) -> Iterator[tuple[str, Call]]:
    """Yield each ``message(FATAL_ERROR …)`` that waits for nothing but a variable, with its name."""
    for call in found:
        match = unset.fullmatch(call.conditions[0]) if len(call.conditions) == 1 else None
        if match and call.words[:1] == ("FATAL_ERROR",) and not call.in_function:
            yield match[1], call


def said(call: Call) -> str:
    """Return what such a message says."""
    return " ".join(call.words[1:])


def _by_cmake(text: str, file: str) -> Iterator[Mention]:
    found = calls(text, frozenset({"message"})) if "ENV{" in text else ()
    for name, call in stops(found, _UNSET):
        yield Mention(topic="demanded", value=name, source="code", file=file, line=call.line, text=said(call))


def _held(repository: Repository, text: str, file: str) -> Iterator[Mention]:
    """Yield ``NAME=./FOLDER`` for each that CMake stops without, where one folder of the tree has its library."""
    found = list(calls(text, frozenset({"message", "find_library"}))) if "ENV{" in text else []
    for name, call in stops(found, _OTHERWISE):
        folders = {each for other in found for each in _with_library(repository, other, f"$ENV{{{name}}}/")}
        for folder in folders if len(folders) == 1 else ():
            value = f"{name}={HERE}{folder}"
            yield Mention(topic="variable", value=value, source="code", file=file, line=call.line, text=said(call))


def _with_library(repository: Repository, call: Call, start: str) -> Iterator[str]:
    """Yield the folders of the tree with a library where a call looks for it below one: ``lib/libsdk.so``."""
    below = [f"/{word.removeprefix(start)}" for word in call.words if word.startswith(start)]
    names = [name for word in call.words[1:] for name in (f"lib{word}.so", f"lib{word}.a")] if below else []
    for file in repository.named(*names):
        yield from (file.folder.removesuffix(end) for end in below if file.folder.endswith(end))


def _demanded(text: str) -> Iterator[tuple[str, str, int]]:
    for match in _READ.finditer(text):
        below = (each[1] for each in _TEXT.finditer(text[match.end() : match.end() + NEAR]))
        demand = next((each for each in below if match[1] in each and _DEMANDS.search(each)), "")
        if demand:
            yield match[1], demand, text.count("\n", 0, match.start()) + 1


def _mention(file: File, line: int, name: str, demand: str, *, here: bool) -> Mention:
    value = f"{name}={HERE}" if here else name
    topic: Literal["variable", "demanded"] = "variable" if here else "demanded"
    return Mention(topic=topic, value=value, source="code", file=file.path, line=line, text=demand)
