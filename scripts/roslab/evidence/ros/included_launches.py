"""The launch files that another one names, as it does to include them, with the package of those that it says it of."""

from __future__ import annotations

from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.values.pattern import pattern

_NAME = r"\w[\w.-]{0,80}(?:\.launch(?:\.(?:py|xml|ya?ml))?|_launch\.(?:py|xml|ya?ml))(?![\w.])"
_INCLUDED = pattern(rf"(?<![\w.-]){_NAME}")
_OF_PACKAGE = pattern(
    rf"\$\(\s*find(?:-pkg-share)?\s+['\"]?([\w-]{{1,60}})['\"]?\s*\)/(?:[\w.-]{{1,60}}/){{0,9}}({_NAME})"
)


def included(text: str, own: str, package: str | None) -> tuple[tuple[str, str], ...]:
    """Return package (``$(find PACKAGE)/…/NAME``) and name of each, sorted by the name.

    The package is ``""`` where none is said of the name; ``own`` and ``package`` are the file's, which does not
    include itself.
    """
    names: set[str] = set()
    said: set[tuple[str, str]] = set()
    for start in lines_with(text, ".launch", "_launch."):
        end = end_of_line(text, start)
        names.update(_INCLUDED.findall(text, start, end))
        said.update(_OF_PACKAGE.findall(text, start, end))
    said.discard((package or "", own))
    alone = names - {own, *(name for _, name in said)}
    return tuple(sorted({*said, *(("", name) for name in alone)}, key=lambda each: (each[1], each[0])))
