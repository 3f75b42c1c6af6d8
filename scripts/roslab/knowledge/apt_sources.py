"""Package sources that an image has already or needs none of, and the keys of others by https."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def known_sources() -> dict[str, str]:
    """Return the hosts of package sources that are not added, each with the reason."""
    return {row["host"]: row["why"] for row in rows("apt_sources") if row["why"]}


@cache
def keys_of_sources() -> dict[str, str]:
    """Return the address of the key of a host's packages, by https: older pages fetch it without."""
    return {row["host"]: row["key"] for row in rows("apt_sources") if row["key"]}
