"""Environments that conda wrote on Windows or macOS: their builds are for there, and some of their packages, too.

https://docs.conda.io/projects/conda/en/stable/user-guide/tasks/manage-environments.html#sharing-an-environment,
read 2026-11-28; https://github.com/conda/conda/issues/6073.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.values.conda import CondaPackage
from roslab.values.pattern import pattern

_PREFIX = pattern(r"^prefix:[ \t]*[\"']?(?:([A-Za-z]:[\\/])|(/Users/))", re.MULTILINE)
"""Where conda had the environment, which it writes at the end."""
_EXACT = pattern(r"((?:[^\s:=]+::)?[\w.-]+)(={1,2}[^\s=]+)=([^\s=]+)")
_OF_PYTHON = pattern(r"(?:np\d+)?py\w*|\w*cpython|\d+")
"""A build of a package for a Python, or one that tells nothing."""
_SAME = pattern(r"[a-z]+")
"""A build that has the same name on each system and chooses a variant: ``mkl``, ``cuda``."""
_NAMED = frozenset({"python", "cudatoolkit", "cudnn", "pytorch", "tensorflow"})
"""What keeps its release whatever its build is called."""


def system_of(text: str, packages: Iterable[CondaPackage]) -> str:
    """Return ``Windows`` or ``macOS`` where an environment was written there, else ``""``."""
    if found := _PREFIX.search(text):
        return "Windows" if found[1] else "macOS"
    from roslab.knowledge.conda_systems import of_systems  # noqa: PLC0415 - few trees have an environment

    signs = [each for each in of_systems() if each.sign]
    names = [_name(package) for package in packages]
    return next((each.system for name in names for each in signs if each.names.fullmatch(name)), "")


def as_on_linux(packages: Iterable[CondaPackage], system: str) -> tuple[str, ...]:
    """Return the packages without their builds, and without those that this system alone has; none if all stay.

    What a package for Python or CUDA is built for is found for its release. Of a library that came with one, Linux may
    have other releases: it keeps its name.
    """
    packages = tuple(packages)
    kept = tuple(_on_linux(packages, system)) if system else ()
    return kept if kept != tuple(package.written for package in packages) else ()


def _on_linux(packages: Iterable[CondaPackage], system: str) -> Iterator[str]:
    from roslab.knowledge.conda_systems import of_systems  # noqa: PLC0415 - as above

    left = [each.names for each in of_systems() if each.system == system]
    for package in packages:
        exact = _EXACT.fullmatch(package.written)
        if any(names.fullmatch(_name(package)) for names in left):
            continue
        if exact is None or _SAME.fullmatch(exact[3]):
            yield package.written
        elif _OF_PYTHON.fullmatch(exact[3]) or _name(package) in _NAMED:
            yield f"{exact[1]}{exact[2]}"
        else:
            yield exact[1]


def _name(package: CondaPackage) -> str:
    """Return the name as conda writes it, without a channel before it."""
    return re.split(r"[\s=<>!~\[]", package.written.rpartition("::")[2], maxsplit=1)[0].lower()
