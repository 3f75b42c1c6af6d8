"""Folders with packages that were copied from elsewhere: unlike most others they have a licence and a page."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.evidence.facts import PackageManifest
from roslab.evidence.packed import packed
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_LICENCES = ("LICENSE", "LICENSE.md", "LICENSE.txt", "LICENCE", "COPYING", "LICENSE.rst", "License.txt")
_PAGES = ("README.md", "README.rst", "README", "README.txt", "Readme.md", "readme.md", "ReadMe.md")
_OF_ROOT = pattern(r"(.+)/(?:\.github/(?:workflows|ISSUE_TEMPLATE)/[^/]+|\.gitmodules|\.travis\.yml)")
"""What is read at the root of a repository alone, behind the folder that it lies in."""
_RECIPES = pattern(r"(?:^|/)\.?docker\w*(?:/.*)?$", re.IGNORECASE)
"""The end of a path in which images are described."""


def read(repository: Repository, manifests: Sequence[PackageManifest]) -> tuple[str, ...]:
    """Return these folders; none where half of the packages lie in such folders, for then all are its own."""
    licensed = {file.folder for file in repository.named(*_LICENCES) if file.folder}
    found = sorted(licensed & {file.folder for file in repository.named(*_PAGES)}) if licensed else []
    inside = [manifest for manifest in manifests if below(manifest.file, found)]
    return tuple(found) if inside and 2 * len(inside) < len(manifests) else ()


def repositories(repository: Repository, manifests: Sequence[PackageManifest]) -> tuple[str, ...]:
    """Return the folders that hold a whole repository of packages: a page and a licence or what only a root has.

    So do those that are called as GitHub packs them.
    """
    own = {manifest.file.rpartition("/")[0] for manifest in manifests}
    licensed = {file.folder for file in repository.named(*_LICENCES)} - {"", *own}
    if manifests:
        licensed |= {match[1] for file in repository.files if (match := _OF_ROOT.fullmatch(file.path))} - own
    found = licensed & {file.folder for file in repository.named(*_PAGES)} if licensed else set[str]()
    found |= {*packed(repository)} - own
    return tuple(folder for folder in sorted(found) if any(below(manifest.file, [folder]) for manifest in manifests))


def below(path: str, folders: Sequence[str]) -> bool:
    """Tell whether a path lies in one of the folders."""
    return any(path.startswith(f"{folder}/") for folder in folders)


def in_copy(repository: Repository, file: File) -> bool:
    """Tell whether a Dockerfile lies in a copy of another project: below a folder with a page and a licence of its own.

    The repository has packages outside of it, or a page and a licence at its root, too.
    """
    names = _RECIPES.sub("", file.folder).split("/")
    parts = ["/".join(names[:end]) for end in range(len(names), 0, -1)]
    whole = repository.once(_whole_projects)
    part = next((part for part in parts if part and part in whole), None)
    if part is None:
        return False
    outside = any(not manifest.path.startswith(f"{part}/") for manifest in repository.named("package.xml"))
    return outside or "" in whole


def _whole_projects(repository: Repository) -> frozenset[str]:
    """Return the folders that have a page and a licence."""
    pages, licences = (_folders_with(repository, *stems) for stems in (("readme",), ("license", "licence", "copying")))
    return pages & licences


def _folders_with(repository: Repository, *stems: str) -> frozenset[str]:
    found = (files for name, files in repository.by_name.items() if name.partition(".")[0] in stems)
    return frozenset(file.folder for files in found for file in files)
