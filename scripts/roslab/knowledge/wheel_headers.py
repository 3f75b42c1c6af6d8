"""Folders of headers that wheels of Python, or CUDA's toolkit, bring for extensions under another name."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def wheel_headers() -> frozenset[str]:
    """Return the folders; the table also tells which pip package brings each, none for those of CUDA's toolkit."""
    return frozenset(row["folder"] for row in rows("wheel_headers"))
