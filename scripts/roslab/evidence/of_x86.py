"""Calling the readers of what is of x86 alone."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Set as AbstractSet

from roslab.evidence.native import x86, x86_binaries, x86_programs
from roslab.evidence.prose import system_libraries
from roslab.evidence.python.modules import modules
from roslab.evidence.x86_only import X86Only
from roslab.repository.checkout import Repository


def read(repository: Repository, intrinsics: x86.Intrinsics, included: AbstractSet[str]) -> Iterator[X86Only]:
    """Yield what is compiled, linked, opened or started on ARM, too; ``included``: the headers that code includes."""
    yield from x86.read(repository, intrinsics, included)
    yield from x86_binaries.read(repository, ((m.file.path, m.text) for m in modules(repository)))
    yield from x86_programs.read(repository)
    yield from system_libraries.of_x86(repository)
