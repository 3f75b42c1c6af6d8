"""What stopped a compilation, on one line, and where: from the lines of compilers, CMake and linkers."""

from __future__ import annotations

from roslab.explain.answer import Explanation
from roslab.knowledge.failures import of_machine
from roslab.knowledge.repairs import repairs
from roslab.repair.asked import here, in_log
from roslab.repair.change import Given
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_COMPILER = pattern(
    r"(?m)^(?P<file>[^\s:]{1,300}):(?P<line>\d{1,6})(?::\d{1,5})?: (?:fatal )?error: (?P<said>[^\n]{1,300})"
)
_CMAKE = pattern(
    r"(?m)^CMake Error at (?P<file>\S{1,300}):(?P<line>\d{1,6}) [^\n]{0,100}:\n"
    r"(?:[ \t]{0,8}\n)?[ \t]{1,8}(?P<said>[^\n]{1,300})"
)
_LINKER = pattern(r"\b(?:undefined reference to|multiple definition of|cannot find -l)[^\n;]{1,200}")
_LONGEST = 120
_QUOTES = str.maketrans("\u2018\u2019\u201c\u201d", "''\"\"")
_AKA = pattern(r" \{aka [^}\n]{1,200}\}")


def by_machine(found: Explanation) -> bool:
    """Tell whether a step failed for the network, a server or the machine, its memory included: no code is wrong."""
    known = repairs().get(found.id or "")
    return found.id in of_machine() or (known is not None and known.way == "jobs")


def said(found: Explanation, given: Given, folder: str = "", *, whole: bool = True) -> tuple[str, Place | None]:
    """Return what stopped a step's compilation in a folder, and where; ``whole``: the step stopped nowhere else."""
    inside = f"{folder}/" if folder else ""
    for kind in (_COMPILER, _CMAKE):
        for match in kind.finditer(found.log):
            file = here(match["file"], given.files, (inside,))
            if file.startswith(inside) and file:
                known = found.cause.partition(":")[0] if kind is _CMAKE and whole else ""
                return _short(known or match["said"]), Place(file=file, line=int(match["line"]))
    if whole and (linker := next(_LINKER.finditer(found.log), None)):
        return _short(linker[0]), None
    place = in_log(found, given)
    if place and not place.file.startswith(inside):
        place = None
    return (_short(found.error) if whole and found.error else "its build ends with an error"), place


def _short(text: str) -> str:
    """Return what a compiler said on one line, in plain quotation marks and without what it adds to help."""
    plain = text.translate(_QUOTES).partition("; did you mean ")[0]
    flat = " ".join(_AKA.sub("", plain).split())
    return flat if len(flat) <= _LONGEST else f"{flat[: _LONGEST - 1]}…"
