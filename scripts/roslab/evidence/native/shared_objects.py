"""Compiled modules and libraries that lie in the tree, and the libraries of the system that they are linked with."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.knowledge.shared_objects import package_of
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 4 * 1024 * 1024
"""What is read of a file: the names of the libraries lie near its start."""
MOST = 20
"""Most files that are read, those nearest to the root first."""
_NAME = pattern(r"\.so(?:\.\d+)*$")
_MAGIC = b"\x7fELF"
_MACHINES = frozenset({b"\x3e\x00", b"\xb7\x00"})
"""x86-64 and AArch64. https://refspecs.linuxfoundation.org/elf/gabi4+/ch4.eheader.html"""
_NEEDED = re.compile(rb"\0(lib[\w+.-]{1,60}\.so(?:\.\d+){1,3})(?=\0)")


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the package of each library that such a file needs and that the tree does not hold itself, once."""
    found: dict[str, Dependency] = {}
    for file in _files(repository):
        data = repository.read_bytes(file, limit=MAX_SIZE)
        if data[:4] != _MAGIC or data[18:20] not in _MACHINES:
            continue
        for soname in dict.fromkeys(name.decode() for name in _NEEDED.findall(data)):
            apt = package_of(soname)
            if apt and not repository.named(soname, soname[: soname.index(".so") + 3]):
                asked = Dependency(namespace="apt", name=apt, strength="used", file=file.path, line=1, role="linked")
                found.setdefault(apt, asked)
    return tuple(found.values())


def _files(repository: Repository) -> Iterator[File]:
    named = (file for file in repository.files if ".so" in file.name and _NAME.search(file.name))
    own = [file for file in named if not (places.test(file.path) or places.documentation(file.path))]
    yield from nearest(own)[:MOST]
