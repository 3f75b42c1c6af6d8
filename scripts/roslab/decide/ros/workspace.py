"""Which packages are built, and whether the repository is the workspace or a folder of one."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from functools import cache
from typing import Literal

from roslab.config.model import BuildTool, Kind
from roslab.decide.ros.base_paths import base_paths
from roslab.decide.ros.other_workspaces import Launches, other_workspaces, page_launches, started
from roslab.decide.ros.unbuildable import unbuildable
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.evidence.ros.conditions import holds
from roslab.evidence.ros.needed_inside import needed_inside
from roslab.evidence.ros.rosbuild import BUILD_TYPE
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

RosVersion = Literal[1, 2]
_CALLED = {"ros1": "catkin", "ros2": "ament"}
"""The family of CMake's macros that packages of a kind call."""
_ASSET = pattern(r"(?:^|/)(?:assets?|data|resources?|urdfs?|meshes|models)(?:/|$)", re.IGNORECASE)
"""Folders of robot descriptions: programs read a package there, it is not built."""
_MADE = pattern(r"(?:^|/)(?:build|devel|install)/")
"""Folders that a build tool writes: a copy in one of them is not the source, however near to the root."""
_CATKIN = frozenset({"catkin", "catkin_simple", "roscpp", "rospy"})
_AMENT = frozenset({"ament_cmake", "ament_python", "ament_cmake_auto", "ament_cmake_ros", "rosidl_default_generators"})
"""A package built with one of these is a catkin or ament package, whatever its build type says."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Packages:
    """The packages of a repository; each manifest is in one of the three groups."""

    built: tuple[PackageManifest, ...]
    assets: tuple[PackageManifest, ...]
    """Robot descriptions that programs read: in a folder of assets, or without what their tool builds a package by."""
    left_out: tuple[PackageManifest, ...]
    """Ignored by a marker, copied in, nested in another package, or unreadable."""

    names: frozenset[str]
    """Names of all packages, also of those not built if others do not need them built: none is a key for rosdep."""
    doubles: tuple[str, ...] = ()
    """Folders with packages of names that are built already, or of the other ROS: a tool that finds them stops."""
    nested: tuple[PackageManifest, ...] = ()
    """Of those left out, the ones inside a package whose CMakeLists.txt adds their folders whatever the options are."""


def packages_of(evidence: Evidence) -> Packages:
    """Sort the manifests of a repository."""
    if any(map(of_rosbuild, evidence.manifests)):
        return _of_rosbuild(evidence.manifests, whole=built_by_rosbuild(evidence))
    found = _packages(
        evidence.manifests,
        tuple(p.file for p in evidence.cmake),
        tuple(p.folder for p in evidence.python),
        tuple(p.file for p in evidence.cmake if p.always),
        launches=page_launches(evidence),
        told=base_paths(evidence),
    )
    lost = unbuildable(found.assets, found.built, evidence.cmake)
    return replace(found, names=found.names - lost) if lost else found


def of_rosbuild(manifest: PackageManifest) -> bool:
    """Tell whether it is a manifest.xml or stack.xml."""
    return manifest.build_types[:1] == ((BUILD_TYPE, None),)


def built_by_rosbuild(evidence: Evidence) -> bool:
    """Tell whether rosbuild builds every CMake project nearest to the root, not only a part."""
    tops = [project for project in evidence.cmake if not places.vendored(project.file)]
    nearest = min((project.file.count("/") for project in tops), default=0)
    return bool(tops) and all("rosbuild" in p.macros for p in tops if p.file.count("/") == nearest)


@cache
def _of_rosbuild(manifests: tuple[PackageManifest, ...], *, whole: bool) -> Packages:
    """Sort the manifests of rosbuild, which builds whatever has one; ``whole``: the repository is nothing else."""
    built: list[PackageManifest] = []
    kept: set[str] = set()
    for manifest in sorted(manifests, key=lambda m: (m.file.count("/"), m.file)):
        folder = manifest.file.rpartition("/")[0]
        if whole and not _below(folder, kept):
            built.append(manifest)
            kept |= set() if manifest.metapackage else {folder}  # rospack looks for packages in a stack's folder
    return Packages(
        built=tuple(sorted(built, key=lambda m: m.file)),
        assets=(),
        left_out=tuple(m for m in manifests if m not in built),
        names=frozenset(m.name for m in manifests if m.name),
    )


@cache
def _packages(
    manifests: tuple[PackageManifest, ...],
    cmake: tuple[str, ...],
    python: tuple[str, ...],
    always: tuple[str, ...],
    *,
    launches: Launches,
    told: tuple[str, ...],
) -> Packages:
    """Sort the manifests; ``cmake`` are the CMakeLists.txt, ``python`` the folders that Python's tools can install.

    ``always``: those CMakeLists.txt that others add whatever the options are; ``launches``: what pages start. Of copies
    of a package at the same depth the one with what is started first is built. ``told``: where pages have colcon look.
    """
    built: list[PackageManifest] = []
    assets: list[PackageManifest] = []
    left_out: list[PackageManifest] = []
    by_cmake = frozenset(file.rpartition("/")[0] for file in cmake)
    buildable = by_cmake | set(python)
    seen: set[str] = set()
    doubles = other_workspaces(manifests, launches)
    kept = set(doubles)
    run = started([manifest.file.rpartition("/")[0] for manifest in manifests], launches)

    def order(manifest: PackageManifest) -> tuple[bool, int, bool, str]:
        file = manifest.file
        return bool(_MADE.search(file)), file.count("/"), file.rpartition("/")[0] not in run, file

    for manifest in sorted(manifests, key=order):
        folder = manifest.file.rpartition("/")[0]
        if manifest.ignored or manifest.name is None or _below(folder, kept):
            left_out.append(manifest)
        elif manifest.name in seen:
            left_out.append(manifest)
            doubles.add(folder)
        elif (
            not (folder in buildable or manifest.metapackage)
            or nothing_builds(manifest, by_cmake)
            or (_ASSET.search(folder) and len(manifests) > 1)
        ):
            assets.append(manifest)
        else:
            built.append(manifest)
            seen.add(manifest.name)
            kept.add(folder)
    vendored = [m for m in built if places.vendored(m.file)]
    beside = len(vendored) < len(built) and all(types(m) <= {"cmake"} for m in vendored)
    if beside or (len(vendored) == len(built) and "CMakeLists.txt" in cmake):
        left_out += vendored  # another package of the tree, or the project at its root, builds these itself
        built = [m for m in built if m not in vendored]
    added = {file.rpartition("/")[0] for file in always}
    folders = {manifest.file.rpartition("/")[0] for manifest in built}
    possible, inside = buildable - added, {m.file.rpartition("/")[0]: m for m in left_out if m.name not in seen}
    found = [m for f, m in inside.items() if f in possible and _below(f, folders) and not _below(f, doubles)]
    inner = {m.file: m for m in needed_inside(built, found, told)}
    built += inner.values()
    return Packages(
        built=tuple(sorted(built, key=lambda m: m.file)),
        assets=tuple(assets),
        left_out=tuple(m for m in left_out if m.file not in inner),
        names=frozenset(m.name for m in manifests if m.name),
        doubles=tuple(sorted(doubles - {""})),
        nested=tuple(_added_to(built, left_out, added)),
    )


def _added_to(
    built: Iterable[PackageManifest], others: Iterable[PackageManifest], always: Collection[str]
) -> Iterator[PackageManifest]:
    """Yield the manifests inside packages that are built, in folders that these always add."""
    folders = {manifest.file.rpartition("/")[0] for manifest in built}
    for manifest in others:
        folder = manifest.file.rpartition("/")[0]
        if manifest.name and not manifest.ignored and folder in always and _below(folder, folders):
            yield manifest


def _below(folder: str, folders: set[str]) -> bool:
    """Tell whether a folder lies inside another package, where neither catkin nor colcon looks."""
    while folder:
        folder = folder.rpartition("/")[0]
        if folder in folders:
            return True
    return False


def types(manifest: PackageManifest, ros: RosVersion | None = None) -> frozenset[str]:
    """Return the build types for a ROS version, for both versions if none is given."""
    versions: Iterable[RosVersion] = (ros,) if ros else (1, 2)
    return frozenset(
        name
        for version in versions
        for name, condition in manifest.build_types
        if holds(condition, {"ROS_VERSION": str(version)})
    )


def ros_versions(manifest: PackageManifest, macros: tuple[str, ...] = ()) -> frozenset[int]:
    """Return the ROS versions that a package is made for; none for plain CMake.

    ``macros`` are the macro families that its CMakeLists.txt calls. A package with build types of both versions and no
    condition counts as one for ROS 2.
    """
    found = set()
    if _for_catkin(manifest, macros):
        found.add(1)
    if _for_ament(manifest):
        found.add(2)
    if len(found) == 2 and not any(condition for _, condition in manifest.build_types):
        found.discard(1)
    return frozenset(found)


def of_one_ros(packages: Packages, evidence: Evidence, kind: Kind) -> Packages:
    """Return the packages without those that are made for the other ROS alone, whose folders no tool looks into."""
    made = made_for(packages.built if kind in _CALLED else (), evidence)
    others = [manifest for manifest, versions in made if versions and kind not in versions]
    if not others or len(others) == len(packages.built):
        return packages
    folders = {manifest.file.rpartition("/")[0] for manifest in others}
    return replace(
        packages,
        built=tuple(manifest for manifest in packages.built if manifest not in others),
        left_out=(*packages.left_out, *others),
        doubles=tuple(sorted({*packages.doubles, *folders} - {""})),
    )


def made_for(
    manifests: Iterable[PackageManifest], evidence: Evidence
) -> tuple[tuple[PackageManifest, frozenset[str]], ...]:
    """Return each package with the kinds of image that it is made for; none for plain CMake and rosbuild.

    Whatever a manifest says, a package is also for the ROS whose macros its CMakeLists.txt calls.
    """
    macros = {project.file.rpartition("/")[0]: project.macros for project in evidence.cmake}

    def kinds(manifest: PackageManifest) -> frozenset[str]:
        called = macros.get(manifest.file.rpartition("/")[0], ())
        found = {f"ros{version}" for version in ros_versions(manifest, called)}
        if not found or of_rosbuild(manifest):
            return frozenset()
        return frozenset(found | {kind for kind, family in _CALLED.items() if family in called})

    return tuple((manifest, kinds(manifest)) for manifest in manifests)


def _for_catkin(manifest: PackageManifest, macros: tuple[str, ...]) -> bool:
    if not (named := types(manifest, 1)):  # all are for ROS 2: catkin is the default of the standard (REP 149)
        return bool(_built_with(manifest, 1) & _CATKIN)
    if not any(name.startswith("catkin") for name in named):
        return False
    if manifest.build_types != (("catkin", None),) or _built_with(manifest, 1) & _CATKIN:
        return True
    return "catkin" in macros  # the file names no build type, and catkin is only the default of the standard


def nothing_builds(manifest: PackageManifest, by_cmake: Collection[str]) -> bool:
    """Tell whether a package is for catkin alone, which takes none without a CMakeLists.txt, and has none.

    ``by_cmake`` are the folders that have one; a metapackage may do without.
    """
    if manifest.metapackage or manifest.file.rpartition("/")[0] in by_cmake:
        return False
    return _for_catkin(manifest, ()) and not _for_ament(manifest)


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


def names_of(packages: Packages, kind: Kind, left_out: Collection[str], build_tool: BuildTool) -> tuple[str, ...]:
    """Return the packages that ``rospack`` or ``ros2 pkg`` must find, without those left out.

    rospack does not list metapackages. https://github.com/ros/rospack/issues/26 Nor does it look at the source of plain
    CMake packages where catkin_make_isolated gives each a space of its own. https://github.com/ros/catkin (builder.py)
    """
    built = [m for m in packages.built if kind in {"ros1", "ros2"} and not (kind == "ros1" and m.metapackage)]
    if build_tool == "catkin_make_isolated":
        built = [manifest for manifest in built if types(manifest, 1) != {"cmake"}]
    return tuple(sorted(manifest.name for manifest in built if manifest.name and manifest.name not in left_out))


def manifests_of(packages: Packages, left_out: Collection[str]) -> tuple[str, ...]:
    """Return the files whose keys are installed: of what is built, and of what that adds; without those left out."""
    built = [manifest for manifest in packages.built if manifest.name not in left_out]
    folders = {manifest.file.rpartition("/")[0] for manifest in built}
    nested = [m.file for m in packages.nested if _below(m.file.rpartition("/")[0], folders)]
    return tuple(sorted([*(manifest.file for manifest in built), *nested]))
