"""What is used of x86 alone when the tree is compiled for ARM, too."""

from __future__ import annotations

from typing import Literal

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class X86Only:
    """An option of the compiler, a header, a library or a program of x86 alone, which the tree uses on ARM, too."""

    what: str
    source: Literal["cmake", "make", "setup.py", "header", "binary", "opened", "opened by Python", "started"]
    """What passes the option: a file of CMake, a Makefile or setup.py; ``header`` for an include; ``binary`` for a
    library that CMake downloads or links, ``opened`` for one that the code opens, in C or C++ or by Python, ``started``
    for a program that code in C or C++ starts."""
    file: str
    line: int
