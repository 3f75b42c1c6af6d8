"""Which packages are built, and whether the repository is the workspace or a folder of one."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.evidence.ros.conditions import holds

RosVersion = Literal[1, 2]
_ASSET = re.compile(r"(?:^|/)(?:assets?|data|resources?|urdfs?|meshes|models)(?:/|$)", re.IGNORECASE)
"""Folders of robot descriptions: a package there is read by a program, not built with it."""

_CATKIN = frozenset({"catkin", "catkin_simple", "roscpp", "rospy"})
_AMENT = frozenset({"ament_cmake", "ament_python", "ament_cmake_auto", "ament_cmake_ros", "rosidl_default_generators"})
"""Who is built with one of these is built by catkin or by ament, whatever its build type says."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Packages:
    """The packages of a repository; each manifest stands in one of the three."""

    built: tuple[PackageManifest, ...]
    assets: tuple[PackageManifest, ...]
    """Among assets, or no CMakeLists.txt and no setup.py beside it: a robot's description that a program reads."""
    left_out: tuple[PackageManifest, ...]
    """Ignored by a marker, copied in, nested in another package, or unreadable."""

    names: frozenset[str]
    """Names of all, also of what is not built: none of them is a key for rosdep."""


def packages_of(evidence: Evidence) -> Packages:
    """Sort the manifests of a repository."""
    return _packages(
        evidence.manifests, tuple(p.file for p in evidence.cmake), tuple(p.folder for p in evidence.python)
    )


@cache
def _packages(manifests: tuple[PackageManifest, ...], cmake: tuple[str, ...], python: tuple[str, ...]) -> Packages:
    """Sort the manifests; ``cmake`` are the CMakeLists.txt, ``python`` the folders that Python's tools can install."""
    built: list[PackageManifest] = []
    assets: list[PackageManifest] = []
    left_out: list[PackageManifest] = []
    buildable = {file.rpartition("/")[0] for file in cmake} | set(python)
    kept: set[str] = set()
    seen: set[str] = set()
    for manifest in sorted(manifests, key=lambda m: (m.file.count("/"), m.file)):
        folder = manifest.file.rpartition("/")[0]
        if manifest.ignored or manifest.name is None or _below(folder, kept) or manifest.name in seen:
            left_out.append(manifest)
        elif (folder not in buildable and not manifest.metapackage) or (_ASSET.search(folder) and len(manifests) > 1):
            assets.append(manifest)
        else:
            built.append(manifest)
            seen.add(manifest.name)
            kept.add(folder)
    vendored = [m for m in built if places.vendored(m.file)]
    if len(vendored) < len(built) and all(types(m) <= {"cmake"} for m in vendored):
        left_out += vendored  # libraries that another package of the tree adds itself
        built = [m for m in built if m not in vendored]
    return Packages(
        built=tuple(sorted(built, key=lambda m: m.file)),
        assets=tuple(assets),
        left_out=tuple(left_out),
        names=frozenset(m.name for m in manifests if m.name),
    )


def _below(folder: str, folders: set[str]) -> bool:
    """Tell whether a folder lies inside another package, where neither catkin nor colcon looks."""
    while folder:
        folder = folder.rpartition("/")[0]
        if folder in folders:
            return True
    return False


def types(manifest: PackageManifest, ros: RosVersion | None = None) -> frozenset[str]:
    """Return the build types that hold for a ROS version, for either where none is given."""
    versions: Iterable[RosVersion] = (ros,) if ros else (1, 2)
    return frozenset(
        name
        for version in versions
        for name, condition in manifest.build_types
        if holds(condition, {"ROS_VERSION": str(version)})
    )


def ros_versions(manifest: PackageManifest, macros: tuple[str, ...] = ()) -> frozenset[int]:
    """Return the ROS versions that a package is made for; none for plain CMake.

    ``macros`` are the families that its CMakeLists.txt calls. A package for both that has no condition is ament's.
    """
    found = set()
    if _for_catkin(manifest, macros):
        found.add(1)
    if _for_ament(manifest):
        found.add(2)
    if len(found) == 2 and not any(condition for _, condition in manifest.build_types):
        found.discard(1)
    return frozenset(found)


def _for_catkin(manifest: PackageManifest, macros: tuple[str, ...]) -> bool:
    if not any(name.startswith("catkin") for name in types(manifest, 1)):
        return False
    if manifest.build_types != (("catkin", None),) or _built_with(manifest, 1) & _CATKIN:
        return True
    return "catkin" in macros  # the file says nothing: catkin is only the standard's default


def _for_ament(manifest: PackageManifest) -> bool:
    names = types(manifest, 2)
    if any(name.startswith("ament") for name in names):
        return True
    return bool(_built_with(manifest, 2) & _AMENT) and not names - {"catkin"}


def _built_with(manifest: PackageManifest, ros: RosVersion) -> set[str]:
    """Return the names that a package needs to be built under a version of ROS."""
    variables = {"ROS_VERSION": str(ros)}
    needs = (d for d in manifest.dependencies if d.role in {"buildtool", "build"})
    return {d.name for d in needs if holds(d.condition, variables)}
