"""The packages of further plugins that a plugin loads by short names or by default, without depending on them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def plugin_companions() -> Mapping[str, tuple[str, ...]]:
    """Return what the plugins of each package load: the critics of ``dwb_core`` are named ``RotateToGoal``."""
    return {row["package"]: tuple(row["loads"].split()) for row in rows("plugin_companions")}
