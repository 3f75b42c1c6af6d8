"""Expressions of Python in launch files and robot descriptions: worked out here, never run.

``arg('NAME')`` is the value of an argument as ``roslaunch`` gives it to one, as the name alone is; ``text('NAME')`` is
its text, and ``truth(…)`` what a text means. What one needs that is not known leaves it unknown.
https://wiki.ros.org/roslaunch/XML (substitution args), ros/ros_comm (roslaunch/substitution_args.py), read 2026-11-28.
"""

from __future__ import annotations

import ast
import operator
import warnings
from collections.abc import Callable, Iterator
from functools import cache

from roslab.values.pattern import pattern

MOST = 400
"""Most characters of an expression, and of what it comes to: the next one may ask for that twice."""
_NAMES: dict[str, object] = {"true": True, "false": False, "True": True, "False": False, "None": None}
_ORDERED: dict[type[ast.cmpop], Callable[[float, float], bool]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_OF_TEXT: dict[str, Callable[[str], object]] = {
    "lower": str.lower,
    "upper": str.upper,
    "strip": str.strip,
    "len": len,
    "str": str,
    "bool": bool,
}
"""Functions and methods of a text."""
_WHOLE = pattern(r"[+-]?\d{1,18}")
_BROKEN = pattern(r"[+-]?(?:\d{1,18}\.\d{0,18}|\.\d{1,18})")
_TRUTH = {"true": True, "1": True, "false": False, "0": False}
Look = Callable[[str], str | None]
"""The value of an argument as a launch file has it, ``None`` where nothing tells it."""


class UnknownError(Exception):
    """Something in the expression is not known."""


@cache
def names(text: str) -> tuple[str, ...]:
    """Return the arguments that an expression asks for."""
    return tuple(dict.fromkeys(_names(text)))


def _names(text: str) -> Iterator[str]:
    called = set()
    for node in ast.walk(tree) if (tree := parsed(text)) else ():
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            called.add(node.func)
            if node.func.id in {"arg", "text"} and node.args and isinstance(node.args[0], ast.Constant):
                yield str(node.args[0].value)
        elif isinstance(node, ast.Name) and node not in called and node.id not in _NAMES:
            yield node.id


def parts(text: str, *, holds_if: bool) -> tuple[str, ...]:
    """Return the expressions that all have to be true, or all false where not ``holds_if``, for one to be so."""
    joined = ast.And if holds_if else ast.Or
    body = tree.body if (tree := parsed(text)) else None
    if not (isinstance(body, ast.BoolOp) and isinstance(body.op, joined)):
        return (text,)
    inner = (ast.get_source_segment(text.strip(), value) or "" for value in body.values)
    *others, last = (parts(part, holds_if=holds_if) for part in inner)
    return (*(f"bool({each})" for part in others for each in part), *last)


def result(text: str, look: Look) -> str | None:
    """Return what an expression comes to, as a launch file has it, ``None`` where that is not known."""
    tree = parsed(text)
    try:
        found = str(_worked_out(tree.body, look)) if tree else None
    except (UnknownError, RecursionError):
        return None
    return found if found is None or len(found) <= MOST else None


def truth(value: str | None) -> bool | None:
    """Return whether a value means yes, ``None`` where it says neither."""
    return _TRUTH.get((value or "").strip().lower())


@cache
def parsed(text: str) -> ast.Expression | None:
    """Return the tree of an expression, ``None`` of what is none."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about the file, which is not our user's to correct now
            return ast.parse(text.strip(), mode="eval") if 0 < len(text) <= MOST else None
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        return None


def _worked_out(node: ast.expr, look: Look) -> object:
    """Return the value of a part of an expression; raises :class:`UnknownError` for all that is not plain."""
    work = _WORK.get(type(node))
    if work is None:
        raise UnknownError
    return work(node, look)


def _constant(node: ast.expr, _: Look) -> object:
    if isinstance(node, ast.Constant) and isinstance(node.value, bool | int | float | str | None):
        return node.value
    raise UnknownError


def _name(node: ast.expr, look: Look) -> object:
    name = node.id if isinstance(node, ast.Name) else ""
    return _NAMES[name] if name in _NAMES else _of_argument(name, look)


def _call(node: ast.expr, look: Look) -> object:
    match node:
        case ast.Call(func=ast.Name(id="arg"), args=[ast.Constant(value=str() as name)], keywords=[]):
            return _of_argument(name, look)
        case ast.Call(func=ast.Name(id="text"), args=[ast.Constant(value=str() as name)], keywords=[]):
            return _sure(look(name))
        case ast.Call(func=ast.Name(id="truth"), args=[part], keywords=[]):
            return _sure(truth(str(_worked_out(part, look))))
        case (
            ast.Call(func=ast.Name(id=name), args=[part], keywords=[])
            | ast.Call(func=ast.Attribute(value=part, attr=name), args=[], keywords=[])
        ) if name in _OF_TEXT:
            value = _worked_out(part, look)
            if isinstance(value, str) or name in {"str", "bool"}:
                return bool(value) if name == "bool" else _OF_TEXT[name](str(value))
    raise UnknownError


def _several(node: ast.expr, look: Look) -> object:
    return [_worked_out(part, look) for part in getattr(node, "elts", ())]


def _turned(node: ast.expr, look: Look) -> object:
    match node:
        case ast.UnaryOp(op=ast.Not(), operand=part):
            return not _worked_out(part, look)
        case ast.UnaryOp(op=ast.USub(), operand=part):
            return -_number(_worked_out(part, look))
    raise UnknownError


def _chosen(node: ast.expr, look: Look) -> object:
    if not isinstance(node, ast.IfExp):
        raise UnknownError
    return _worked_out(node.body if _worked_out(node.test, look) else node.orelse, look)


def _joined_by(node: ast.expr, look: Look) -> object:
    """Return the value of parts with ``and`` or ``or``: one of them may decide whatever the others are."""
    if not isinstance(node, ast.BoolOp):
        raise UnknownError
    decides = isinstance(node.op, ast.Or)
    values = [_perhaps(part, look) for part in node.values]
    first = next((index for index, value in enumerate(values) if value and bool(value[0]) == decides), None)
    if first is not None:
        return values[first][0] if all(values[:first]) else decides
    if not all(values):
        raise UnknownError
    return values[-1][0]


def _perhaps(node: ast.expr, look: Look) -> tuple[object, ...]:
    """Return the value of a part, nothing where it is not known."""
    try:
        return (_worked_out(node, look),)
    except UnknownError:
        return ()


def _compared(node: ast.expr, look: Look) -> bool:
    if not isinstance(node, ast.Compare):
        raise UnknownError
    values = [_worked_out(part, look) for part in (node.left, *node.comparators)]
    return all(_holds(op, one, other) for op, one, other in zip(node.ops, values, values[1:], strict=False))


def _holds(op: ast.cmpop, one: object, other: object) -> bool:
    """Tell whether two values compare so."""
    if isinstance(op, ast.Eq | ast.NotEq):
        return (one == other) == isinstance(op, ast.Eq)
    if isinstance(op, ast.In | ast.NotIn) and (isinstance(other, list) or (isinstance(one, str) and _is_text(other))):
        return (one in other) == isinstance(op, ast.In)  # type: ignore[operator]
    if (compare := _ORDERED.get(type(op))) is None:
        raise UnknownError
    return compare(_number(one), _number(other))


def _is_text(value: object) -> bool:
    return isinstance(value, str)


def _of_argument(name: str, look: Look) -> object:
    """Return the value of an argument as ``roslaunch`` gives it to an expression: a number, a truth, or its text."""
    text = str(_sure(look(name)))
    for of_number in (_WHOLE, _BROKEN):
        if of_number.fullmatch(text):
            return int(text) if of_number is _WHOLE else float(text)
    return {"true": True, "false": False}.get(text.lower(), text)


def _sure(value: object) -> object:
    if value is None:
        raise UnknownError
    return value


def _number(value: object) -> float:
    if not isinstance(value, int | float):
        raise UnknownError
    return value


_WORK: dict[type[ast.expr], Callable[[ast.expr, Look], object]] = {
    ast.Constant: _constant,
    ast.Name: _name,
    ast.Call: _call,
    ast.List: _several,
    ast.Tuple: _several,
    ast.Set: _several,
    ast.UnaryOp: _turned,
    ast.IfExp: _chosen,
    ast.BoolOp: _joined_by,
    ast.Compare: _compared,
}
