"""What the build backend of a project must be older than, by its own settings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from packaging.version import Version

from roslab.knowledge.backend_settings import backend_settings
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def backend_limits(
    tool: dict[str, Any], path: str, line_of: Callable[[str], int], build: Sequence[Requirement]
) -> Iterator[Requirement]:
    """Yield a limit for each backend without one whose newer releases stop at a setting of a pyproject.toml.

    ``tool`` is its table of that name, ``build`` what it is built with.
    """
    free = {each.key: each.at_least for each in build if not each.limited}
    for known in backend_settings():
        if known.limit.key not in free or not _has(tool, known.keys) or _has(tool, known.unless):
            continue
        floor = free.pop(known.limit.key)
        if not floor or Version(floor) < Version(known.limit.below or "0"):
            yield stated(known.limit.text, "build", path, line_of(".".join(known.keys[1:])))


def _has(data: Any, keys: Sequence[str]) -> bool:
    for key in keys:
        if not isinstance(data, dict) or key not in data:
            return False
        data = data[key]
    return True
