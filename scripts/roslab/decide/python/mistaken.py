"""Lines of a list that name a package by mistake: the module of that name is another package's of the same list.

Tools that write a list from imports, as pipreqs does, take a package for each module.
"""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.mistaken_packages import mistaken_packages
from roslab.values.requirement import Requirement


def mistaken(found: Iterable[Requirement]) -> dict[Requirement, Warning_]:
    """Return the requirements that are left out, each with the warning about it."""
    asked = [each for each in found if each.package and not each.role]
    names = {each.key for each in asked}
    left: dict[Requirement, Warning_] = {}
    for each in asked:
        row = mistaken_packages().get(each.key)
        if row and row.beside in names and not each.url:
            why = f"{each.key} of pip's index is another package, and {row.beside} brings the module {row.module}"
            left[each] = warn(f"{each.written} is left out: {why}; delete the line ({row.source})", each)
    return left
