"""What a setup.py asks git for of the history of its repository: an image has none, and git fails there."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

_STOPS = frozenset({"subprocess.check_output", "subprocess.check_call", "check_output", "check_call"})
"""Calls that stop where their program fails; ``subprocess.run`` does so with ``check=True``.

https://docs.python.org/3/library/subprocess.html#subprocess.check_output, read 2026-11-27.
"""
_RUNS = _STOPS | {"subprocess.run", "run"}
_OF_COMMITS = frozenset({"describe", "log", "rev-list", "shortlog", "show", "HEAD"})
"""Words of a call of git that fails in a repository without a commit."""


def asked(tree: ast.Module) -> str:
    """Return the first call of git in a setup.py that always runs and stops without a commit, ``""`` for none.

    A call in a function counts where a line at the top calls that function, and neither stands in a ``try`` or below
    a condition.
    """
    callers = {node.name: words for node in _functions(tree) if (words := _always(node.body))}
    for statement in tree.body:
        if _guarded(statement):
            continue
        for call in _calls(statement):
            words = _words(call) if _git(call) else callers.get(ast.unparse(call.func), [])
            words = [*words, *_strings(call)] if words and not _git(call) else words
            if _OF_COMMITS & {*words}:
                return " ".join(words)
    return ""


def only_ask(tree: ast.Module) -> frozenset[str]:
    """Return the functions of a setup.py that start git and no other program: they make no file."""
    return frozenset(
        node.name
        for node in _functions(tree)
        if (runs := [call for call in _calls(node) if ast.unparse(call.func) in _RUNS]) and all(map(_git, runs))
    )


def _functions(tree: ast.Module) -> Iterator[ast.FunctionDef]:
    return (node for node in tree.body if isinstance(node, ast.FunctionDef))


def _always(body: Iterable[ast.stmt]) -> list[str]:
    """Return the words of the first call of git that a function always makes."""
    for statement in body:
        if _guarded(statement):
            return []  # the function may have ended by then
        for call in _calls(statement):
            if _git(call):
                return _words(call)
    return []


def _guarded(statement: ast.stmt) -> bool:
    guards = (ast.FunctionDef, ast.ClassDef, ast.If, ast.IfExp, ast.Try, ast.Lambda, ast.BoolOp)
    return any(isinstance(node, guards) for node in ast.walk(statement))


def _calls(statement: ast.stmt) -> Iterator[ast.Call]:
    return (node for node in ast.walk(statement) if isinstance(node, ast.Call))


def _git(call: ast.Call) -> bool:
    """Tell whether a call starts git and stops where that fails."""
    name = ast.unparse(call.func)
    checked = any(each.arg == "check" and ast.unparse(each.value) == "True" for each in call.keywords)
    return (name in _STOPS or (name in _RUNS and checked)) and _words(call)[:1] == ["git"]


def _words(call: ast.Call) -> list[str]:
    return [word for text in _strings(call) for word in text.split()]


def _strings(call: ast.Call) -> list[str]:
    """Return the strings that are given to a call, in lists and sums, too."""
    nodes = (node for given in call.args for node in _in_order(given))
    return [node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]


def _in_order(node: ast.AST) -> Iterator[ast.AST]:
    """Yield a node and what it consists of as it is written; ``ast.walk`` goes level by level."""
    yield node
    for part in ast.iter_child_nodes(node):
        yield from _in_order(part)
