"""Packages of authors' Dockerfiles and pages that serve a person, or only go with another source of packages."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import one_of


@cache
def authors_own(*, ros: bool, page: bool = False, latex: bool = False) -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them in apt.

    ``ros``: the image has packages of ROS. ``page``: a page or a script installs them, not a Dockerfile; of terminals
    it may mean those in which a launch file starts nodes. ``latex``: CMake requires LaTeX.
    """
    but = {*(["ros"] if ros else ()), *(["terminals"] if page else ()), *(["latex"] if latex else ())}
    return one_of(row["pattern"] for row in rows("authors_own") if row["of"] not in but)
