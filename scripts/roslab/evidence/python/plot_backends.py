"""Libraries of windows that matplotlib imports because code names them: ``matplotlib.use("GTK3Agg")``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.python.loggers import conditional
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


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return what the backends import that code names without a condition, each once; none of a test."""
    found: dict[str, Dependency] = {}
    for module in modules(repository):
        if "matplotlib" in module.text and not places.test(module.file.path):
            for each in _named(module):
                found.setdefault(each.name, each)
    return tuple(found.values())


def _named(module: Module) -> Iterator[Dependency]:
    text, file = module.text, module.file.path
    for match in _NAMED.finditer(text):
        backend = plot_backends().get(match[1].lower())
        if backend is None or conditional(text, match.start()):
            continue
        line = text.count("\n", 0, match.start(1)) + 1
        yield Dependency(namespace="import", name=backend.module, strength="used", file=file, line=line)
        for name in backend.apt:
            yield Dependency(namespace="apt", name=name, strength="used", file=file, line=line, role="backend")
