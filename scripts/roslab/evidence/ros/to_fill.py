"""Launch files that a reader is to fill in first: they load a file by a path with a blank in it, and stop there."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.values.pattern import pattern

_LOADS = pattern(r"<(?:rosparam|include|param)\s([^<>]{0,600})>")
_FILE = pattern(r"\b(?:text|bin)?file\s{0,9}=\s{0,9}[\"']([^\"'\n]{1,300})[\"']")
_WAITS = pattern(r"\b(?:if|unless)\s{0,9}=")
_BLANK = pattern(r"\[[A-Z][A-Z0-9_ -]{2,60}\]|\b(?:PATH_TO|YOUR)_[A-Z]|^/?path[_-]to[_-]|(?:^|/)path/to/")
"""What the reader puts something in the place of: ``[PATH_TO_CONFIG]/a.yaml``, ``/path/to/a.yaml``."""


def to_fill(text: str) -> Iterator[tuple[str, int]]:
    """Yield each such path of a launch file in XML, without its comments, and its line; none under a condition."""
    for match in _LOADS.finditer(text) if "<launch" in text else ():
        named = _FILE.search(match[1])
        if named and _BLANK.search(named[1]) and not _WAITS.search(match[1]):
            yield named[1], text.count("\n", 0, match.start(1) + named.start()) + 1
