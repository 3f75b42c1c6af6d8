"""Packages that are left out of the build because of what they lack, with those that cannot be built without them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from types import MappingProxyType

from roslab.config.model import BuildTool
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import Packages
from roslab.evidence.dependency import Dependency
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

SKIP: dict[BuildTool, str] = {
    "colcon": "--packages-skip",
    "catkin_make": "-DCATKIN_BLACKLIST_PACKAGES=",
    "catkin_make_isolated": "",
    "catkin_tools": "",
}
"""How a build tool leaves packages out: by an argument, or by a marker in their folders, which all
releases of catkin_tools and of catkin_make_isolated know. https://colcon.readthedocs.io/en/released/reference/package-selection-arguments.html
https://docs.ros.org/en/api/catkin/html/dev_guide/generated_cmake_api.html"""
_LETTERS = "CMake requires {name}, and the tree has {other}: CMake tells letters apart, and {then}; write {other} there"
_OF_MODULES = pattern(r"cmake[-_]?modules?$")
SOURCE = "give its repository under `source` in roslab.yaml"


@dataclass(frozen=True, kw_only=True, slots=True)
class LeftOut:
    """What is not built."""

    packages: tuple[str, ...]
    """By name, whatever the image has."""
    lacking: tuple[tuple[str, tuple[str, ...]], ...]
    """What a clone may bring, each with the folders of the packages that are not built where none does."""
    warnings: tuple[Warning_, ...]
    stops: tuple[str, ...] = ()
    """Names that a package requires which is not left out: the build stops where nothing brings them."""


def leave_out(
    lacking: Mapping[tuple[str, str], Dependency],
    packages: Packages,
    build_tool: BuildTool,
    *,
    started: Collection[str],
    left: Collection[str],
    tried: Mapping[str, str],
    alike: Mapping[str, str] = MappingProxyType({}),
) -> LeftOut:
    """Return what is left out, as far as something else is built and nothing of it is started.

    ``lacking``: packages, each with a name that CMake requires and nothing brings; ``left``: packages that are left out
    already. ``tried``: where the build looks for such names: what needs these is left out only in the image, where
    none holds them. ``alike``: the names of the tree, by these in small letters.
    """
    out: dict[str, None] = dict.fromkeys(left)
    perhaps: dict[str, list[str]] = {}
    warnings = []
    stops: dict[str, None] = {}
    for (package, name), asked in sorted(lacking.items(), key=lambda each: each[0][1] in tried):
        if package in left:
            continue
        with_it = needing(package, packages)
        lost = {*out, *(each for names in perhaps.values() for each in names)}
        kept = {m.name for m in packages.built if not m.metapackage} - lost - {*with_it}
        skipped = build_tool in SKIP and (package in lost or kept) and not {*with_it} & {*started}
        first = name in tried and package not in out
        where = tried.get(name) if first or not skipped else None
        if skipped and first:
            perhaps.setdefault(name, []).extend(with_it)
        elif skipped:
            out |= dict.fromkeys(with_it)
        stops |= {} if skipped else {name: None}
        unless = f"; the build looks for it in {where}, and where it is not there," if where else ":"
        others = f", and with it {', '.join(with_it[1:])}" if with_it[1:] else ", which no other package needs"
        then = f"{package} is left out of the build{others}" if skipped else f"{build_tool} will stop at {package}"
        if (other := alike.get(name.lower(), name)) != name:
            warnings.append(warn(_LETTERS.format(name=name, other=other, then=then), asked))
        else:
            text = f"nothing is known that brings {name}, which CMake requires{unless} {then}; {SOURCE}"
            warnings.append(warn(text, asked))
    return LeftOut(
        packages=tuple(sorted(out)),
        lacking=tuple((name, folders_of(packages, names)) for name, names in perhaps.items()),
        warnings=tuple(warnings),
        stops=tuple(stops),
    )


def with_modules(
    tried: Mapping[str, str], unmet: Iterable[tuple[str, Dependency]], build_tool: BuildTool
) -> Mapping[str, str]:
    """Return where the build looks for names, with those that CMake alone builds without: modules may find them.

    What a repository of CMake's modules brings is known by no name.
    """
    where = next((each for name, each in tried.items() if _OF_MODULES.search(name)), "")
    return {**{asked.name: where for _, asked in unmet}, **tried} if where and build_tool == "cmake" else tried


def folders_of(packages: Packages, names: Collection[str]) -> tuple[str, ...]:
    """Return the folders of the packages with these names."""
    return tuple(m.file.rpartition("/")[0] for m in packages.built if m.name in names)


def needing(package: str, packages: Packages) -> list[str]:
    """Return a package and those of the repository that cannot be built without it; a metapackage builds nothing."""
    found = [package]
    for each in found:
        for manifest in packages.built:
            builds = (d for d in manifest.dependencies if d.role not in {"test", "exec", "run", "doc"})
            if manifest.name not in {None, *found} and not manifest.metapackage and any(d.name == each for d in builds):
                found.append(manifest.name or "")
    return found
