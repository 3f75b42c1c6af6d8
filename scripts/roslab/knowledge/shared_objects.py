"""The packages of apt that hold shared libraries, by the names that compiled files ask the loader for."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern

_SONAME = pattern(r"lib([\w+.-]+?)\.so\.(\d+(?:\.\d+)*)")


@cache
def _tabled() -> dict[str, str]:
    return {row["library"]: row["apt"] for row in rows("shared_objects")}


@cache
def _given() -> tuple[str, ...]:
    """Return how the names of libraries begin that are in every image, or that CUDA or pip's packages bring."""
    return tuple(row["begins"] for row in rows("shared_objects_given"))


def given(name: str) -> bool:
    """Tell whether a library's file is in every image, or brought by CUDA or pip's packages."""
    return name.startswith(_given())


def table() -> str:
    """Return what ``package_of`` knows beside the rule: a line for each library, and ``NAME* -`` for a beginning."""
    tabled = (f"{library} {package}" for library, package in _tabled().items())
    return "\n".join((*tabled, *(f"{begins}* -" for begins in _given())))


def package_of(soname: str) -> str | None:
    """Return the package that holds a library, ``None`` for those that are everywhere or that apt does not bring.

    One of no table has the library's name and version, as Debian asks for, ``libGLEW.so.2.0`` that of ``libglew2.0``:
    https://www.debian.org/doc/debian-policy/ch-sharedlibs.html, 2026-11-23.
    """
    match = _SONAME.fullmatch(soname)
    if match is None or soname in _tabled() or soname.startswith(_given()):
        return _tabled().get(soname)
    name = f"lib{match[1]}".lower().replace("_", "-")
    return f"{name}{'-' if name[-1].isdigit() else ''}{match[2]}"


@cache
def _of_ubuntus() -> dict[tuple[str, str], frozenset[str]]:
    return {(row["begins"], row["version"]): frozenset(row["ubuntus"].split()) for row in rows("soname_ubuntus")}


def ubuntus_of(soname: str) -> tuple[str, frozenset[str]] | None:
    """Return the family of a library, ``libopencv_``, and the Ubuntus that have it in this version, if they are known.

    A library that somebody built from source may have the version of one of them as well.
    """
    begin, _, version = soname.partition(".so.")
    return next(
        (
            (family, names)
            for (family, of), names in _of_ubuntus().items()
            if of == version and begin.startswith(family)
        ),
        None,
    )


def ubuntus_with(package: str) -> frozenset[str]:
    """Return the Ubuntus that have the package of such a library, ``libgfortran3``; none where they are not known."""
    named = ((family.lower().replace("_", "-"), version, names) for (family, version), names in _of_ubuntus().items())
    found = (n for family, version, n in named if package.startswith(family) and package.endswith(version))
    return next(found, frozenset())
