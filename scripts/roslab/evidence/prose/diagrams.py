"""Blocks of a page that draw a diagram: their lines name programs and their arrows are no arguments.

Languages: https://docs.github.com/en/get-started/writing-on-github/working-with-advanced-formatting/creating-diagrams
and https://docs.gitlab.com/user/markdown/#diagrams-and-flowcharts, 2026-11-26.
"""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_DIAGRAM = pattern(
    r"^([ \t]*```)[ \t]*\{?[ \t]*(?:mermaid|plantuml|puml|uml|dot|graphviz|kroki|ditaa|blockdiag)\b[^\n]*\n"
    r"((?:(?![ \t]*```)[^\n]*\n){1,2000})",
    re.MULTILINE | re.IGNORECASE,
)


def without_diagrams(page: str) -> str:
    """Return a page with the lines of its diagrams empty, so that its other lines keep their numbers."""
    return _DIAGRAM.sub(lambda block: block[1] + "\n" * (block[2].count("\n") + 1), page) if "```" in page else page
