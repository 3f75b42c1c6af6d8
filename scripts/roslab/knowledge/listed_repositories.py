"""The repositories that ROS distributions list, under their own or another name, by their owners at GitHub."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def _owners() -> dict[str, str]:
    return {name: row["owner"] for row in rows("listed_repositories") for name in row["repositories"].split()}


def listed_repository(name: str) -> str:
    """Return the address of the repository of that name, of the first distribution that lists one, ``""`` for none."""
    owner = _owners().get(name)
    return f"https://github.com/{owner}/{name}.git" if owner else ""
