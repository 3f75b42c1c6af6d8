"""Folders of the tree in which a page calls make: their Makefiles, and the programs that lie compiled beside them."""

from __future__ import annotations

import posixpath

from roslab.evidence.facts import Mention
from roslab.evidence.native import makefiles, x86_programs
from roslab.evidence.native.recursive_make import MAX_SIZE, NAMES
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace


def with_makefile(mention: Mention, repository: Repository) -> Mention:
    """Return a call of make with the Makefile of its folder, where that lies below the root and compiles that.

    A page may begin above the root: the folder of the tree with the longest path that its path ends with is meant.
    None that CMake compiles.
    """
    place = posixpath.normpath(mention.value.split()[0])
    files = (file for name in NAMES for file in repository.named(name) if file.folder)
    meant = [file for file in files if f"/{place}".endswith(f"/{file.folder}") and file.size <= MAX_SIZE]
    found = max(meant, key=lambda file: len(file.folder), default=None)
    if found is None or repository.has(f"{found.folder}/CMakeLists.txt"):
        return mention
    text = repository.read(found)
    if not (makefiles.compiles(text) and makefiles.compiles_targets(text, mention.value.split()[1:])):
        return mention
    compiled = x86_programs.programs(repository).values()
    beside = (path for path in compiled if path.startswith(f"{found.folder}/"))
    return replace(mention, files=(found.path, *beside))
