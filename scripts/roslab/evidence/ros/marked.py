"""Folders with COLCON_IGNORE, AMENT_IGNORE or CATKIN_IGNORE: the packages in them are no part of the workspace."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.facts import PackageManifest
from roslab.evidence.hidden import IGNORE_MARKERS
from roslab.repository.checkout import Repository


def without(repository: Repository, manifests: Iterable[PackageManifest]) -> Repository:
    """Return the repository without what lies in such folders; the same object where no package lies in any.

    Not without those in a package that is built, whose CMake may take them itself, nor without all packages that there
    are.
    """
    ignored = [f"/{manifest.file}" for manifest in manifests if manifest.ignored]
    kept = tuple(f"/{manifest.file.removesuffix('package.xml')}" for manifest in manifests if not manifest.ignored)
    if not ignored or not kept:
        return repository
    marked = {f"/{file.folder}/" for file in repository.named(*IGNORE_MARKERS) if file.folder}
    left_out = tuple(
        folder for folder in marked if not folder.startswith(kept) and any(m.startswith(folder) for m in ignored)
    )
    return repository.leaving_out({file.path for file in repository.files if f"/{file.path}".startswith(left_out)})
