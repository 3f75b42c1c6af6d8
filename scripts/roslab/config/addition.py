"""Adds values to a roslab.yaml and leaves everything else in it, including comments and layout, unchanged."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.config.document import parse
from roslab.config.edit import OTHER_THAN_TEXT, Edits, is_text, quoted
from roslab.config.model import Config
from roslab.config.node import Mapping, Node, Sequence
from roslab.config.reader import mapping_of, read
from roslab.config.source import named
from roslab.errors import ConfigurationError, Problem
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.repairs import CLONES, LISTS
from roslab.repository.checkout import printable
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

WORDS = ("cmake_options",)
"""Keys with one text, to whose end values are added."""
SINGLE = (
    *("base.python", "base.ros", "base.ubuntu", "base.cmake_update", "dockerfile", "env.PYTHONPATH", "gui"),
    *("submodules", "env.CFLAGS", "env.CXXFLAGS"),
)
"""Keys with one value, which is set."""
_PLAIN = pattern(r"[A-Za-z][\w.+-]*")
"""Text that YAML reads as text without quotes in any position; words such as ``yes`` are quoted all the same."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Entry:
    """One value for one key."""

    key: str
    """One of ``LISTS``, ``WORDS`` and ``SINGLE``, or ``CLONES``."""
    value: str
    instead: str = ""
    """The value of the list that it replaces."""
    note: str = ""
    """What a comment behind a new line says: who needs it."""


def added(text: str | None, entries: Iterable[Entry], *, file: str = "roslab.yaml") -> str:
    """Return a roslab.yaml with these values; it is unchanged if it has them all.

    ``text`` is ``None`` if there is no file yet. Raises ``ConfigurationError`` if the file is wrong, in an old format,
    or in a layout that cannot be edited reliably.
    """
    base = "format: 3\n" if text is None or not text.strip() else text
    config = read(base, file=file)
    if config.generation != "today":
        hint = "run `roslab migrate --write` first"
        raise ConfigurationError(
            Problem(message="values are added to a file of today's format only", hint=hint, origin=Place(file=file))
        )
    missing = [entry for entry in _last(entries) if not has(config, entry)]
    edits = Edits(text=base)
    root = mapping_of(parse(base, file=file))
    groups: dict[str, list[Entry]] = {}
    for entry in missing:
        groups.setdefault(entry.key.partition(".")[0], []).append(entry)
    new = [_group(edits, root, key, group) for key, group in groups.items()]
    result = edits.applied()
    if lines := "".join(new):
        result = f"{result}{'' if result.endswith(chr(10)) else chr(10)}{lines}"
    if not all(has(read(result, file=file), entry) for entry in missing):
        hint = "add them by hand"
        raise ConfigurationError(
            Problem(message="the values do not fit the layout of this file", hint=hint, origin=Place(file=file))
        )
    return result


def _last(entries: Iterable[Entry]) -> list[Entry]:
    """Return the entries without those that a later one replaces: of a key with one value the last stays."""
    kept: list[Entry] = []
    for entry in entries:
        one = entry.key in SINGLE
        before = [each for each in kept if each.key == entry.key and (one or each.value == entry.instead)]
        kept = [each for each in kept if each not in before]
        kept.append(replace(entry, instead=before[0].instead) if before else entry)
    return kept


def has(config: Config, entry: Entry) -> bool:
    """Return whether a configuration has a value."""
    if entry.key in LISTS:
        said = getattr(config, entry.key)
        return entry.value in said and not (entry.instead and entry.instead in said)
    if entry.key == CLONES:
        return named(entry.value) in {source.name for source in config.source}
    if entry.key in WORDS:
        return entry.value in getattr(config, entry.key).split()
    return value_of(config, entry.key) == entry.value


def value_of(config: Config, name: str) -> str:
    """Return the value of a key of ``SINGLE`` as it is written, ``""`` if it has none."""
    top, _, key = name.partition(".")
    said = dict(config.env).get(key) if top == "env" else getattr(config.base, key) if key else getattr(config, top)
    if name == "base.ubuntu" and said:  # kept by its name
        return next((version for version, codename in ubuntus().items() if codename == said), str(said))
    return "" if said is None else str(said).lower() if isinstance(said, bool) else str(said)


