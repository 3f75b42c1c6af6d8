"""Names of libraries in one spelling, and by which of what is offered a build asks for one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

from roslab.decide.ros.source_names import plain
from roslab.evidence.dependency import GitSource
from roslab.values.pattern import pattern

_LIB = pattern(r"^lib(?=[a-z])")
_MAJOR = pattern(r"\d$")
SHORTEST_TOGETHER = 6
"""Fewest letters of names that are compared without what separates their words: a short one may be another's part."""


@cache
def bare(name: str) -> str:
    """Return a name in the one spelling in which two are compared, without ``lib``: ``libfreenect2``, ``freenect2``."""
    return _LIB.sub("", plain(name))


def with_joined(offered: dict[str, GitSource]) -> dict[str, GitSource]:
    """Add the names without separators: CMake asks for ``FooBarCpp`` where the repository is ``foo.bar.cpp``."""
    found = dict(offered)
    for name, git in offered.items():
        joined = _joined(name)
        if len(joined) >= SHORTEST_TOGETHER:
            found.setdefault(joined, git)
    return found


def offered_name(name: str, offered: Mapping[str, GitSource]) -> str:
    """Return the name of what is offered for a bare name; the name itself where nothing is.

    That is one without separators, or the name of what a page installs, where CMake's has the major release behind it:
    ``SDL3`` of ``SDL``.
    """
    if name in offered:
        return name
    joined = _joined(name)
    if len(joined) >= SHORTEST_TOGETHER and joined in offered:
        return joined
    plainly = _MAJOR.sub("", name)
    return plainly if plainly in offered and offered[plainly].installed else name


def without_major(names: Iterable[str]) -> dict[str, str]:
    """Return names as they are written, each with its bare name without a major release."""
    return {name: _MAJOR.sub("", bare(name)) for name in names}


def _joined(name: str) -> str:
    return name.replace("_", "")
