"""Compiled modules and libraries that lie in the tree, and the libraries of the system that they are linked with."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.native import elf, made_elsewhere
from roslab.knowledge.shared_objects import package_of, ubuntus_of
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 4 * 1024 * 1024
"""What is read of a file: the names of the libraries lie near its start."""
MOST = 20
"""Most files that are read, those nearest to the root first."""
_NAME = pattern(r"\.so(?:\.\d+)*$")
_MACHINES = frozenset({elf.X86_64, elf.AARCH64})
_VERSIONED = pattern(r"lib[\w+.-]{1,60}\.so(?:\.\d+){1,3}")
_NEEDED = re.compile(rb"\0(lib[\w+.-]{1,60}\.so(?:\.\d+){1,3})(?=\0)")


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the package of each library that such a file needs and that the tree does not hold itself, once.

    Not of what a build on another machine left in the tree: the image has none of it, and compiles it anew.
    """
    found: dict[str, Dependency] = {}
    left = tuple(f"{name}/" for name in made_elsewhere.names(repository))
    for path, soname in _needed_of(repository, left) if left else repository.once(_needed):
        if apt := package_of(soname):
            asked = Dependency(namespace="apt", name=apt, strength="used", file=path, line=1, role="linked")
            found.setdefault(apt, asked)
    return tuple(found.values())


def made_on(repository: Repository) -> tuple[Mention, ...]:
    """Return the only Ubuntu whose packages have the libraries that these files need, if two libraries tell it.

    One alone may be built from source.
    """
    told: dict[str, tuple[str, str, frozenset[str]]] = {}
    for path, soname in repository.once(_needed):
        known = ubuntus_of(soname)
        if known and told.setdefault(known[0], (path, soname, known[1]))[2] != known[1]:
            return ()  # files of several machines
    common = frozenset.intersection(*(names for _, _, names in told.values())) if len(told) > 1 else frozenset()
    if len(common) != 1:
        return ()
    (codename,) = common
    path = next(iter(told.values()))[0]
    text = f"a compiled file is linked with {' and '.join(soname for _, soname, _ in told.values())}"
    return (Mention(topic="ubuntu", value=codename, source="code", file=path, line=1, text=text),)


def _needed(repository: Repository) -> tuple[tuple[str, str], ...]:
    """Return what such files need and the tree does not hold: libraries with their versions, each with the file."""
    return _needed_of(repository, ())


def _needed_of(repository: Repository, without: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
    found: dict[tuple[str, str], None] = {}
    for file in _files(repository, without):
        data = repository.read_bytes(file, limit=MAX_SIZE)
        if elf.machine(data) not in _MACHINES:
            continue
        names = elf.needed(data)
        if names is None:  # all names of that form, of which one may be the file's own
            names = tuple(name.decode() for name in _NEEDED.findall(data))
        for soname in dict.fromkeys(name for name in names if _VERSIONED.fullmatch(name)):
            if not repository.named(soname, soname[: soname.index(".so") + 3]):
                found[file.path, soname] = None
    return tuple(found)


def _files(repository: Repository, without: tuple[str, ...]) -> Iterator[File]:
    """Yield the files of that name, but for those in folders whose paths begin like one of ``without``."""
    named = (file for file in repository.files if ".so" in file.name and _NAME.search(file.name))
    named = (file for file in named if not file.path.startswith(without))
    own = [file for file in named if not (places.test(file.path) or places.documentation(file.path))]
    yield from nearest(own)[:MOST]
