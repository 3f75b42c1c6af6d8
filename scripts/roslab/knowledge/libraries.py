"""Names of libraries in CMake, pkg-config, link lines and includes, and the packages that contain them."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Literal

from roslab.knowledge.cmake_calls import lines_of_calls
from roslab.knowledge.table import cells, rows
from roslab.values.dataclass import dataclass

Naming = Literal["cmake", "pkg-config", "link", "include"]
_TABLES: dict[Naming, tuple[str, str]] = {
    "cmake": ("cmake", "name"),
    "pkg-config": ("pkg_config", "module"),
    "link": ("links", "name"),
    "include": ("includes", "header"),
}


@dataclass(frozen=True, kw_only=True, slots=True)
class Library:
    """Where a library comes from; nothing is set if the compiler or CMake itself brings it."""

    apt: tuple[str, ...] = ()
    ros: str = ""
    """A ROS package that contains it, preferred if the image has ROS."""
    beside: tuple[str, ...] = ()
    """Packages that code using it usually needs too: headers that it exposes, libraries that its build looks for."""
    recipe: str = ""
    """A row of ``recipes.toml`` that builds it, if no package contains it."""
    elsewhere: bool = False
    """Only other Ubuntus are known to have it."""


@cache
def _table(naming: Naming) -> tuple[list[str], dict[str, list[list[str]]]]:
    """Return the head of a table and its lines by name."""
    name, key = _TABLES[naming]
    head, *lines = cells(name)
    place = head.index(key)
    found: dict[str, list[list[str]]] = {}
    for line in lines:
        found.setdefault(line[place], []).append(line)
    return head, found


def _entries(naming: Naming, name: str) -> list[dict[str, str]]:
    """Return the rows of a name; those for certain Ubuntu releases come before the one for all others."""
    head, by_name = _table(naming)
    found = [dict(zip(head, line, strict=True)) for line in by_name.get(name, ())]
    return sorted(found, key=lambda row: not row["ubuntu"])


@cache
def library(naming: Naming, name: str, ubuntu: str | None) -> Library | None:
    """Return where a library comes from on an Ubuntu; ``None`` for a name that is in no table.

    A name in the table without a row for this Ubuntu gives a ``Library`` with nothing but the package of ROS that has
    it elsewhere: a distribution for this Ubuntu may have released that, too.
    """
    entries = _entries(naming, name)
    if not entries:
        return None
    row = _of_ubuntu(entries, ubuntu)
    if row is None:
        of_ros = next((each["ros"] for each in entries if each.get("ros")), "")
        return Library(ros=of_ros, elsewhere=ubuntu is not None)
    return Library(
        apt=tuple(row["apt"].split()),
        ros=row.get("ros", ""),
        recipe=row.get("recipe", ""),
        beside=tuple(row.get("beside", "").split()),
    )


def _of_ubuntu(entries: list[dict[str, str]], ubuntu: str | None) -> dict[str, str] | None:
    return next((row for row in entries if not row["ubuntu"] or ubuntu in row["ubuntu"].split()), None)


def header(path: str, ubuntu: str | None) -> Library | None:
    """Return where an included header comes from: by its whole path, or by its first folder.

    Else by what a compiler without it says.
    """
    parts = path.split("/")
    for length in range(len(parts), 0, -1):
        stem = "/".join(parts[:length]) + ("/" if length < len(parts) else "")
        if (found := library("include", stem, ubuntu)) is not None:
            return found
    if path not in _missed():
        return None
    row = _of_ubuntu(_missed()[path], ubuntu)
    return Library(apt=(row["apt"],)) if row else Library(elsewhere=ubuntu is not None)


def only_missed(path: str) -> bool:
    """Tell whether a header is known by failed builds alone: code may include it for another system, or an option."""
    return path in _missed() and not any(
        library("include", each, None) for each in (path, f"{path.partition('/')[0]}/")
    )


@cache
def _missed() -> dict[str, list[dict[str, str]]]:
    """Return the rows of the headers that failed builds were without."""
    found: dict[str, list[dict[str, str]]] = {}
    for row in rows("headers"):
        found.setdefault(row["header"], []).append(row)
    return found


def names(naming: Naming) -> Iterable[str]:
    """Return all names of a kind, as they are written."""
    return _table(naming)[1]


@cache
def cmake_packages(ubuntu: str | None) -> str:
    """Return lines ``NAME... = PACKAGE...`` of what CMake finds on an Ubuntu, names in lower case.

    A package of ROS that is preferred is the first, as ``ros:NAME``. Programs that CMake files call are ``run:NAME``.
    """
    found: dict[str, str] = {}
    for name in _table("cmake")[1]:
        one = library("cmake", name, ubuntu) if " " not in name else None
        if one is not None:
            ros = (f"ros:{one.ros}",) if one.ros else ()
            found.setdefault(name.lower(), " ".join((*ros, *one.apt, *(one.beside if ros or one.apt else ()))))
    names: dict[str, list[str]] = {}
    for name, packages in found.items():
        names.setdefault(packages, []).append(name)
    lines = "".join(f"{' '.join(of)} = {packages}\n" for packages, of in names.items() if packages)
    return lines + lines_of_calls()


@cache
def packaged(ubuntu: str | None) -> frozenset[str]:
    """Return the packages of libraries that an Ubuntu is known to have."""
    found: list[str] = []
    for naming in _TABLES:
        head, by_name = _table(naming)
        apt, only = head.index("apt"), head.index("ubuntu")
        for lines in by_name.values():  # of a thousand names no other cell is wanted
            if len(lines) == 1 and not lines[0][only]:
                found.append(lines[0][apt])
                continue
            certain = [line[apt] for line in lines if ubuntu in line[only].split()]
            others = (line[apt] for line in lines if not line[only])
            found.append(certain[0] if certain else next(others, ""))
    return frozenset(" ".join(found).split())


@cache
def qt_modules() -> dict[str, str]:
    """Return CMake's names of the modules of Qt 5 by those that qmake has for them: ``opengl`` is ``Qt5OpenGL``."""
    return {name.removeprefix("Qt5").lower(): name for name in _table("cmake")[1] if name.startswith("Qt5")}
