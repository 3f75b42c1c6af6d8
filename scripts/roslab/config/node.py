"""The parts of a YAML file, each with its place: the tree that all other modules here read.

PyYAML's own nodes are not used for three reasons: they are built by recursion, so that a deeply nested file causes a
RecursionError; the original text of a number is lost (``20.10`` is not 20.1); and the size of what an alias expands
to is not counted.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from roslab.values.dataclass import dataclass
from roslab.values.origin import Origin, Place

ScalarKind = Literal["string", "integer", "number", "boolean", "null", "date"]


@dataclass(frozen=True, kw_only=True, slots=True)
class Mark:
    """A place in a text: line and column from 1, and the index of the character."""

    line: int
    column: int
    index: int


Where = Callable[[Mark], Origin]
"""Returns the origin of the text at a mark: a place in a file, or the input or option that it came from."""


def in_file(file: str) -> Where:
    """Return the function that turns marks of one file into places."""
    return lambda mark: Place(file=file, line=mark.line, column=mark.column)


@dataclass(frozen=True, kw_only=True, slots=True)
class Node:
    """Any part of the tree; ``size`` counts its parts with aliases expanded."""

    start: Mark
    end: Mark
    size: int = 1


@dataclass(frozen=True, kw_only=True, slots=True)
class Scalar(Node):
    """A single value: its text as written, and the type that it has in YAML."""

    text: str
    kind: ScalarKind
    plain: bool
    """Written without quotes."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Sequence(Node):
    """A list."""

    items: tuple[Node, ...]
    flow: bool
    """Written with brackets."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Mapping(Node):
    """Keys and values in the order of the file; keys are unique."""

    pairs: tuple[tuple[Scalar, Node], ...]
    flow: bool
    """Written with braces."""

    def get(self, name: str) -> Node | None:
        """Return the value of a key, or ``None``."""
        return next((value for key, value in self.pairs if key.text == name), None)

    def key(self, name: str) -> Scalar | None:
        """Return the key itself, with its place, or ``None``."""
        return next((key for key, _ in self.pairs if key.text == name), None)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the keys, in the order of the file."""
        return tuple(key.text for key, _ in self.pairs)


def kind(node: Node) -> str:
    """Return the JSON Schema type of a node, or ``date``."""
    if isinstance(node, Scalar):
        return node.kind
    return "array" if isinstance(node, Sequence) else "object"
