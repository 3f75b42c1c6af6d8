"""Changes to a text that leave everything else in it, including comments and layout, unchanged."""

from __future__ import annotations

import json

from roslab.config.node import Mapping, Node, Scalar
from roslab.values.dataclass import dataclass, field

OTHER_THAN_TEXT = frozenset({"yes", "no", "on", "off", "null", "y", "n"})
"""Words that YAML, or an older version of it, takes for something else than text, besides ``true`` and ``false``."""


@dataclass(kw_only=True, slots=True)
class Edits:
    """Replacements for parts of a text, and a line about each for the user."""

    text: str
    changes: list[str] = field(default_factory=list)
    _parts: dict[tuple[int, int], str] = field(default_factory=dict)

    def put(self, start: int, end: int, new: str, change: str | None = None) -> None:
        """Replace a part of the text; ``start == end`` inserts."""
        if (start, end) not in self._parts and change:
            self.changes.append(change)
        self._parts[start, end] = new

    def value(self, node: Node, new: str, change: str) -> None:
        """Replace a value or a key."""
        self.put(node.start.index, node.end.index, new, f"line {node.start.line}: {change}")

    def rename(self, mapping: Mapping, old: str, new: str) -> None:
        """Rename a key."""
        key = mapping.key(old)
        if key is not None and old != new:
            self.value(key, new, f"`{old}` becomes `{new}`")

    def pair(self, mapping: Mapping, name: str, new: list[str], change: str) -> None:
        """Replace a key and its single value by ``KEY: VALUE`` texts."""
        key, value = mapping.key(name), mapping.get(name)
        if key is not None and value is not None:
            joined = self.separator(mapping, key).join(new)
            self.put(key.start.index, value.end.index, joined, f"line {key.start.line}: {change}")

    def separator(self, mapping: Mapping, key: Node) -> str:
        """Return what separates two keys of a mapping: a line break with the indentation, or a comma."""
        newline = "\r\n" if "\r\n" in self.text else "\n"
        return ", " if mapping.flow else newline + " " * (key.start.column - 1)

    def applied(self) -> str:
        """Return the text with every change made."""
        out, at = [], 0
        for (start, end), new in sorted(self._parts.items()):
            out += [self.text[at:start], new]
            at = max(at, end)
        return "".join([*out, self.text[at:]])


def quoted(text: str) -> str:
    """Return a text quoted as a JSON string, which YAML accepts in any position."""
    return json.dumps(text, ensure_ascii=False)


def flow_list(values: tuple[str, ...]) -> str:
    """Return a list of texts in brackets."""
    return f"[{', '.join(map(quoted, values))}]"


def is_text(node: Node | None) -> bool:
    """Return whether a node is a single value that is not empty."""
    return isinstance(node, Scalar) and node.kind != "null"
