"""Files of Git LFS of which the tree has only the pointers: an image gets what is there."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase

from roslab.evidence import places
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_POINTER = "version https://git-lfs.github.com/spec/v1\n"
"""First line of a file whose content is in LFS: https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md"""
_LARGEST = 1023
"""Bytes of a pointer, by the same page."""
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
                for path in _pointers(repository, attributes.folder, match[1]):
                    found.setdefault(path, (attributes.path, number))
    if found:
        names = ", ".join([*found][:MOST]) + (f" and {len(found) - MOST} more" if len(found) > MOST else "")
        what = f"only the pointers of Git LFS are in the tree, and so in the image, of {names}"
        yield f"{what}: what needs them stops; `git lfs pull` fetches them", *next(iter(found.values()))


def _pointers(repository: Repository, folder: str, said: str) -> Iterator[str]:
    """Yield the files that a line of a .gitattributes means and whose content is not there."""
    wanted = said.strip('"').removeprefix("/").removeprefix("**/")
    for file in repository.files:
        small = 0 < file.size <= _LARGEST and file.path.startswith(f"{folder}/" if folder else "")
        if not small or _SHOWN.search(file.name.lower()) or not _means(wanted, file, folder):
            continue
        aside = places.documentation(file.path) or places.test(file.path)
        if not aside and repository.read(file, limit=_LARGEST).startswith(_POINTER):
            yield file.path


def _means(wanted: str, file: File, folder: str) -> bool:
    return fnmatchcase(
        file.name if "/" not in wanted else file.path.removeprefix(f"{folder}/" if folder else ""), wanted
    )
