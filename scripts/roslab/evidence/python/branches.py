"""Lines of Python that run beside some versions of a library alone: they tell nothing about the others."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from roslab.evidence.python.parsed import parsed
from roslab.values.pattern import pattern

_OF_RELEASES = pattern(r"(?:\w+_)?(?:MAJOR|MINOR)|(?i:(?:parse|loose|strict|digit)_?version)|__version__")
"""Names that tests of a version are written with."""
_VERSION = pattern(r"_?(?:ver(?:sion)?(?:_\w+)?|major|minor)", re.IGNORECASE)
"""What follows the name of a library there: ``TORCH_VERSION``, ``np_major``."""
_PARTS = ("ver", "major", "minor")
"""One of them stands in each of these."""
_MISSED = frozenset({"AttributeError", "ImportError", "ModuleNotFoundError"})
_BODIES = ("body", "orelse", "finalbody")
_TELLS = pattern(r"print|exit|quit|sys\.exit|os\._exit|warnings\.warn|rospy\.log\w*|(?:traceback|log\w*)\.\w+")


def of_some_versions(text: str, position: int) -> bool:
    """Tell whether a position lies in a branch that tests a version, or in a ``try`` whose ``except`` has another way.

    An ``except`` that only stops or is silent is no other way. Code that Python 3 cannot read has no branches.
    """
    line = text.count("\n", 0, position) + 1
    read = _read(text)
    if any(first <= line <= last for first, last in read.branches):
        return True
    around = [each for each in read.statements if each.lineno <= line <= (each.end_lineno or each.lineno)]
    within = min(around, key=lambda each: (each.end_lineno or each.lineno) - each.lineno, default=None)
    chosen = (node for node in ast.walk(within) if isinstance(node, ast.IfExp)) if within else ()
    return any(_tests(each.test, read.libraries) for each in chosen if _span([each])[0] <= line <= _span([each])[1])


def in_docstring(text: str, position: int) -> bool:
    """Tell whether a position lies in a string that is a statement by itself; code of Python 2 has none."""
    line = text.count("\n", 0, position) + 1
    alone = (each for each in _read(text).statements if isinstance(each, ast.Expr))
    strings = (each for each in alone if isinstance(each.value, ast.Constant) and isinstance(each.value.value, str))
    return any(each.lineno <= line <= (each.end_lineno or each.lineno) for each in strings)


class _Read(NamedTuple):
    """What of a file tells its branches: its statements alone are walked, expressions are ten times as many."""

    statements: tuple[ast.stmt, ...] = ()
    libraries: frozenset[str] = frozenset()
    branches: tuple[tuple[int, int], ...] = ()
    """The first and the last line of each."""


@lru_cache(maxsize=1)
def _read(text: str) -> _Read:
    tree = parsed(text)
    if tree is None:
        return _Read()
    statements = tuple(_statements(tree.body))
    libraries = frozenset(name.lower() for each in statements for name in _imported(each))
    return _Read(statements, libraries, tuple(span for each in statements for span in _of(each, libraries)))


def _statements(body: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield statements with those inside of them."""
    open_ = [body]
    while open_:
        for each in open_.pop():
            yield each
            parts = (each, *getattr(each, "handlers", ()), *getattr(each, "cases", ()))
            open_ += [inside for part in parts for name in _BODIES if (inside := getattr(part, name, None))]


def _imported(node: ast.stmt) -> Iterator[str]:
    """Yield the names that code has for the modules of a statement: ``np``, ``torch``."""
    if isinstance(node, ast.Import):
        yield from (name.asname or name.name.partition(".")[0] for name in node.names)
    elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
        yield node.module.partition(".")[0]


def _of(node: ast.stmt, libraries: Collection[str]) -> Iterator[tuple[int, int]]:
    if isinstance(node, ast.If) and _tests(node.test, libraries):
        yield from (_span(part) for part in (node.body, node.orelse) if part)
    elif isinstance(node, ast.Try):
        ways = [handler.body for handler in node.handlers if _missing(handler, node)]
        yield from map(_span, ways)
        if any(not _stops(way[0]) for way in ways):
            yield _span(node.body)


def _span(nodes: Sequence[ast.stmt | ast.expr]) -> tuple[int, int]:
    return nodes[0].lineno, nodes[-1].end_lineno or nodes[-1].lineno


def _tests(test: ast.expr, libraries: Collection[str]) -> bool:
    """Tell whether a condition is about the version of a library, or about what some versions of it have."""
    for node in ast.walk(test):
        name = node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""
        if _OF_RELEASES.fullmatch(name) or _of_library(name, libraries):
            return True
        if isinstance(node, ast.Call):
            called = _dotted(node.func)
            if called == "version.parse":
                return True
            asked = node.args[:1] if called == "hasattr" else ()
            if any(ast.unparse(each).partition(".")[0].lower() in libraries for each in asked):
                return True
    return False


def _dotted(node: ast.expr) -> str:
    """Return a name, or one with what is asked of it (``version.parse``); to write out any other takes long."""
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        return f"{node.value.id}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else ""


def _of_library(name: str, libraries: Collection[str]) -> bool:
    lowered = name.lower()
    if not any(part in lowered for part in _PARTS):
        return False
    return any(lowered.startswith(each) and _VERSION.fullmatch(name, len(each)) for each in libraries)


def _missing(handler: ast.ExceptHandler, tried: ast.Try) -> bool:
    """Tell whether an ``except`` is for what is not there; one of all is, where its ``try`` imports."""
    if handler.type is None:
        return any(isinstance(node, (ast.Import, ast.ImportFrom)) for each in tried.body for node in ast.walk(each))
    return any(isinstance(node, ast.Name) and node.id in _MISSED for node in ast.walk(handler.type))


def _stops(statement: ast.stmt) -> bool:
    """Tell whether a statement stops, is silent or only tells of it."""
    if isinstance(statement, ast.Return):
        return statement.value is None or not any(isinstance(node, ast.Name) for node in ast.walk(statement.value))
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call):
        return _TELLS.fullmatch(ast.unparse(statement.value.func)) is not None
    return isinstance(statement, (ast.Raise, ast.Pass, ast.Continue, ast.Break))
