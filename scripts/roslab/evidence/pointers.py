"""Files of Git LFS of which the tree has only the pointers: an image gets what is there."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase

from roslab.evidence import places
from roslab.repository.checkout import File, Repository
from roslab.repository.lfs import LARGEST_POINTER, POINTER
from roslab.values.pattern import pattern

_FILTERED = pattern(r"^[ \t]*([^\s#]+)[^\n#]*\bfilter=lfs\b")
_SHOWN = pattern(r"\.(?:png|jpe?g|gif|svg|webp|mp4|webm|mov|pdf)$")
"""Pictures and papers, which pages show."""
MOST = 3
"""Most files that are named."""


def read(repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield one problem, with its file and line, where a program or the build may need what is not there."""
    found: dict[str, tuple[str, int]] = {}
    for attributes in repository.named(".gitattributes"):
        text = repository.read(attributes)
        for number, line in enumerate(text.split("\n") if "filter=lfs" in text else (), 1):
            if match := _FILTERED.match(line):
                for file in repository.once(_pointers):
                    if _means(match[1], file, attributes.folder):
                        found.setdefault(file.path, (attributes.path, number))
    if found:
        names = ", ".join([*found][:MOST]) + (f" and {len(found) - MOST} more" if len(found) > MOST else "")
        what = f"only the pointers of Git LFS are in the tree, and so in the image, of {names}"
        yield f"{what}: what needs them stops; `git lfs pull` fetches them", *next(iter(found.values()))


def _pointers(repository: Repository) -> tuple[File, ...]:
    """Return the files whose content is not there, but for what pages show and what is of tests."""
    return tuple(
        file
        for file in repository.files
        if 0 < file.size < LARGEST_POINTER
        and not (_SHOWN.search(file.name.lower()) or places.documentation(file.path) or places.test(file.path))
        and repository.read(file, limit=LARGEST_POINTER).startswith(POINTER.decode())
    )


def _means(said: str, file: File, folder: str) -> bool:
    """Tell whether a line of the .gitattributes in a folder means a file."""
    wanted, below = said.strip('"').removeprefix("/").removeprefix("**/"), f"{folder}/" if folder else ""
    name = file.name if "/" not in wanted else file.path.removeprefix(below)
    return file.path.startswith(below) and fnmatchcase(name, wanted)
