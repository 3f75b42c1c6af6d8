"""Programs of the system that Python code, a setup.py too, calls: ``os.system("wget …; unzip …")``.

Also those that a library starts for it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.lines import matching_lines
from roslab.evidence.python import ros_tools
from roslab.evidence.python.in_comment import in_comment
from roslab.evidence.python.modules import Module, modules, setup_scripts
from roslab.knowledge.compiled import programs
from roslab.knowledge.program_calls import program_calls
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_CALLS = frozenset({"system", "popen", "subprocess"})
_BY_MODULE = ("os.system", "os.popen", "subprocess.", "sp.")
_BARE = frozenset({"check_output", "check_call", "Popen", "call", "run"})
_LINE = pattern(
    r"^[^#\n]{0,200}?\b(?:os\.(?:system|popen)|(?:subprocess|sp)\.\w{1,20}|"
    r"(?<![\w.])(?P<bare>check_output|check_call|Popen|call|run))\(\s{0,40}(?:args\s?=\s?)?(?P<list>[\[(]\s{0,40})?"
    r"[rfu]{0,2}(?P<quote>[\"'])(?P<said>[^\"'\n]{1,400})",
    re.MULTILINE,
)
_IMPORTED = pattern(r"^\s{0,40}from subprocess import ([^\n#]{1,200})", re.MULTILINE)
_WORD = pattern(r"\w+")
_NEXT = pattern(r"\s*(?:;|&&|\|\|?)\s*")
_PYTHON = pattern(r"python[\d.]*$")
"""The Python that runs the code is there."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of the programs that the tree's Python files call by a name which they write out, each once.

    Tests are left out, and what a variable or a path names: nobody knows its package. So it is with what they start
    of ROS in a tree without packages.
    """
    found: dict[str, Dependency] = {}
    for module in (*setup_scripts(repository), *modules(repository)):
        if not _CALLS.isdisjoint(module.words) and not places.test(module.file.path):
            for each in _called(module):
                found.setdefault(each.name, each)
    for module in modules(repository):
        for each in _by_libraries(module) if not places.test(module.file.path) else ():
            found.setdefault(each.name, each)
    return (*found.values(), *ros_tools.packages(repository))


def _by_libraries(module: Module) -> Iterator[Dependency]:
    """Yield the packages of the programs that libraries start for calls of a module."""
    for row in program_calls().possible(module.text, module.words):
        used = (m for m in row.pattern.finditer(module.text) if not in_comment(module.text, m.start()))
        if match := next(used, None):
            line = module.text.count("\n", 0, match.start()) + 1
            yield Dependency(
                namespace="apt", name=row.apt, strength="used", file=module.file.path, line=line, role="called"
            )


def _called(module: Module) -> Iterator[Dependency]:
    for called, line in programs_of(module):
        if name := programs().get(called):
            yield Dependency(
                namespace="apt", name=name, strength="used", file=module.file.path, line=line, role="called"
            )


def programs_of(module: Module) -> Iterator[tuple[str, int]]:
    """Yield the programs that a module calls by names which it writes out, each with its line; Python is none."""
    text = module.text
    lines = _IMPORTED.findall(text) if "from subprocess import" in text else ()
    imported = {name for line in lines for name in _WORD.findall(line)}
    for match in matching_lines(_LINE, text, *_BY_MODULE, *(f"{name}(" for name in _BARE & imported)):
        if match["bare"] and match["bare"] not in imported:
            continue
        parts = [match["said"]] if match["list"] else _NEXT.split(match["said"])
        for words in map(str.split, parts):
            called = words[1:] if words[:1] == ["sudo"] else words
            if called and not _PYTHON.match(called[0]):
                yield called[0], text.count("\n", 0, match.start("said")) + 1
