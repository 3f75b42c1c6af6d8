"""Loggers that code makes without a condition: their package must be there, though another module imports it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.indents import conditional
from roslab.evidence.python.modules import Module, modules
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the modules of the loggers, each once, at the first place that makes one; none of a test."""
    found: dict[str, Dependency] = {}
    for module in modules(repository):
        if not places.test(module.file.path):
            for each in _made(module):
                found.setdefault(each.name, each)
    return tuple(found.values())


def _made(module: Module) -> Iterator[Dependency]:
    for row in rows("logger_calls"):
        call, text = row["call"], module.text
        if call not in text:
            continue
        libraries = "|".join(row["libraries"].split())
        listed = rf"(?:[^\n(]{{0,300}}|\([^)]{{0,1000}})\b{re.escape(call)}\b"
        named = rf"from[ \t]+(?:{libraries})\b[\w.]*[ \t]+import[ \t]+{listed}"
        imported = rf"import[ \t]+(?:{libraries})\b" if "." in call else named
        if not re.search(rf"^[ \t]*{imported}", text, re.MULTILINE):
            continue
        for match in re.finditer(rf"^[ \t]*(?:[\w.]+[ \t]*=[ \t]*)?{re.escape(call)}\(", text, re.MULTILINE):
            if not conditional(text, match.start()):
                line = text.count("\n", 0, match.start()) + 1
                yield Dependency(
                    namespace="import", name=row["module"], strength="used", file=module.file.path, line=line
                )
                break
