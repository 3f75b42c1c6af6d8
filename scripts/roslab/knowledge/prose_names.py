"""Python packages by the names that people write them with in a sentence or a list."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.frameworks import imports
from roslab.knowledge.table import rows
from roslab.values.name import canonicalize_name


@cache
def _names() -> dict[str, str]:
    known = {canonicalize_name(pip): pip for pip, _ in imports().values() if pip}
    return known | {canonicalize_name(row["name"].replace(" ", "-")): row["pip"] for row in rows("prose_names")}


def package_of(name: str) -> str | None:
    """Return what pip calls a package that a person calls ``PyTorch`` or ``scikit image``, ``None`` if unknown."""
    return _names().get(canonicalize_name(re.sub(r"\s+", "-", name.strip())))


@cache
def said_names() -> str:
    """Return a pattern of the names whose versions count in a sentence: of pip's package, and of nothing beside it."""
    names = sorted((row["name"] for row in rows("said_names")), key=len, reverse=True)
    return "|".join(re.escape(name).replace(r"\ ", "[- ]") for name in names)
