"""``packaging``'s readers of requirements, which are imported only where a line needs them.

Their patterns wait for their first use, and are kept, as those of ``packaging.version``.
"""

from __future__ import annotations

from roslab.values.pattern import postponed

with postponed():
    from packaging.markers import InvalidMarker, Marker, UndefinedComparison
    from packaging.requirements import InvalidRequirement, Requirement
    from packaging.specifiers import InvalidSpecifier, Specifier, SpecifierSet

__all__ = [
    "InvalidMarker",
    "InvalidRequirement",
    "InvalidSpecifier",
    "Marker",
    "Requirement",
    "Specifier",
    "SpecifierSet",
    "UndefinedComparison",
]
