"""The condition of a step of a CI file: ``if: matrix.os == 'ubuntu-22.04'``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.dependency import Dependency
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_ITEM = pattern(r"^([ \t]*)-[ \t]")
_CONDITION = pattern(r"^[ \t]*(?:-[ \t]+)?if[ \t]*:[ \t]*(.*)")


def condition_of(text: str, line: int) -> str | None:
    """Return the condition of the step that a line of a CI file belongs to, ``None`` if it has none."""
    lines = text.split("\n")
    first = next((at for at in range(line - 1, -1, -1) if _ITEM.match(lines[at])), 0)
    indent = len(lines[first]) - len(lines[first].lstrip())
    for at, each in enumerate(lines[first:], first):
        inside = at == first or not each.strip() or len(each) - len(each.lstrip()) > indent
        if not inside:
            return None
        if match := _CONDITION.match(each):
            return match[1]
    return None


def titled(dependencies: Iterable[Dependency], text: str) -> Iterator[Dependency]:
    """Yield the dependencies of a CI file, those of a step for one release or distribution under its condition."""
    for each in dependencies:
        said = condition_of(text, each.line) if each.namespace == "apt" and "matrix." in text else None
        yield replace(each, heading=said) if said and "==" in said and "!" not in said else each
