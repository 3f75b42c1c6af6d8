"""Libraries without a package: where their source is, which ref to build, and how to compile it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

from roslab.knowledge.table import text_of
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.version import Version

Bound = tuple[str | None, str | None]
"""The oldest version that fits, and the first that does not."""
_NAME = pattern(r"^\[(.+)\]$", re.MULTILINE)
_TAG = pattern(r"(?P<before>v?)(?P<version>\d+(?:\.\d+)+)")
_ASIDE = pattern(r"-D(?:\w+_)?(?:DOCS?|DOCUMENTATION|TESTS?|TESTING|EXAMPLES?)(?:_\w+)?(?::BOOL)?=OFF")
NO_BOUNDS: Mapping[str, tuple[Bound, ...]] = MappingProxyType({})


@cache
def _text() -> str:
    return text_of("recipes.toml")


@cache
def _table(name: str) -> dict[str, Any] | None:
    """Return the table of one library, ``None`` if there is none; the others are not parsed."""
    from roslab.values import toml  # noqa: PLC0415 - few trees need one

    start = _text().find(f"\n[{name}]\n")
    if start < 0:
        return None
    end = _text().find("\n[", start + 1)
    found: dict[str, Any] = toml.parsed(_text()[start : end if end >= 0 else None])[name]
    return found


@dataclass(frozen=True, kw_only=True, slots=True)
class Recipe:
    """How one library is built, by CMake or by a Makefile."""

    name: str
    repo: str
    """``""`` for one whose project compiles it itself: its archives are unpacked."""
    ref: str
    """A tag or a commit, so that the same is built in ten years; of archives the release."""
    depends: tuple[str, ...]
    """apt packages that its build needs."""
    options: tuple[str, ...]
    make: str | None
    """What takes the place of ``make install``, in its build folder."""
    makefile_in: str | None
    """The folder of it whose Makefile installs it without CMake, which then finds no package: it is only linked."""
    cmake_in: str | None
    """The folder of it with its CMakeLists.txt, where that is not at the root."""
    archives: tuple[str, str] | None = None
    """Its archives for amd64 and arm64."""
    installs: str = ""
    """The CMakeLists.txt that installs what is in such an archive."""


@cache
def recipe_at(url: str) -> str | None:
    """Return the name of the library that the table builds from an address, in lower case and without ``.git``."""
    if url not in _text().lower():
        return None
    found = ((name, _table(name)) for name in _NAME.findall(_text()))
    return next((name for name, row in found if row and row.get("repo", "").lower().removesuffix(".git") == url), None)


@cache
def leaves_out(url: str) -> tuple[str, ...]:
    """Return the options by which the table builds what lies at an address without documentation, tests and examples.

    Of some, ``make install`` alone fails where they are on: it copies what another target makes.
    """
    name = recipe_at(url)
    options: tuple[str, ...] = tuple((_table(name) or {}).get("options", ())) if name else ()
    return tuple(option for option in options if _ASIDE.fullmatch(option))


@cache
def beside(name: str) -> tuple[str, ...]:
    """Return the apt packages that an image needs with a library of the table, to link it and to run what does."""
    return tuple((_table(name) or {}).get("beside", ()))


@cache
def brings(name: str) -> tuple[str, ...]:
    """Return the libraries of other names that a library of the table installs with itself."""
    return tuple((_table(name) or {}).get("brings", ()))


@cache
def unpacked(name: str) -> bool:
    """Tell whether a library of the table comes compiled, in an archive of its project's."""
    return "archives" in (_table(name) or {})


@dataclass(frozen=True, kw_only=True, slots=True)
class OnCuda:
    """How a library is compiled with its parts for CUDA."""

    modules: tuple[str, ...]
    """Its modules for CUDA, which code may include or not."""
    without: tuple[str, ...]
    """Those that need what no image has."""
    core: str
    """The module that all of it needs."""
    apart_since: str
    """The release since which the modules are in a repository of their own, ``apart``, under the same tags."""
    apart: str
    for_cuda_12: str
    """The first release that CUDA 12 compiles."""


@cache
def on_cuda(name: str) -> OnCuda | None:
    """Return how a library of the table is compiled for CUDA, ``None`` where the table does not know it."""
    row: dict[str, Any] = (_table(name) or {}).get("on_cuda", {})
    if not row:
        return None
    lists = {"modules": tuple(row["modules"]), "without": tuple(row["without"])}
    return OnCuda(**(row | lists))


@cache
def licence(name: str) -> str:
    """Return what the user of a library has to get, and where to put it, ``""`` for nothing."""
    return str((_table(name) or {}).get("licence", ""))


@cache
def releases(name: str) -> tuple[str, ...]:
    """Return the releases of a library that the table knows how to build; ``()`` where it names none."""
    return tuple((_table(name) or {}).get("releases", {}))


def release_of(name: str, ref: str) -> str:
    """Return the number of the release that a tag is of, the tag without a ``v`` where the table does not know it."""
    refs: dict[str, str] = (_table(name) or {}).get("releases", {})
    return next((release for release, tag in refs.items() if tag == ref), ref.removeprefix("v"))


