"""Adds entries to the lists of a roslab.yaml and leaves everything else, including comments and layout, unchanged."""

from __future__ import annotations

import re
from collections.abc import Mapping as Wanted

from roslab.config.document import parse
from roslab.config.edit import Edits, flow_list, is_text, quoted
from roslab.config.model import Config
from roslab.config.node import Mapping, Sequence
from roslab.config.reader import mapping_of, read
from roslab.errors import ConfigurationError, Problem
from roslab.values.origin import Place

KEYS = ("apt", "pip", "skip_keys", "build_args")
"""Keys with lists of texts, to which entries may be added."""
_PLAIN = re.compile(r"[A-Za-z][\w.+-]*")
"""Text that YAML reads as text without quotes in any position; words such as ``yes`` are quoted all the same."""
_WORDS = {"yes", "no", "on", "off", "true", "false", "null", "y", "n"}


def added(text: str | None, wanted: Wanted[str, tuple[str, ...]], *, file: str = "roslab.yaml") -> str:
    """Return a roslab.yaml with these entries added; it is unchanged if it has them all.

    ``text`` is ``None`` if there is no file yet. Raises ``ConfigurationError`` if the file is wrong, in an old format,
    or in a layout that cannot be edited reliably.
    """
    base = "format: 3\n" if text is None or not text.strip() else text
    config = read(base, file=file)
    if config.generation != "today":
        raise ConfigurationError(
            Problem(
                message="entries are added to a file of today's format only",
                hint="run `roslab migrate --write` first",
                origin=Place(file=file),
            )
        )
    missing = {key: _missing(config, key, values) for key, values in wanted.items() if key in KEYS}
    edits = Edits(text=base)
    root = mapping_of(parse(base, file=file))
    new = [_entry(edits, root, key, values) for key, values in missing.items() if values]
    result = edits.applied()
    if lines := "".join(new):
        result = f"{result}{'' if result.endswith(chr(10)) else chr(10)}{lines}"
    after = read(result, file=file)
    if any(_missing(after, key, values) for key, values in missing.items()):
        raise ConfigurationError(
            Problem(
                message="the entries do not fit the layout of this file",
                hint="add them by hand",
                origin=Place(file=file),
            )
        )
    return result


def _missing(config: Config, key: str, values: tuple[str, ...]) -> tuple[str, ...]:
    has: tuple[str, ...] = getattr(config, key)
    return tuple(value for value in values if value not in has)


def _entry(edits: Edits, root: Mapping, key: str, values: tuple[str, ...]) -> str:
    """Add values to an existing key, or return the lines of a key that does not exist yet."""
    node = root.get(key)
    if isinstance(node, Sequence) and node.items and node.flow:
        at = node.items[-1].end.index
        edits.put(at, at, "".join(f", {_word(value)}" for value in values))
    elif isinstance(node, Sequence) and node.items:
        end = edits.text.find("\n", node.items[-1].end.index)
        at = len(edits.text) if end < 0 else end
        indent = " " * (node.start.column - 1)
        edits.put(at, at, "".join(f"\n{indent}- {_word(value)}" for value in values))
    elif node is not None and is_text(node):
        old = edits.text[node.start.index : node.end.index]
        edits.put(node.start.index, node.end.index, f"[{', '.join([old, *map(_word, values)])}]")
    elif node is not None:
        edits.put(node.start.index, node.end.index, flow_list(values))
    else:
        return f"{key}:\n" + "".join(f"  - {_word(value)}\n" for value in values)
    return ""


def _word(value: str) -> str:
    return value if _PLAIN.fullmatch(value) and value.lower() not in _WORDS else quoted(value)
