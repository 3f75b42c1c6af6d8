"""Packages of authors' Dockerfiles that serve a person at a terminal, or only go with another source of packages."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import one_of


@cache
def authors_own(*, ros: bool) -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them in apt; ``ros``: the image has packages of ROS."""
    return one_of(row["pattern"] for row in rows("authors_own") if not (ros and row["of"] == "ros"))
