"""Folders of the author's own computer in CMake files: what the build takes from them is in no image."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.evidence import places
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_FILES = 300
"""Most CMake files that are searched, those nearest to the root first."""
MAX_SIZE = 64 * 1024
_HOME = pattern(r"^[^#\n]*?(?<![\w/}])(/(?:home|Users)/[A-Za-z][\w.-]*/[\w./+-]*)")


def read(repository: Repository, meant: Collection[tuple[str, int]] = ()) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of the first such folder: the message, the file and the line.

    ``meant``: files and lines that name what the tree has, to which a link leads.
    """
    files = (f for f in repository.named("CMakeLists.txt") if f.size <= MAX_SIZE and not places.vendored(f.path))
    kept = [f for f in files if not places.test(f.path) and not places.example(f.path)]
    first: tuple[str, str, int] | None = None
    found = 0
    for file in sorted(kept, key=lambda f: (f.path.count("/"), f.path))[:MAX_FILES]:
        text = repository.read(file)
        for number, line in enumerate(text.split("\n"), 1) if "/home/" in text or "/Users/" in text else ():
            if (match := _HOME.match(line)) and (file.path, number) not in meant:
                found += 1
                first = first or (match[1], file.path, number)
    if first:
        more = f", and so are {found - 1} more" if found > 2 else ", and so is one more" if found > 1 else ""
        why = "what the build takes from there is not in the image; put it under `source` in roslab.yaml"
        yield f"{first[0]} is a folder of its author's computer{more}: {why}", first[1], first[2]
