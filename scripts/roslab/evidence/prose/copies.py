"""Folders with packages that were copied from elsewhere: unlike most others they have a licence and a page."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.evidence.facts import PackageManifest
from roslab.repository.checkout import Repository

_LICENCES = ("LICENSE", "LICENSE.md", "LICENSE.txt", "LICENCE", "COPYING", "LICENSE.rst", "License.txt")
_PAGES = ("README.md", "README.rst", "README", "README.txt", "Readme.md", "readme.md", "ReadMe.md")


def read(repository: Repository, manifests: Sequence[PackageManifest]) -> tuple[str, ...]:
    """Return these folders; none where half of the packages lie in such folders, for then all are its own."""
    licensed = {file.folder for file in repository.named(*_LICENCES) if file.folder}
    found = sorted(licensed & {file.folder for file in repository.named(*_PAGES)}) if licensed else []
    inside = [manifest for manifest in manifests if below(manifest.file, found)]
    return tuple(found) if inside and 2 * len(inside) < len(manifests) else ()


def below(path: str, folders: Sequence[str]) -> bool:
    """Tell whether a path lies in one of the folders."""
    return any(path.startswith(f"{folder}/") for folder in folders)
