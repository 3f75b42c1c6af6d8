"""What stands in a launch file as an expression: ``$(eval …)``, ``$(arg …)``, and ``$(not …)`` … of ROS 2's XML.

https://wiki.ros.org/roslaunch/XML (substitution args),
https://docs.ros.org/en/rolling/p/launch/launch.substitutions.html; both read 2026-11-28.
"""

from __future__ import annotations

import ast
import re

from roslab.evidence.ros.argument_defaults import REFERENCE
from roslab.evidence.ros.expressions import MOST, parsed
from roslab.values.pattern import pattern

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


def expression(written: str) -> str:
    """Return what stands in a launch file as an expression, a plain text too, ``""`` where it is none."""
    text = _plain(written.strip())
    if len(text) > MOST:
        return ""
    if said := _EVAL.fullmatch(text):
        inner = said[1].strip()
        tree = parsed(inner)
        if tree and isinstance(tree.body, ast.Constant) and "$(" in inner and not _REFERENCE.fullmatch(inner):
            inner = inner[1:-1].replace(f"\\{inner[0]}", inner[0])  # ROS 2 has the whole in quotes
        return _REFERENCE.sub(_asked, inner)
    if named := REFERENCE.fullmatch(text):
        return f"text({named[1]!r})"
    return _substituted(text) if text.startswith("$(") else "" if "$(" in text else repr(text)


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
