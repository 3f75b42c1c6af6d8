"""Untrusted text in GitHub's Markdown: shown literally, never interpreted as markup."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable, Sequence

from roslab.repository.checkout import printable
from roslab.values.pattern import pattern

_TERMINAL = pattern(r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)")
"""ECMA-48, 5.4 and 5.6: https://ecma-international.org/publications-and-standards/standards/ecma-48/"""


def text(value: str) -> str:
    """Return one line of plain text without markup, HTML, mentions, cell borders or links."""
    return _escaped(" ".join(value.split()))


def _plain(line: str) -> str:
    """Return a line without a terminal's colours and titles, and with other control characters written as escapes."""
    return printable(_TERMINAL.sub("", line))


def _escaped(line: str) -> str:
    escaped = re.sub(r"([\\`*_{}\[\]()#+!|~$-])", r"\\\1", _plain(line))
    # A zero-width space after @ and inside a bare address prevents GitHub from making links of them:
    # https://github.github.com/gfm/#autolinks-extension-
    plain = html.escape(escaped, quote=False).replace("@", "@\u200b").replace("://", ":\u200b//")
    return re.sub(r"www(?=\.)", "www\u200b", plain, flags=re.IGNORECASE)


def prose(value: str) -> str:
    """Return one line of plain text in which ``backticks`` mark code; everything else is as in ``text``."""
    parts = re.split(r"`([^`]+)`", " ".join(value.split()))
    return "".join(code(part) if index % 2 else _escaped(part) for index, part in enumerate(parts))


def code(value: str) -> str:
    """Return one line in a code span; the fence is longer than any run of backticks in it."""
    line = _plain(" ".join(value.split())) or " "
    fence = "`" * (max((len(run) for run in re.findall(r"`+", line)), default=0) + 1)
    pad = " " if line.startswith("`") or line.endswith("`") else ""
    return f"{fence}{pad}{line}{pad}{fence}"


def block(value: str, language: str = "") -> str:
    """Return a code block; the fence is longer than any run of backticks in it."""
    lines = [_plain(line.replace("\t", "    ")) for line in value.strip("\n").splitlines()]
    body = "\n".join(lines)
    fence = "`" * max(3, max((len(run) for run in re.findall(r"`+", body)), default=0) + 1)
    return f"{fence}{language}\n{body}\n{fence}\n"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table of cells that are already Markdown; ``|`` in a cell, even in its code, is escaped."""
    rows = [[re.sub(r"(?<!\\)((?:\\\\)*)\|", r"\1\\|", cell) for cell in row] for row in rows]
    lines = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    return "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows)]) + "\n"


def folded(title: str, body: str, *, opened: bool = False) -> str:
    """Return a section that a click folds and unfolds; ``title`` is HTML."""
    return f"<details{' open' if opened else ''}><summary>{title}</summary>\n\n{body.strip()}\n\n</details>\n"
