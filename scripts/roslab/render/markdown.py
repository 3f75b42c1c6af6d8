"""Text of unknown origin as GitHub's Markdown: shown as it is, never read as markup."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable, Sequence

from roslab.repository import printable


def text(value: str) -> str:
    """Return one line of plain text: no markup, no HTML, no mention, no cell border, no link."""
    escaped = re.sub(r"([\\`*_{}\[\]()#+!|~$-])", r"\\\1", printable(" ".join(value.split())))
    # A zero-width space after @ and before the rest of a bare URL: neither is turned into a link
    return html.escape(escaped, quote=False).replace("@", "@\u200b").replace("://", ":\u200b//")


def code(value: str) -> str:
    """Return one line in a code span; the fence is longer than any run of backticks in it."""
    line = printable(" ".join(value.split())) or " "
    fence = "`" * (max((len(run) for run in re.findall(r"`+", line)), default=0) + 1)
    pad = " " if line.startswith("`") or line.endswith("`") else ""
    return f"{fence}{pad}{line}{pad}{fence}".replace("|", "\\|")


def block(value: str, language: str = "") -> str:
    """Return a code block; the fence is longer than any run of backticks in it."""
    lines = [printable(line.replace("\t", "    ")) for line in value.strip("\n").splitlines()]
    body = "\n".join(lines)
    fence = "`" * max(3, max((len(run) for run in re.findall(r"`+", body)), default=0) + 1)
    return f"{fence}{language}\n{body}\n{fence}\n"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table of cells that are Markdown already."""
    lines = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    return "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows)]) + "\n"


def folded(title: str, body: str) -> str:
    """Return a section that opens on a click; ``title`` is Markdown without block structure."""
    return f"<details><summary>{title}</summary>\n\n{body.strip()}\n\n</details>\n"
