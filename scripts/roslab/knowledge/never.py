"""Packages that pages name but no image can use: drivers, kernels, the Docker engine itself."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import one_of


@cache
def never(*, cuda: bool = False) -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them; ``cuda``: the image has CUDA's compiler."""
    beside = {"", "cuda"} if cuda else {""}
    return one_of(row["pattern"] for row in rows("never") if row["beside"] in beside)
