"""What is used of x86 alone when the tree is compiled for ARM, too."""

from __future__ import annotations

from typing import Literal, NamedTuple


class X86Only(NamedTuple):
    """An option of the compiler, or a header, of x86 alone that is used when the tree is compiled for ARM, too."""

    what: str
    source: Literal["cmake", "make", "setup.py", "header"]
    """What passes the option: a file of CMake, a Makefile or setup.py; ``header`` for an include."""
    file: str
    line: int
