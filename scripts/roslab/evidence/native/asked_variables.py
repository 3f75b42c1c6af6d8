"""Variables that a program demands: ``getenv("DEMO")``, and ``"Please set DEMO to the root of demo"`` below it.

And those that the root's CMake demands: ``if(NOT DEFINED ENV{SDK_DIR})`` around a ``message(FATAL_ERROR …)``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import calls
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
_THIS = frozenset({"repository", "repo", "project", "source", "sources", "checkout"})


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield ``NAME=./`` for each that is to name the repository's root, for others their name alone."""
    projects = tuple(projects)
    own = {*_THIS, bare_name(repository.name), *(bare_name(p.name) for p in projects if p.name)}
    told: set[str] = set()
    for project in projects:
        if "/" not in project.file:
            yield from _by_cmake(repository.read(project.file), project.file)
    for file in repository.suffixed(*_SUFFIXES):
        text = "" if places.aside(file.path) else repository.read(file)
        for name, said, line in _demanded(text) if "getenv" in text else ():
            if name not in told:
                told.add(name)
                root = _ROOT.search(said)
                yield _mention(file, line, name, said, here=root is not None and bare_name(root[1]) in own)


def _by_cmake(text: str, file: str) -> Iterator[Mention]:
    for call in calls(text, frozenset({"message"})) if "ENV{" in text else ():
        unset = _UNSET.fullmatch(call.conditions[0]) if len(call.conditions) == 1 else None
        if unset and call.words[:1] == ("FATAL_ERROR",) and not call.in_function:
            said = " ".join(call.words[1:])
            yield Mention(topic="demanded", value=unset[1], source="code", file=file, line=call.line, text=said)


def _demanded(text: str) -> Iterator[tuple[str, str, int]]:
    for match in _READ.finditer(text):
        below = (each[1] for each in _TEXT.finditer(text[match.end() : match.end() + NEAR]))
        said = next((each for each in below if match[1] in each and _DEMANDS.search(each)), "")
        if said:
            yield match[1], said, text.count("\n", 0, match.start()) + 1


def _mention(file: File, line: int, name: str, said: str, *, here: bool) -> Mention:
    value = f"{name}={HERE}" if here else name
    topic: Literal["variable", "demanded"] = "variable" if here else "demanded"
    return Mention(topic=topic, value=value, source="code", file=file.path, line=line, text=said)
