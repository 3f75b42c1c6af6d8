"""Languages in which pages are translated, by the codes in the names of their files and folders."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def page_languages() -> frozenset[str]:
    """Return the codes in lower case with hyphens, ``zh-cn``, without English."""
    return frozenset(row["code"] for row in rows("page_languages"))
