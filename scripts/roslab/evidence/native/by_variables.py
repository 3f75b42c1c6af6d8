"""Packages of ROS whose files only the variables of their CMake package lead to, where the code uses none of these."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository


def read(repository: Repository) -> frozenset[str]:
    """Return the packages of a table that a CMakeLists.txt requires whose author relies on the compiler's own folders.

    He has Ubuntu's package of it: ROS's lies in folders that neither the compiler nor the linker looks into.
    """
    found: set[str] = set()
    used: set[str] = set()
    for file in repository.named("CMakeLists.txt"):
        text = repository.read(file) if not places.vendored(file.path) else ""
        for row in rows("found_by_variables"):
            name = row["package"]
            if name in text.lower() and re.search(rf"find_package\s*\(\s*{name}\b", text, re.IGNORECASE):
                (used if re.search(row["variables"], text, re.IGNORECASE) else found).add(name)
    return frozenset(found - used)
