"""Programs of the system that Python code calls: ``os.system("wget …; unzip …")``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.python.modules import Module, modules
from roslab.knowledge.compiled import programs
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_CALLS = frozenset({"system", "popen", "subprocess"})
_LINE = pattern(
    r"^[^#\n]{0,200}?\b(?:os\.(?:system|popen)|(?:subprocess|sp)\.\w{1,20})\(\s{0,40}(?P<list>\[\s{0,40})?[rfu]{0,2}"
    r"(?P<quote>[\"'])(?P<said>[^\"'\n]{1,400})",
    re.MULTILINE,
)
_NEXT = pattern(r"\s*(?:;|&&|\|\|?)\s*")
_PYTHON = pattern(r"python[\d.]*$")
"""The Python that runs the code is there."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of the programs that the tree's Python files call by a name which they write out, each once.

    Tests are left out, and what a variable or a path names: nobody knows its package.
    """
    found: dict[str, Dependency] = {}
    for module in modules(repository):
        if not _CALLS.isdisjoint(module.words) and not places.test(module.file.path):
            for each in _called(module):
                found.setdefault(each.name, each)
    return tuple(found.values())


def _called(module: Module) -> Iterator[Dependency]:
    text = module.text
    for match in _LINE.finditer(text):
        parts = [match["said"]] if match["list"] else _NEXT.split(match["said"])
        for words in map(str.split, parts):
            called = words[1:] if words[:1] == ["sudo"] else words
            name = programs().get(called[0]) if called and not _PYTHON.match(called[0]) else None
            if name:
                line = text.count("\n", 0, match.start("said")) + 1
                yield Dependency(
                    namespace="apt", name=name, strength="used", file=module.file.path, line=line, role="called"
                )
