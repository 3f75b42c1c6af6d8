"""The folders of headers by which libraries that people copy into their trees are known."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def copied_libraries() -> dict[str, str]:
    """Return the names of the folders: ``Eigen``, ``igl``, ``boost``; with what one holds whose name others have, too.

    ``eigen`` is a copy of the whole library where it holds ``Eigen``.
    """
    return {row["folder"]: row["holds"] for row in rows("copied_libraries")}
