"""What every ROS graph has, whatever the repository does: it says nothing of the repository."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


def belongs(ros: str, part: str, name: str) -> bool:
    """Tell whether a ``node``, ``topic``, ``service`` or ``player`` of ``ros1`` or ``ros2`` is ROS's own."""
    return any(each.search(name) for each in _patterns(ros, part))


@cache
def _patterns(ros: str, part: str) -> tuple[re.Pattern[str], ...]:
    return tuple(pattern(row["pattern"]) for row in rows("graphs") if (row["ros"], row["part"]) == (ros, part))
