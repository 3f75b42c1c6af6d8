"""What the expressions of launch files come to: ``$(eval …)``, and ``$(not …)``, ``$(equals … …)`` of ROS 2's XML.

They are read as Python and worked out here, never run; what one needs that is not known leaves it unknown.
https://wiki.ros.org/roslaunch/XML (substitution args), ros/ros_comm (roslaunch/substitution_args.py),
https://docs.ros.org/en/rolling/p/launch/launch.substitutions.html; all read 2026-11-28.
"""

from __future__ import annotations

import ast
import operator
import re
import warnings
from collections.abc import Callable, Iterator
from functools import cache

from roslab.values.pattern import pattern

MOST = 400
"""Most characters of an expression, and of what it comes to: the next one may ask for that twice."""
_EVAL = pattern(r"\$\(\s?eval\s+([^\n]{1,400})\)")
_REFERENCE = pattern(r"([\"']?)\$\(\s?(?:arg|var)\s+(\w{1,60})\s?\)\1")
_JOINED = {
    "not": "not",
    "and": " and ",
    "or": " or ",
    "any": " or ",
    "all": " and ",
    "equals": "==",
    "not-equals": "!=",
}
_PART = pattern(rf"\$\(\s?({'|'.join(_JOINED)}|var)\s|\)|[\"']([^\"']*)[\"']|[^\s()\"']+|\s+")
_FEWEST = {"not": 1, "equals": 2, "not-equals": 2}
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


def expression(written: str) -> str:
    """Return what stands in a launch file as an expression of Python, ``""`` where it is none.

    It has ``arg('NAME')`` for the value of an argument, and ``text('NAME')`` where that is in quotes.
    """
    text = _plain(written.strip())
    if len(text) > MOST:
        return ""
    if said := _EVAL.fullmatch(text):
        inner = said[1].strip()
        tree = _parsed(inner)
        if tree and isinstance(tree.body, ast.Constant) and "$(" in inner and not _REFERENCE.fullmatch(inner):
            inner = inner[1:-1].replace(f"\\{inner[0]}", inner[0])  # ROS 2 has the whole in quotes
        return _REFERENCE.sub(_asked, inner)
    return _substituted(text) if text.startswith("$(") else ""


def _plain(text: str) -> str:
    """Return a text with the signs that XML's references stand for."""
    if "&" not in text:
        return text
    from html import unescape  # noqa: PLC0415 - its table of names is long, and few conditions have such a sign

    return unescape(text)


def _asked(reference: re.Match[str]) -> str:
    return f"{'text' if reference[1] else 'arg'}({reference[2]!r})"


def _substituted(text: str) -> str:
    """Return the expression of ``$(and $(var a) $(not $(var b)))``, ``""`` for what is none of this kind."""
    open_: list[tuple[str, list[str]]] = [("", [])]
    end = 0
    for match in _PART.finditer(text):
        if match.start() != end:
            return ""
        end = match.end()
        if match[1]:
            open_.append((match[1], []))
        elif match[0] == ")":
            word, parts = open_.pop()
            if not open_ or len(parts) < _FEWEST.get(word, 1) or (word == "var" and len(parts) != 1):
                return ""
            open_[-1][1].append(_joined(word, parts))
        elif not match[0].isspace():
            plain = match[0] if match[2] is None else match[2]
            open_[-1][1].append(plain if open_[-1][0] == "var" else repr(plain))
    return open_[0][1][0] if end == len(text) and len(open_) == 1 and len(open_[0][1]) == 1 else ""


def _joined(word: str, parts: list[str]) -> str:
    if word == "var":
        return f"arg({parts[0]!r})"
    if word == "not":
        return f"(not {parts[0]})"
    if word in {"equals", "not-equals"}:
        return f"(str({parts[0]}).lower() {_JOINED[word]} str({parts[1]}).lower())"
    return f"({_JOINED[word].join(f'truth({part})' for part in parts)})"


@cache
def names(text: str) -> tuple[str, ...]:
    """Return the arguments that an expression asks for."""
    return tuple(dict.fromkeys(_names(text)))


def _names(text: str) -> Iterator[str]:
    called = set()
    for node in ast.walk(tree) if (tree := _parsed(text)) else ():
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            called.add(node.func)
            if node.func.id in {"arg", "text"} and node.args and isinstance(node.args[0], ast.Constant):
                yield str(node.args[0].value)
        elif isinstance(node, ast.Name) and node not in called and node.id not in _NAMES:
            yield node.id


def result(text: str, look: Look) -> str | None:
    """Return what an expression comes to, as a launch file has it, ``None`` where that is not known."""
    tree = _parsed(text)
    try:
        found = str(_worked_out(tree.body, look)) if tree else None
    except (UnknownError, RecursionError):
        return None
    return found if found is None or len(found) <= MOST else None


def truth(value: str | None) -> bool | None:
    """Return whether a value means yes, ``None`` where it says neither."""
    return _TRUTH.get((value or "").strip().lower())


@cache
def _parsed(text: str) -> ast.Expression | None:
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
