"""Packages that CMake asks for whose module Ubuntu has in a folder where CMake does not look: ``GeographicLib``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the path of each such module that CMake is to find; not where the tree has one, or names its folder."""
    files = [*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake")]
    for row in rows("modules_aside"):
        name, folder = row["package"], row["file"].rpartition("/")[0]
        texts = [(file, text) for file in files if name in (text := repository.read(file))]
        if not texts or repository.named(f"Find{name}.cmake") or any(folder in text for _, text in texts):
            continue
        for file, text in texts:
            asked = re.search(
                rf"^[ \t]*find_package[ \t]*\([ \t]*{re.escape(name)}\b", text, re.IGNORECASE | re.MULTILINE
            )
            if asked and not (places.vendored(file.path) or places.aside(file.path)):
                line = text.count("\n", 0, asked.end()) + 1
                said = asked[0].strip()
                yield Mention(
                    topic="module_aside", value=row["file"], source="code", file=file.path, line=line, text=said
                )
                break
