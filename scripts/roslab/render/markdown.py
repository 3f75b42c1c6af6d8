"""Text of unknown origin as GitHub's Markdown: shown as it is, never read as markup."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable, Sequence

from roslab.repository.checkout import printable

_TERMINAL = re.compile(r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)")
"""ECMA-48, 5.4 and 5.6: https://ecma-international.org/publications-and-standards/standards/ecma-48/"""


def text(value: str) -> str:
    """Return one line of plain text: no markup, no HTML, no mention, no cell border, no link."""
    return _escaped(" ".join(value.split()))


def _plain(line: str) -> str:
    """Return a line without a terminal's colours and titles, and with every other control character spelt out."""
    return printable(_TERMINAL.sub("", line))


def _escaped(line: str) -> str:
    escaped = re.sub(r"([\\`*_{}\[\]()#+!|~$-])", r"\\\1", _plain(line))
    # A zero-width space after @ and before the rest of a bare URL: neither is turned into a link
    return html.escape(escaped, quote=False).replace("@", "@\u200b").replace("://", ":\u200b//")


def prose(value: str) -> str:
    """Return one line of plain text in which a message's own ``backticks`` mark code; all else is as in ``text``."""
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
    """Return a table of cells that are Markdown already; a border in one, even in its code, is escaped here."""
    rows = [[re.sub(r"(?<!\\)((?:\\\\)*)\|", r"\1\\|", cell) for cell in row] for row in rows]
    lines = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    return "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows)]) + "\n"


def folded(title: str, body: str, *, opened: bool = False) -> str:
    """Return a section that opens on a click, or is open and closes on one; ``title`` is HTML."""
    return f"<details{' open' if opened else ''}><summary>{title}</summary>\n\n{body.strip()}\n\n</details>\n"
