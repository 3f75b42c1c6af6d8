"""Packages of conda, or builds of them, that one channel has and no other: a list without channels tells by them."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def channel_builds() -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Return each channel with how a line of it is written, whole: ``name=version=build``."""
    return tuple((row["channel"], pattern(row["builds"])) for row in rows("channel_builds"))
