"""Folders of headers that wheels of Python, or CUDA's toolkit, bring for extensions under another name."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def wheel_headers() -> dict[str, str]:
    """Return the pip package that brings each folder, ``""`` for CUDA's toolkit."""
    return {row["folder"]: row["pip"] for row in rows("wheel_headers")}