def _group(edits: Edits, root: Mapping, key: str, entries: list[Entry]) -> str:
    """Add values to an existing key, or return the lines of a key that does not exist yet."""
    node = root.get(key)
    if "." in entries[0].key:
        return _nested(edits, node, key, entries)
    if key in (*LISTS, CLONES):
        return _list(edits, node, key, _replaced(edits, node, entries))
    if node is None:
        value = " ".join(entry.value for entry in entries) if key in WORDS else entries[-1].value
        return f"{key}: {_word(value)}{_note(entries[-1].note)}\n"
    old = f"{node.text} " if key in WORDS and is_text(node) and hasattr(node, "text") else ""
    value = old + " ".join(entry.value for entry in entries) if key in WORDS else entries[-1].value
    edits.put(node.start.index, node.end.index, _word(value))
    return ""


def _nested(edits: Edits, node: Node | None, key: str, entries: list[Entry]) -> str:
    """Set keys of a mapping such as ``base``."""
    pairs = [(entry.key.partition(".")[2], entry) for entry in entries]
    if not isinstance(node, Mapping) or not node.pairs:
        lines = "".join(f"  {name}: {_word(entry.value)}{_note(entry.note)}\n" for name, entry in pairs)
        if node is not None:
            edits.put(node.start.index, node.end.index, "\n" + lines.rstrip("\n"))
            return ""
        return f"{key}:\n{lines}"
    for name, entry in pairs:
        old = node.get(name)
        if old is not None:
            edits.put(old.start.index, old.end.index, _word(entry.value))
            continue
        last = node.pairs[-1][1].end.index
        if node.flow:
            edits.put(last, last, f", {name}: {_word(entry.value)}")
        else:
            at = _line_end(edits.text, last)
            indent = " " * (node.pairs[0][0].start.column - 1)
            edits.put(at, at, f"\n{indent}{name}: {_word(entry.value)}{_note(entry.note)}")
    return ""


def _replaced(edits: Edits, node: Node | None, entries: list[Entry]) -> list[Entry]:
    """Replace the values that are to be replaced; return the entries that are still to be added."""
    left = []
    for entry in entries:
        items = node.items if isinstance(node, Sequence) else (node,) if node is not None else ()
        word = re.compile(rf"(?<![\w.+-]){re.escape(entry.instead)}(?![\w.+=-])") if entry.instead else None
        for item in items if word else ():
            old = edits.text[item.start.index : item.end.index]
            new = word.sub(lambda _, value=entry.value: value, old) if word else old  # type: ignore[misc]
            if new != old:
                edits.put(item.start.index, item.end.index, new)
                break
        else:
            left.append(entry)
    return left


def _list(edits: Edits, node: Node | None, key: str, entries: list[Entry]) -> str:
    written = {entry: entry.value if key == CLONES else _word(entry.value) for entry in entries}
    values = [*written.values()]
    if not values:
        return ""
    if isinstance(node, Sequence) and node.items and node.flow:
        at = node.items[-1].end.index
        edits.put(at, at, "".join(f", {value}" for value in values))
    elif isinstance(node, Sequence) and node.items:
        end = node.items[-1].end.index  # of a mapping that of the line below
        at = _line_end(edits.text, len(edits.text[:end].rstrip()))
        indent = " " * (node.start.column - 1)
        edits.put(at, at, "".join(f"\n{indent}- {text}{_note(one.note)}" for one, text in written.items()))
    elif node is not None and is_text(node):
        old = edits.text[node.start.index : node.end.index]
        edits.put(node.start.index, node.end.index, f"[{', '.join([old, *values])}]")
    elif node is not None:
        at = node.start.index
        apart = " " if edits.text[at - 1 : at] == ":" else ""  # a key without a value ends there
        edits.put(at, node.end.index, f"{apart}[{', '.join(values)}]")
    else:
        return f"{key}:\n" + "".join(f"  - {text}{_note(one.note)}\n" for one, text in written.items())
    return ""


def _line_end(text: str, at: int) -> int:
    end = text.find("\n", at)
    return len(text) if end < 0 else end - (text[end - 1] == "\r")


def _note(note: str) -> str:
    return f"  # {printable(' '.join(note.split()))}" if note else ""


def _word(value: str) -> str:
    return value if _PLAIN.fullmatch(value) and value.lower() not in OTHER_THAN_TEXT else quoted(value)
