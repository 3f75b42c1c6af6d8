"""Lines of Python that run beside some versions of a library alone: they tell nothing about the others."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.values.pattern import pattern

_TESTED = pattern(
    r"__version__|\bversion_info\b|(?i:\b\w*_?(?:MAJOR|MINOR)\b|\b(?:parse|loose|strict|digit)_?version\b|version\.parse)"
    r"|\bhasattr\(|\b(?i:torch|tf|tensorflow|np|numpy|scipy|pandas|mpl|matplotlib|gym|sklearn|yaml)_?ver(?i:sion)?\w*"
)
_MISSED = pattern(r"except[ \t]*(?::|\(?[^:\n]*\b(?:ImportError|ModuleNotFoundError|AttributeError)\b)")
_STOPS = pattern(r"[ \t]*(?:raise|pass|print|exit|quit|sys\.exit|os\._exit|log\w*\.)\b")
_INLINE = pattern(r"\bif\b(?=.*\belse\b)")
MOST = 2_000
"""Lines above a place that are looked at."""


def of_some_versions(text: str, position: int) -> bool:
    """Tell whether a position lies in a branch that tests a version, or in a ``try`` whose ``except`` has another way.

    An ``except`` that only stops or is silent is no other way.
    """
    lines = text[:position].count("\n")
    all_lines = text.split("\n")
    here = all_lines[lines]
    if _INLINE.search(here) and _TESTED.search(here):
        return True
    return any(_chooses(all_lines, at) for at in _holding(all_lines, lines))


def _holding(lines: list[str], at: int) -> Iterator[int]:
    """Yield the lines that hold one, from the inside: each with less indentation than all below it."""
    inner = _indent(lines[at])
    for above in range(at - 1, max(-1, at - MOST), -1):
        if inner == 0:
            return
        if lines[above].strip() and not lines[above].lstrip().startswith("#") and _indent(lines[above]) < inner:
            inner = _indent(lines[above])
            yield above


def _chooses(lines: list[str], at: int) -> bool:
    head = lines[at].strip()
    if head.startswith(("if ", "if(", "elif ", "elif(")):
        return bool(_TESTED.search(head))
    if head.startswith("try:"):
        return _other_way(lines, at)
    if head.startswith("except"):
        return bool(_MISSED.match(head))
    return head.startswith("else:") and _else_of_test(lines, at)


def _other_way(lines: list[str], at: int) -> bool:
    """Tell whether the ``except`` of a ``try`` is for what is not there, and does something else then."""
    indent = _indent(lines[at])
    for below in range(at + 1, min(len(lines), at + MOST)):
        if lines[below].strip() and _indent(lines[below]) <= indent:
            caught = bool(_MISSED.match(lines[below].strip()))
            after = next((line for line in lines[below + 1 :] if line.strip()), "")
            return caught and not _STOPS.match(after)
    return False


def _else_of_test(lines: list[str], at: int) -> bool:
    """Tell whether the ``if`` or the ``elif`` above an ``else`` tests a version."""
    indent = _indent(lines[at])
    for above in range(at - 1, max(-1, at - MOST), -1):
        line = lines[above]
        if not line.strip() or _indent(line) > indent:
            continue
        head = line.strip()
        if _indent(line) < indent or not head.startswith(("if", "elif", "except")):
            return False
        if _TESTED.search(head) or _MISSED.match(head):
            return True
        if head.startswith("if"):
            return False
    return False


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())
