"""Whether a setup.py stops on a machine without a GPU, as every build of an image is."""

from __future__ import annotations

import ast

from roslab.evidence.python.parsed import parsed
from roslab.values.pattern import pattern

_CALL = "cuda.is_available()"
_ASKS_MORE = pattern(
    r"cuda\.(?:get_device|device_count|current_device|get_arch|init|mem_get|set_device|device\b)|nvidia-smi|"
    r"\.cuda\(|device\s*=|\.to\(|getDevice"
)
"""What only a machine with a GPU answers."""


def needs_gpu(text: str) -> bool:
    """Tell whether it raises an error where torch sees no GPU, and no variable can tell it to go on."""
    tree = parsed(text)
    return tree is not None and any(_stops(node) for node in ast.walk(tree))


def only_asks(text: str) -> bool:
    """Tell whether such a script wants to know of a GPU only whether there is one: it compiles without it, too."""
    return not _ASKS_MORE.search(text)


def _stops(node: ast.AST) -> bool:
    if isinstance(node, ast.Assert):
        return _sure(node.test)
    if not isinstance(node, ast.If):
        return False
    without = isinstance(node.test, ast.UnaryOp) and isinstance(node.test.op, ast.Not) and _is_call(node.test.operand)
    return _raises(node.body) if without else _sure(node.test) and _raises(node.orelse)


def _sure(test: ast.expr) -> bool:
    """Tell whether a condition cannot hold without a GPU."""
    if isinstance(test, ast.BoolOp):
        return isinstance(test.op, ast.And) and any(map(_is_call, test.values))
    return _is_call(test)


def _is_call(test: ast.expr) -> bool:
    return isinstance(test, ast.Call) and ast.unparse(test).endswith(_CALL)


def _raises(body: list[ast.stmt]) -> bool:
    """Tell whether it ends the script whatever else holds."""
    calls = (each.value for each in body if isinstance(each, ast.Expr) and isinstance(each.value, ast.Call))
    leaves = any(ast.unparse(call.func) in {"sys.exit", "exit", "quit"} for call in calls)
    return leaves or any(isinstance(each, ast.Raise) for each in body)