def usual_release(name: str, ubuntu: str | None) -> str | None:
    """Return the release of a library that is built on an Ubuntu, ``None`` where the table does not have several."""
    built = recipe(name, ubuntu) if releases(name) else ()
    return release_of(name, built[-1].ref) if built else None


def tag_of(name: str, release: str) -> str | None:
    """Return the tag of a release of a library, written as its usual tag is; ``None`` where that is no number."""
    found = _table(name) or {}
    match = _TAG.fullmatch(found.get("ref", ""))
    tag: str | None = found.get("releases", {}).get(release, match and match["before"] + release)
    return tag


def has_release(name: str, oldest: str, end: str | None) -> bool:
    """Tell whether the table knows how to build a release of a library within these bounds."""
    known = (Version(release) for release in releases(name))
    return any(release >= Version(oldest) and (end is None or release < Version(end)) for release in known)


@cache
def stands_beside(name: str) -> bool:
    """Tell whether one release of a library can be built where the Ubuntu has another, without harm to what links that.

    Its headers are all of it, or its names in the linker have its version: code that asks for one can stay on its own
    Ubuntu.
    """
    return bool((_table(name) or {}).get("stands_beside", False))


@cache
def header_only(name: str) -> bool:
    """Tell whether a library is headers alone: what includes a newer release of it has that compiled in."""
    return bool((_table(name) or {}).get("header_only", False))


@cache
def of_ros(name: str) -> bool:
    """Tell whether packages of ROS link a library or show it in their headers: a process loads one release of it."""
    return bool((_table(name) or {}).get("of_ros", False))


@cache
def takes_long(name: str) -> bool:
    """Tell whether a library takes the better part of an hour to compile."""
    return bool((_table(name) or {}).get("takes_long", False))


def recipe(
    name: str, ubuntu: str | None, bounds: Mapping[str, tuple[Bound, ...]] = NO_BOUNDS, day: str | None = None
) -> tuple[Recipe, ...]:
    """Return what to build for a library, its own needs first; empty if the table does not have it.

    ``bounds``: of libraries, the versions that the code compiles with; ``day``: the one whose release is meant, where
    the table knows those of several days.
    """
    found = _table(name)
    if found is None:
        return ()
    depends = (*found.get("depends", ()), *found.get("depends_on", {}).get(ubuntu or "", ()))
    ref, archives = _fitting(found, _usual(found, ubuntu, day), bounds.get(name, ())), found.get("archives", {})
    own = Recipe(
        name=name,
        repo=found.get("repo", ""),
        ref=ref,
        depends=depends,
        options=tuple(found.get("options", ())),
        make=found.get("make"),
        makefile_in=found.get("makefile_in"),
        cmake_in=found.get("cmake_in"),
        archives=(archives["amd64"].format(ref=ref), archives["arm64"].format(ref=ref)) if archives else None,
        installs=found.get("installs", ""),
    )
    return (*(first for needed in found.get("after", ()) for first in recipe(needed, ubuntu, bounds, day)), own)


def _usual(found: dict[str, Any], ubuntu: str | None, day: str | None) -> str:
    """Return the ref for an Ubuntu, else the newest of a day, else that of today; of before all of them the oldest."""
    days: dict[str, str] = found.get("of_day", {}) if day else {}
    then = max((each for each in days if each <= (day or "")), default=min(days, default=""))
    ref: str = found.get("ref_on", {}).get(ubuntu or "", days.get(then, found["ref"]))
    return ref


def _fitting(found: dict[str, Any], usual: str, bounds: tuple[Bound, ...]) -> str:
    """Return the ref of the usual release, or of the nearest one that the code compiles with if the usual does not.

    Where the table names no releases, and the tag is a version, an older one than is asked for gives way to the tag of
    the version that is.
    """
    refs: dict[str, str] = found.get("releases", {})
    if not refs:
        return _as_asked(usual, [first for first, _ in bounds if first])
    fit = [
        release
        for release in refs
        if all(
            (first is None or Version(release) >= Version(first)) and (end is None or Version(release) < Version(end))
            for first, end in bounds
        )
    ]
    if not fit or usual in {refs[release] for release in fit}:
        return usual
    known = next((Version(release) for release, ref in refs.items() if ref == usual), Version("0"))
    newer = [release for release in fit if Version(release) > known]
    return refs[min(newer, key=Version) if newer else max(fit, key=Version)]


def _as_asked(usual: str, oldest: list[str]) -> str:
    """Return the tag of the newest of these versions, written as the usual tag is, if that is older."""
    match = _TAG.fullmatch(usual)
    if match is None or not oldest:
        return usual
    wanted = max(oldest, key=Version)
    if Version(wanted) <= Version(match["version"]):
        return usual
    missing = match["version"].count(".") - wanted.count(".")
    return match["before"] + wanted + ".0" * missing
