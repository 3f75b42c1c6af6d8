"""Archives of sources on the sites of projects whose repositories have a tag for each."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


def source_archive(url: str) -> tuple[str, str, str] | None:
    """Return the repository, the name of the project and the tag of such an archive, ``None`` for another address."""
    for written, repository, tag in _known():
        if match := written.fullmatch(url):
            return repository, match[1], tag.format(match[2])
    return None


@cache
def _known() -> tuple[tuple[re.Pattern[str], str, str], ...]:
    return tuple((pattern(row["pattern"]), row["repository"], row["tag"]) for row in rows("source_archives"))
