"""Repositories of ROS 1 with packages that many others start and that nobody released."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.knowledge.table import rows


def holders(names: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """Return the addresses of repositories that hold some of these packages, each with those."""
    wanted = tuple(names)
    found = {row["repo"]: tuple(name for name in wanted if name in row["packages"].split()) for row in rows("holders")}
    return {repo: held for repo, held in found.items() if held}
