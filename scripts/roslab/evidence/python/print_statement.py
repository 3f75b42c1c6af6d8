"""Code that only runs with Python 2: ``print`` as a statement, or modules that Python 3 calls otherwise."""

from __future__ import annotations

import re
from functools import cache

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import first_line
from roslab.evidence.python.modules import modules
from roslab.knowledge.standard_modules import of_python_2
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_STATEMENT = pattern(r"^[ \t]*print[ \t]+[\"'][^\n]*$", re.MULTILINE)
"""``print`` with a string after it, which prose in a docstring hardly ever has."""
_CALL = pattern(r"^[ \t]*print[ \t]*\(", re.MULTILINE)
LEAST = 2
"""Fewest modules; a single one is a leftover."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return Python 2, with the first place that shows it, if more modules use the statement than the function.

    So it is where several import what Python 3 does not have.
    """
    old: list[Mention] = []
    bound: list[Mention] = []
    new = 0
    for module in modules(repository):
        file, text = module.file, module.text
        if not of_python_2().isdisjoint(module.words) and (match := _import().search(text)):
            at = text.count("\n", 0, match.start()) + 1
            said = match[0].strip()[:60]
            bound.append(Mention(topic="python", value="2.7", source="code", file=file.path, line=at, text=said))
        if "print" not in module.words:
            continue
        if match := first_line(_STATEMENT, text, "print"):
            line = text.count("\n", 0, match.start()) + 1
            said = match[0].strip()[:60]
            old.append(Mention(topic="python", value="2.7", source="code", file=file.path, line=line, text=said))
        elif first_line(_CALL, text, "print"):
            new += 1
    if len(old) >= LEAST and len(old) > new:
        return (old[0],)
    return (bound[0],) if len(bound) >= LEAST else ()


@cache
def _import() -> re.Pattern[str]:
    """Return the pattern of an import that nothing catches, of a module of Python 2."""
    return pattern(rf"^(?:import|from)[ \t]+(?:{'|'.join(sorted(of_python_2()))})\b[^\n]*", re.MULTILINE)
