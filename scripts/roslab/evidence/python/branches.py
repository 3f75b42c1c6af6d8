"""Lines of Python that run beside some versions of a library alone: they tell nothing about the others."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.values.pattern import pattern

_LIBRARIES = (
    "torch|tf|tensorflow|jax|jnp|np|numpy|sp|scipy|pd|pandas|mpl|matplotlib|plt|gym|gymnasium|sklearn|skimage|cv2|yaml|nx|"
    "networkx|collections"
)
"""How code names libraries, in patterns."""
_TESTED = pattern(
    r"__version__|\bversion_info\b|\b\w*(?:MAJOR|MINOR)\b|(?i:\b(?:parse|loose|strict|digit)_?version\b|version\.parse)"
    rf"|\bhasattr\(\s*(?:{_LIBRARIES})\b"
    rf"|(?<![^\W_])(?i:(?:{_LIBRARIES})_?(?:ver(?:sion)?(?:_\w+)?|major|minor))\b"
)
_BARE = pattern(r"except[ \t]*:")
_MISSED = pattern(r"except\b[^:\n]*\b(?:ImportError|ModuleNotFoundError|AttributeError)\b")
_STOPS = pattern(
    r"[ \t]*(?:(?:raise|pass|print|exit|quit|continue|break)\b|(?:sys\.exit|os\._exit|warnings\.warn|rospy\.log\w*)\("
    r"|(?:traceback|log\w*)\."
    r"|return(?:[ \t]+(?:None|True|False|-?\d+|\[\]|\(\)|\{\}))?[ \t]*(?:#|$))"
)
_IMPORT = pattern(r"[ \t]*(?:import|from)[ \t]")
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
        return _missing(lines, at)
    return head.startswith("else:") and _else_of_test(lines, at)


def _other_way(lines: list[str], at: int) -> bool:
    """Tell whether the ``except`` of a ``try`` is for what is not there, and does something else then."""
    indent = _indent(lines[at])
    for below in range(at + 1, min(len(lines), at + MOST)):
        if lines[below].strip() and _indent(lines[below]) <= indent:
            after = lines[below].partition(":")[2].strip()
            after = after or next((line for line in lines[below + 1 :] if line.strip()), "")
            return _missing(lines, below) and not _STOPS.match(after)
    return False


def _missing(lines: list[str], at: int) -> bool:
    """Tell whether an ``except`` is for what is not there; one of all is, where its ``try`` imports."""
    head = lines[at].strip()
    if not _BARE.match(head):
        return bool(_MISSED.match(head))
    for above in range(at - 1, max(-1, at - MOST), -1):
        if lines[above].strip() and _indent(lines[above]) <= _indent(lines[at]):
            return False
        if _IMPORT.match(lines[above]):
            return True
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
        if _TESTED.search(head) if head.startswith(("if", "elif")) else _missing(lines, above):
            return True
        if head.startswith("if"):
            return False
    return False


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())
