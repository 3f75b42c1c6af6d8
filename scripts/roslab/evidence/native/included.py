"""Files of the tree that a CMakeLists.txt includes: what they look for, link and make is its project's."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.cmake_needs import BRINGING
from roslab.evidence.native.cmake_since import of_included
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_DEPTH = 3
"""Of files that include others."""
MAX_FILES = 40
_FINDS = frozenset({"find_package", "find_dependency", "pkg_check_modules", "pkg_search_module", "include"})
_MAKES = frozenset({"add_library", "add_executable", "target_link_libraries", "link_libraries"})
_PROGRAMS = frozenset({"add_executable"})
_ASKS = frozenset({"cmake_minimum_required"})
_BY_FUNCTIONS = BRINGING | {"add_library"}
_SOURCE = pattern(r"^\$\{(?:CMAKE(?:_CURRENT)?|PROJECT)_(?:SOURCE|LIST)_DIR\}/|^\./")
_NAME = pattern(r"[A-Za-z][\w.+-]*$")
OF_CMAKE = ("Check", "CMake", "CPack", "External", "Fetch", "GNU", "FindP", "Google", "Use", "Generate", "Write")
"""How names of CMake's own modules begin that are included by their names (FindPkgConfig, FindPackageMessage)."""


def needing(
    call: Call, repository: Repository, file: File, seen: set[str], options: dict[str, bool]
) -> Iterator[tuple[Call, str]]:
    """Yield the calls that find, fetch, make or link something in a file that ``include`` names, with that file's path.

    A call has the conditions of the ``include`` too; of what a function does when it is called, only what it brings is
    among them. Of files that include others each is read once: ``seen`` are those that were; where one is included
    under further conditions, its programs have these too. The options that they declare are added to ``options``.
    """
    module = _module(call, repository, file)
    if module is None or len(seen) >= 2 * MAX_FILES or len(call.conditions) > MAX_DEPTH * 4:
        return
    path = module.path
    again, key = path in seen, f"{path} {' '.join(call.conditions)}"
    if key in seen or (again and not call.conditions):
        return
    seen |= {path, key}
    names = _PROGRAMS if again else _FINDS | BRINGING | _MAKES | _ASKS | of_included()
    for inner in calls(repository.read(module), names, options):
        told = replace(inner, conditions=(*call.conditions, *inner.conditions))
        if inner.name == "include":
            yield from needing(told, repository, module, seen, options)
        elif not inner.in_function or inner.name in _BY_FUNCTIONS:
            yield told, module.path


def _module(call: Call, repository: Repository, file: File) -> File | None:
    """Return the file of the tree that is included, ``None`` for CMake's own and for one that is not told apart."""
    written = call.words[0] if call.words else ""
    path = _SOURCE.sub("", written)
    name = posixpath.basename(path).removesuffix(".cmake")
    if "$" in path or not _NAME.match(name) or (written == name and name.startswith(OF_CMAKE)):
        return None
    found = [each for each in repository.named(f"{name}.cmake") if each.size <= MAX_SIZE]
    if path != name:
        here = {posixpath.normpath(posixpath.join(folder, path)) for folder in (file.folder, "")}
        found = [each for each in found if each.path in here]
    if not places.vendored(file.path):
        found = [each for each in found if not places.vendored(each.path)]
    for folder in (file.folder, file.folder.partition("/")[0]):
        near = [each for each in found if each.path.startswith(f"{folder}/")] if folder else []
        found = near or found
    return found[0] if len(found) == 1 else None
