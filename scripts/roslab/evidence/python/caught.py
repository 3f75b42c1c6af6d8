"""Modules without which the code goes on: wherever it imports them, a ``try`` catches what their import raises."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.indents import depth
from roslab.evidence.python.modules import Module, modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_TRY = pattern(r"try[ \t]*:")
_EXCEPT = pattern(
    r"except\b[ \t]*(?::|[^:#\n]*\b(?:ImportError|ModuleNotFoundError|Exception|BaseException|OSError|RuntimeError)\b)"
)
_STOPS = pattern(r"raise\b|(?:sys\.|os\._)?exit[ \t]*\(|quit[ \t]*\(|.*\bos\.abort[ \t]*\(")


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return each such module (``value``) at the first of its imports; tests and samples do not count."""
    found: dict[str, Mention] = {}
    needed: set[str] = set()
    for module in modules(repository):
        if places.aside(module.file.path):
            continue
        for match in module.statements:
            tops = _tops(match["module"] or match["plain"])
            if not (match["indent"] and _caught(module, match.start(), depth(match["indent"]))):
                needed.update(tops)
                continue
            line = module.text.count("\n", 0, match.start()) + 1
            for top in tops:
                said = Mention(
                    topic="caught_import", value=top, source="code", file=module.file.path, line=line, text=top
                )
                found.setdefault(top, said)
    return tuple(each for top, each in found.items() if top not in needed)


def _tops(named: str) -> list[str]:
    return [each.split()[0].partition(".")[0] for each in named.split(",") if each.strip()]


def _caught(module: Module, start: int, inside: int) -> bool:
    """Tell whether a line, ``inside`` so deep, stands in a ``try`` whose handlers go on."""
    before = module.text[:start].split("\n")[:-1]
    opens = next((line for line in reversed(before) if line.strip() and depth(line) < inside), "")
    if not _TRY.match(opens.strip()) or opens.lstrip().startswith("#"):
        return False
    least, handlers, stops = depth(opens), 0, False
    for line in module.text[start:].split("\n")[1:]:
        said = line.strip()
        if not said or said.startswith("#"):
            continue
        if depth(line) < least or (depth(line) == least and not said.startswith(("except", "else", "finally"))):
            break
        if depth(line) == least:
            handlers += bool(_EXCEPT.match(said))
        elif handlers and _STOPS.match(said):
            stops = True
    return handlers > 0 and not stops
