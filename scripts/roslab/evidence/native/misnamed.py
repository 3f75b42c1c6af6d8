"""Variables of CMake that a package's own file does not set: ``${Eigen3_INCLUDE_DIRS}`` is empty on every Ubuntu."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[tuple[str, str], ...]:
    """Return the variables of a table that a CMakeLists.txt uses, each with its value, where none sets them.

    Code that other packages' include folders happen to reach compiles without it.
    """
    found: dict[str, str] = {}
    for file in repository.named("CMakeLists.txt"):
        text = repository.read(file) if not places.vendored(file.path) else ""
        for row in rows("misnamed_variables") if "_INCLUDE_DIR" in text else ():
            name = row["variable"]
            if f"${{{name}}}" in text and re.search(rf"find_package\s*\(\s*{row['package']}\b", text, re.IGNORECASE):
                found[name] = row["value"]
    if not found:
        return ()
    texts = [repository.read(file) for file in repository.named("CMakeLists.txt")]
    texts += [repository.read(file) for file in repository.suffixed(".cmake")]
    given = re.compile(
        rf"(?:set|find_path|get_target_property)\s*\(\s*({'|'.join(map(re.escape, found))})\b", re.IGNORECASE
    )
    set_here = {match[1] for text in texts for match in given.finditer(text)}
    return tuple((name, value) for name, value in sorted(found.items()) if name not in set_here)
