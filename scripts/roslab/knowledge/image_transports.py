"""The ROS packages that bring the transports of image_transport, which loads them as plugins."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def image_transports() -> Mapping[str, str]:
    """Return the package of each transport: ``theora``."""
    return {row["transport"]: row["ros"] for row in rows("image_transports")}
