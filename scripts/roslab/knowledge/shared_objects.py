"""The packages of apt that hold shared libraries, by the names that compiled files ask the loader for."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern

_SONAME = pattern(r"lib([\w+.-]+?)\.so\.(\d+(?:\.\d+)*)")
_ANYWHERE = pattern(
    r"lib(?:c|m|dl|rt|pthread|util|resolv|nsl|gcc_s|stdc\+\+|z|anl)\.so\.|"
    r"lib(?:cuda|cud|nv|cublas|cufft|curand|cusolver|cusparse|torch|c10|tensorflow|python)"
)
"""Libraries of every system, of CUDA and of pip's packages."""


@cache
def _tabled() -> dict[str, str]:
    return {row["library"]: row["apt"] for row in rows("shared_objects")}


def package_of(soname: str) -> str | None:
    """Return the package that holds a library, ``None`` for those that are everywhere or that apt does not bring.

    One of no table has the library's name and version, as Debian asks for, ``libGLEW.so.2.0`` that of ``libglew2.0``:
    https://www.debian.org/doc/debian-policy/ch-sharedlibs.html, 2026-11-23.
    """
    match = _SONAME.fullmatch(soname)
    if match is None or soname in _tabled() or _ANYWHERE.match(soname):
        return _tabled().get(soname)
    name = f"lib{match[1]}".lower().replace("_", "-")
    return f"{name}{'-' if name[-1].isdigit() else ''}{match[2]}"
