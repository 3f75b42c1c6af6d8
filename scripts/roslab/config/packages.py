"""Lists of packages: entries with several packages are split, and options of pip are separated from requirements."""

from __future__ import annotations

from roslab.config import vocabulary
from roslab.config.node import Mapping
from roslab.config.reading import Reading
from roslab.values.pattern import pattern

_VALUED = frozenset({"-i", "-f", "--index-url", "--extra-index-url", "--find-links", "--no-binary", "--only-binary"})
"""Options of pip that need a value."""
_LONG = {
    "-U": "--upgrade",
    "-I": "--ignore-installed",
    "-i": "--index-url",
    "-f": "--find-links",
}
_EDITABLE = frozenset({"-e", "--editable"})
_SPACED = pattern(r";| @ | [<>=!~]|[<>=!~] |, ")
"""A requirement that contains spaces; by the grammar such an entry is a single requirement."""


def apt(reading: Reading, root: Mapping, key: str, path: str = "apt") -> tuple[str, ...]:
    """Return apt packages, one per entry and without duplicates."""
    found: dict[str, None] = {}
    for text in reading.texts(root, key, path) or ():
        for word in text.value.split():
            if word not in found:
                reading.note(f"{path}.{len(found)}", text.node)
                found[word] = None
    return tuple(found)


def pip(reading: Reading, root: Mapping, key: str, path: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the requirement lines of a list, and its options separately.

    The options apply to the whole list, because the old generators installed it with one ``pip install``.
    """
    lines: list[str] = []
    options: list[str] = []
    for text in reading.texts(root, key, path) or ():
        for line in _split(text.value, options):
            if line in _EDITABLE:
                reading.warn(f"`{line}` makes no difference in an image and is left out", text.node)
            elif line not in lines:
                reading.note(f"{path}.{len(lines)}", text.node)
                lines.append(line)
    return tuple(lines), tuple(options)


def _split(entry: str, options: list[str]) -> list[str]:
    """Split a valid entry into its requirements; its options are added to ``options``."""
    words = entry.split()
    lines: list[str] = []
    while words:
        word = words.pop(0)
        name, _, value = word.partition("=") if word.startswith("-") else (word, "", "")
        if name in _VALUED:
            pair = [_LONG.get(name, name), value or words.pop(0)]
            options += pair if pair not in _pairs(options) else []
        elif word in _EDITABLE or not word.startswith("-"):
            lines.append(word)
        elif (long := _LONG.get(word, word)) not in options:
            options.append(long)
    rest = " ".join(lines)
    return [rest] if _SPACED.search(rest) else lines


def _pairs(options: list[str]) -> list[list[str]]:
    return [options[i : i + 2] for i in range(len(options) - 1)]


def repositories(reading: Reading, root: Mapping, key: str) -> tuple[str, ...]:
    """Return extra apt sources, with a warning for those that are known to be gone."""
    found: list[str] = []
    for text in reading.texts(root, key, "repositories") or ():
        reading.note(f"repositories.{len(found)}", text.node)
        found.append(text.value)
        reason = vocabulary.rows("repositories").get(text.value)
        if reason:
            reading.warn(f"{text.value} may not answer any more: {reason}", text.node)
        elif text.value.removeprefix("deb ").startswith("http://"):
            reading.warn(f"{text.value} is fetched without encryption", text.node)
    return tuple(found)
