"""Packages of ROS that only a vendor's own software brings or compiles, and where that is installed from."""

from __future__ import annotations

from roslab.knowledge.table import rows


def vendor_of(name: str) -> tuple[str, str]:
    """Return what a package needs, in words, and the address of its installer; empty for one that needs no vendor's."""
    found = ((row["needs"], row["address"]) for row in rows("vendor_packages") if name.startswith(row["begins"]))
    return next(found, ("", ""))
