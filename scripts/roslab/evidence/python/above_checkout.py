"""Modules that put the folder above the checkout on Python's path."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from roslab.evidence.python.modules import Module
from roslab.evidence.python.parsed import parsed

_SAME = frozenset({"abspath", "realpath", "normpath", "normcase", "expanduser", "fspath", "str", "Path", "PurePath"})
"""Functions whose path is that of their argument."""
_SAME_PATH = frozenset({"resolve", "absolute", "as_posix"})
MAX_DEPTH = 12


def reaches_above(module: Module) -> bool:
    """Tell whether a module puts the folder on Python's path in which the checkout lies."""
    tree = parsed(module.text)
    nodes = [*ast.walk(tree)] if tree else []
    names = {
        node.targets[0].id: node.value
        for node in nodes
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    above = module.file.path.count("/") + 2
    return any(
        isinstance(node, ast.Call)
        and ast.unparse(node.func) in {"sys.path.append", "sys.path.insert"}
        and node.args
        and _levels(node.args[-1], names) == above
        for node in nodes
    )


def _levels(node: ast.expr, names: Mapping[str, ast.expr], depth: int = 0) -> int | None:
    """Return how many folders above the module's own path an expression is, ``None`` where that is not to be told."""
    if depth > MAX_DEPTH:
        return None
    below: ast.expr | None = None
    more: int | None = 0
    if isinstance(node, ast.Name):
        if node.id == "__file__":
            return 0
        below = names.get(node.id)
    elif isinstance(node, ast.Attribute) and node.attr == "parent":
        below, more = node.value, 1
    elif isinstance(node, ast.Subscript) and isinstance(node.value, ast.Attribute) and node.value.attr == "parents":
        below, more = node.value.value, _number(node.slice)
    elif isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Div)):
        below, more = node.left, _ups([node.right])
    elif isinstance(node, ast.Call):
        name = ast.unparse(node.func).rpartition(".")[2]
        if name in _SAME_PATH and isinstance(node.func, ast.Attribute):
            below = node.func.value
        elif node.args and name in {*_SAME, "dirname", "join"}:
            below = node.args[0]
            more = _ups(node.args[1:]) if name == "join" else int(name == "dirname")
    levels = _levels(below, names, depth + 1) if below is not None else None
    return None if levels is None or more is None else levels + more


def _number(node: ast.expr) -> int | None:
    return node.value + 1 if isinstance(node, ast.Constant) and isinstance(node.value, int) else None


def _ups(nodes: list[ast.expr]) -> int | None:
    """Return how many folders up words lead that are nothing but ``..``."""
    words = [node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    parts = [part for word in words for part in word.split("/") if part not in {"", "."}]
    return len(parts) if len(words) == len(nodes) and all(part == ".." for part in parts) else None
