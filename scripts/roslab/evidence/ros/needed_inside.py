"""Packages of ROS 2 inside the folder of another package, which colcon builds where it is told of them.

Those that the outer one needs and no distribution released: there is no other one that the author can have had. And
those of which a page tells colcon.
"""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable, Iterator

from roslab.evidence.facts import PackageManifest
from roslab.knowledge.released import ever_released

_NEEDS = frozenset({"buildtool", "build", "build_export", "exec"})


def needed_inside(
    outer: Iterable[PackageManifest], inner: Iterable[PackageManifest], told: Collection[str] = ()
) -> Iterator[PackageManifest]:
    """Yield those of the inner packages that one of the outer ones needs, or one that is itself taken.

    ``told``: the names of the folders in which pages have colcon look.
    """
    left: dict[str, PackageManifest] = {}
    for each in inner:
        if each.name and not each.ignored and _of_ament(each):
            left.setdefault(each.name, each)
    shown = {name for name, each in left.items() if posixpath.basename(posixpath.dirname(each.file)) in told}
    wanted = [*(name for name in left if name in shown), *(name for manifest in outer for name in _needs(manifest))]
    while wanted:
        found = wanted.pop()
        manifest = left.pop(found, None)
        if manifest and (found in shown or not ever_released(found)):
            wanted += _needs(manifest)
            yield manifest


def _needs(manifest: PackageManifest) -> list[str]:
    """Return the packages that a package of ROS 2 needs to be built or to run."""
    named = manifest.dependencies if _of_ament(manifest) and not manifest.ignored else ()
    return [each.name for each in named if each.role in _NEEDS]


def _of_ament(manifest: PackageManifest) -> bool:
    return any(name.startswith("ament") for name, _ in manifest.build_types)
