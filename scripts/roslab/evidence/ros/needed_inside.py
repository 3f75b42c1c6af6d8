"""Packages of ROS 2 inside the folder of a package that needs them, which colcon builds where it is told of them.

No distribution released them: there is no other one that the author can have had.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import PackageManifest
from roslab.knowledge.released import ever_released

_NEEDS = frozenset({"buildtool", "build", "build_export", "exec"})


def needed_inside(outer: Iterable[PackageManifest], inner: Iterable[PackageManifest]) -> Iterator[PackageManifest]:
    """Yield those of the inner packages that one of the outer ones needs, or one that is itself needed."""
    needed = {name for manifest in outer for name in _needs(manifest)}
    left: dict[str, PackageManifest] = {}
    for each in inner:
        if each.name and not each.ignored and _of_ament(each):
            left.setdefault(each.name, each)
    while found := next((name for name in left if name in needed), None):
        manifest = left.pop(found)
        if not ever_released(found):
            needed |= _needs(manifest)
            yield manifest


def _needs(manifest: PackageManifest) -> set[str]:
    """Return the packages that a package of ROS 2 needs to be built or to run."""
    named = manifest.dependencies if _of_ament(manifest) and not manifest.ignored else ()
    return {each.name for each in named if each.role in _NEEDS}


def _of_ament(manifest: PackageManifest) -> bool:
    return any(name.startswith("ament") for name, _ in manifest.build_types)
