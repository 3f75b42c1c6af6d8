"""Plugins whose classes are called after something else than the package that holds them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def _packages() -> dict[str, str]:
    return {row["prefix"]: row["package"] for row in rows("plugin_classes")}


def plugin_package(prefix: str) -> str:
    """Return the package of a plugin by what stands before its name: ``slam_toolbox`` of ``solver_plugins::…``.

    That is what nearly all are called after; ``""`` where it is no package at all.
    """
    return _packages().get(prefix, prefix)
