"""Libraries that CMake finds and a page clones: pip's package of that name would be a second one beside it."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.name import canonicalize_name


def built_here(evidence: Evidence) -> frozenset[str]:
    """Return their normalised names; what CMake only tries to find may be missing, and so comes from pip."""
    cloned = {canonicalize_name(git.name) for git in evidence.sources if git.kind == "clone"}
    asked = (each for made in evidence.cmake if not places.aside(made.file) for each in made.dependencies)
    found = {
        canonicalize_name(each.name) for each in asked if each.namespace == "cmake" and each.strength == "declared"
    }
    return frozenset(cloned & found)
