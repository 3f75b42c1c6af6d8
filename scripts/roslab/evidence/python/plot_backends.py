"""Libraries of windows that matplotlib imports because code names them: ``matplotlib.use("GTK3Agg")``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.indents import conditional, depth
from roslab.evidence.python.modules import Module, modules
from roslab.knowledge.plot_backends import plot_backends
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_NAMED = pattern(
    r"^[ \t]*(?:(?:matplotlib|mpl|plt|pyplot)\.(?:use|switch_backend)\([ \t]*(?:backend[ \t]*=[ \t]*)?|"
    r"os\.environ\[[\"']MPLBACKEND[\"']\][ \t]*=[ \t]*|"
    r"os\.environ\.setdefault\([\"']MPLBACKEND[\"'][ \t]*,[ \t]*|"
    r"(?:matplotlib|mpl|plt|pyplot)\.rcParams\[[\"']backend[\"']\][ \t]*=[ \t]*)[\"'](\w+)[\"']",
    re.MULTILINE,
)
"""https://matplotlib.org/stable/users/explain/figure/backends.html, 2026-11-27"""
_DEFINED = pattern(r"[ \t]{0,99}(?:async )?def (\w{1,99})")
_BEGIN = frozenset({"main", "__init__"})


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return what the backends import that code names without a condition, each once; none of a test.

    A function that nothing in the tree names never runs.
    """
    found: dict[str, Dependency] = {}
    every = tuple(modules(repository))
    for module in every:
        if "matplotlib" in module.text and not places.test(module.file.path):
            for each in _named(module, every):
                found.setdefault(each.name, each)
    return tuple(found.values())


def _named(module: Module, others: tuple[Module, ...]) -> Iterator[Dependency]:
    text, file = module.text, module.file.path
    for match in _NAMED.finditer(text):
        backend = plot_backends().get(match[1].lower())
        if backend is None or conditional(text, match.start()) or uncalled(module, match.start(), others):
            continue
        line = text.count("\n", 0, match.start(1)) + 1
        yield Dependency(namespace="import", name=backend.module, strength="used", file=file, line=line)
        for name in backend.apt:
            yield Dependency(namespace="apt", name=name, strength="used", file=file, line=line, role="backend")


def uncalled(module: Module, start: int, others: tuple[Module, ...]) -> bool:
    """Tell whether a line is in a function that nothing names, but for those with which programs and objects begin."""
    text = module.text
    least = depth(text, start)
    for line in reversed(text[:start].split("\n")[:-1]):
        if not least:
            return False
        if not line.strip() or depth(line) >= least:
            continue
        least = depth(line)
        if found := _DEFINED.match(line):
            if found[1] in _BEGIN:
                return False
            name, own = re.escape(found[1]), re.escape(module.file.path.rpartition("/")[2].removesuffix(".py"))
            called = re.compile(rf"(?:(?<![\w.])|\b(?:self|cls|{own})\.){name}\b(?<!def {name})")
            return not any(called.search(each.text) for each in others if found[1] in each.text)
    return False
