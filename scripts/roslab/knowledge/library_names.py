"""What a script of the image reads of libraries beside what CMake finds: other names, and what can be built first."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache

from roslab.knowledge.libraries import Library, Naming, library, names
from roslab.knowledge.recipes import Recipe, recipe

PREFIXES: dict[Naming, str] = {"pkg-config": "pkg:", "link": "link:", "include": "header:"}
"""What stands before a name that is not CMake's."""
NOTHING = "-"
"""In the place of packages: CMake, the compiler or the C library has it."""
BETWEEN = " | "
"""Between libraries of which one is built before the other."""


@cache
def library_names(ubuntu: str | None) -> str:
    """Return lines ``NAME... = PACKAGE...`` of what libraries are called on an Ubuntu, in lower case.

    Of names of CMake only those without a package of this Ubuntu: those that need none, and those that can be built
    from their source, as ``recipe:`` and what is to be written into ``roslab.yaml``, behind the package of ROS if there
    is one.
    """
    found: dict[str, list[str]] = {}
    for name, told in _told(ubuntu):
        if " " not in name and name.lower() not in (seen := found.setdefault(told, [])):
            seen.append(name.lower())
    return "".join(f"{' '.join(called)} = {told}\n" for told, called in found.items())


def _told(ubuntu: str | None) -> Iterator[tuple[str, str]]:
    for name in names("cmake"):
        one = library("cmake", name, ubuntu)
        if one is None or any(built.makefile_in or built.archives for built in recipe(one.recipe, ubuntu)):
            continue  # no package of CMake is called so, or no key of roslab.yaml says how it is unpacked
        if not one.apt and (one.recipe or not (one.ros or one.elsewhere)):
            yield name, _without_package(one, ubuntu)
    for naming, prefix in PREFIXES.items():
        for name in names(naming):
            one = library(naming, name, ubuntu)
            if one is not None and (one.apt or one.ros):
                yield f"{prefix}{name}", " ".join((*((f"ros:{one.ros}",) if one.ros else ()), *one.apt))


def _without_package(one: Library, ubuntu: str | None) -> str:
    if not one.recipe:
        return NOTHING
    items = BETWEEN.join(map(_item, recipe(one.recipe, ubuntu)))
    return f"{f'ros:{one.ros} ' if one.ros else ''}recipe:{items}"


def _item(built: Recipe) -> str:
    """Return an item of ``source`` in ``roslab.yaml``, in one line."""
    item: dict[str, object] = {"name": built.name, "repo": built.repo, "ref": built.ref}
    item |= {"depends": list(built.depends)} if built.depends else {}
    item |= {"cmake_options": " ".join(built.options)} if built.options else {}
    item |= {"cmake_folder": f"../{built.cmake_in}"} if built.cmake_in else {}
    item |= {"make_command": built.make} if built.make else {}
    return json.dumps(item)
