"""Loading untrusted YAML with bounds: PyYAML's C loader has no recursion limit of its own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

from roslab.values.pattern import pattern

MAX_DEPTH = 100
_BRACKETS = pattern(r"[\[\]{}]")
_DEEP = pattern(rf"^(?:[ \t]*(?:- )){{{MAX_DEPTH},}}|^ {{1000,}}\S", re.MULTILINE)


NO_VARIABLES: Mapping[str, str] = MappingProxyType({})


class Scalar(NamedTuple):
    """A value of a document with its key (for an item of a list, the list's key)."""

    key: str
    text: str
    """As it is written; lines that YAML would fold are joined by a backslash, so that line numbers stay right."""
    line: int
    """Line number of the text's first line."""
    item: bool
    variables: Mapping[str, str] = NO_VARIABLES
    """What ``env`` of the blocks around it sets, the innermost last: a workflow's, its job's and its step's."""


def load(text: str) -> Any:
    """Return the first document, ``None`` if it is not YAML or nested deeper than any person writes."""
    return next(_read(text, "load_all"), None)


def scalars(text: str) -> tuple[Scalar, ...] | None:
    """Return every value of all documents in order; ``None`` if the text is not YAML."""
    lines = text.split("\n")
    try:
        documents = list(_read(text, "compose_all", strict=True))
    except ValueError:
        return None
    found: list[Scalar] = []
    pending, seen = [("", False, document, NO_VARIABLES) for document in reversed(documents)], set[int]()
    while pending:
        key, item, node, variables = pending.pop()
        if id(node) in seen:  # an alias: its value was read at the anchor
            continue
        seen.add(id(node))
        if node.id == "mapping":
            variables = _with_env(node, variables)
            pending += [(str(name.value), False, value, variables) for name, value in reversed(node.value)]
        elif node.id == "sequence":
            pending += [(key, True, value, variables) for value in reversed(node.value)]
        else:
            found.append(_scalar(key, item, node, lines)._replace(variables=variables))
    return tuple(found)


def _with_env(node: Any, above: Mapping[str, str]) -> Mapping[str, str]:
    """Return the variables that hold below a mapping: those above it, and what its own ``env`` sets."""
    own = [value for name, value in node.value if name.value == "env" and value.id == "mapping"]
    pairs = [(str(name.value), value) for each in own for name, value in each.value]
    return {**above, **{name: str(value.value) for name, value in pairs if value.id == "scalar"}} if pairs else above


def _scalar(key: str, item: bool, node: Any, lines: list[str]) -> Scalar:
    first, last = node.start_mark.line, node.end_mark.line
    if node.style == "|":
        return Scalar(key, node.value, first + 2, item)
    if node.style == ">":
        return Scalar(key, " \\\n".join(line.strip() for line in lines[first + 1 : last]), first + 2, item)
    return Scalar(key, node.value, first + 1, item)


def _read(text: str, how: Literal["load_all", "compose_all"], *, strict: bool = False) -> Iterator[Any]:
    """Yield documents up to the first error; ``strict`` raises it as ``ValueError``."""
    depth = deepest = 0
    for match in _BRACKETS.finditer(text):
        depth = max(0, depth + (1 if match[0] in "[{" else -1))
        deepest = max(deepest, depth)
    from roslab.values.yaml import yaml  # noqa: PLC0415 - 20 ms that most repositories never need

    try:
        if deepest > MAX_DEPTH or _DEEP.search(text):
            raise ValueError("nested deeper than any person writes")  # noqa: TRY301 - as the loader's own errors
        yield from getattr(yaml, how)(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    except (yaml.YAMLError, ValueError, RecursionError, TypeError, KeyError, AttributeError, OverflowError) as error:
        if strict:
            raise ValueError(str(error)) from None
