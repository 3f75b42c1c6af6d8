"""Names that pkg-config is asked for and that tell the release of a library: ``opencv`` went with OpenCV 4."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.makefile import Makefile
from roslab.knowledge.code_limits import limits


def of_modules(projects: Iterable[CMakeProject], makefiles: Iterable[Makefile]) -> tuple[CodeLimit, ...]:
    """Return the bounds that names of pkg-config are: those that CMake requires, and all that a Makefile asks for.

    Where an older and a newer name of a library are asked for, the build takes what is there.
    """
    signs = [limit for limit in limits() if limit.where == "module"]
    found: dict[str, dict[str, CodeLimit]] = {}
    for name, file, line in _asked(projects, makefiles):
        for sign in (each for each in signs if each.pattern.search(name)):
            limit = CodeLimit(
                library=sign.library, at_least=sign.at_least, below=sign.below, what=sign.what, file=file, line=line
            )
            found.setdefault(sign.library, {}).setdefault(sign.what, limit)
    return tuple(limit for of_one in found.values() if len(of_one) == 1 for limit in of_one.values())


def _asked(projects: Iterable[CMakeProject], makefiles: Iterable[Makefile]) -> Iterator[tuple[str, str, int]]:
    for project in projects:
        for asked in project.dependencies if not places.aside(project.file) else ():
            if asked.namespace == "pkg-config" and asked.strength == "declared" and asked.role != "test":
                yield asked.name, asked.file, asked.line
    for made in makefiles:
        for name in made.modules:
            yield name, made.file, made.line
