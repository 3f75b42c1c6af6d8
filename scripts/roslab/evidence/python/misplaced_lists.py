"""Lists that others include by a path that the tree does not have, while one of that name lies further down."""

from __future__ import annotations

import posixpath

from roslab.evidence import places
from roslab.evidence.facts import RequirementFile
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace


def with_misplaced(repository: Repository, file: RequirementFile) -> RequirementFile:
    """Return a list that includes the one file of a missing one's name below that one's folder in its place.

    The root is no such folder: any list of the tree lies below it. Nor is vendored code meant.
    """
    taken = {path: _below(repository, path) for path in file.includes if not repository.has(path)}
    found = tuple(
        (path, taken[path], line)
        for path, line in zip(file.includes, file.include_lines, strict=True)
        if taken.get(path) not in {None, "", file.file}
    )
    instead = {path: other for path, other, _ in found}
    includes = tuple(instead.get(path, path) for path in file.includes)
    return replace(file, includes=includes, misplaced=found) if found else file


def _below(repository: Repository, path: str) -> str:
    folder, name = posixpath.split(path)
    same = [file.path for file in repository.named(name) if folder and file.path.startswith(f"{folder}/")]
    same = [each for each in same if each.endswith(f"/{name}") and not places.vendored(each)]
    return same[0] if len(same) == 1 else ""
